#include "runtime/model/geometry/orientation.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace docent {
namespace {

/// A number as a sum of doubles that do not overlap, smallest first (Shewchuk's expansion). Room
/// for the twelve terms of an orientation.
struct Expansion {
  std::array<double, 12> term{};
  std::size_t count = 0;

  void add(double value) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count; ++i) {  // two-sum, Knuth
      const double sum = value + term[i];
      const double virtual_part = sum - value;
      const double error = (value - (sum - virtual_part)) + (term[i] - virtual_part);
      if (error != 0) term[kept++] = error;
      value = sum;
    }
    if (value != 0) term[kept++] = value;
    count = kept;
  }
  void add_product(double a, double b) {
    const double product = a * b;
    add(std::fma(a, b, -product));
    add(product);
  }
  int sign() const { return count == 0 ? 0 : (term[count - 1] > 0 ? 1 : -1); }
};

}  // namespace

int exact_orientation(Vec2 a, Vec2 b, Vec2 c) noexcept {
  Expansion determinant;
  determinant.add_product(a.x, b.y);
  determinant.add_product(-a.x, c.y);
  determinant.add_product(-c.x, b.y);
  determinant.add_product(-a.y, b.x);
  determinant.add_product(a.y, c.x);
  determinant.add_product(c.y, b.x);
  return determinant.sign();
}

}  // namespace docent
