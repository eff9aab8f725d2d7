#include "content/floor/crossings.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace docent::floor {
namespace {

constexpr std::size_t most_judged = 400;

struct NumberedSide {
  Vec2 a, b;
  std::uint32_t ring, side;
};

std::vector<NumberedSide> sides_of(std::span<const OverlayRing> rings) {
  std::vector<NumberedSide> sides;
  for (std::uint32_t r = 0; r < rings.size(); ++r) {
    const std::vector<Vec2>& vertex = rings[r].vertex;
    for (std::uint32_t i = 0; i < vertex.size(); ++i)
      sides.push_back({vertex[i], vertex[(i + 1) % vertex.size()], r, i});
  }
  return sides;
}

/// Are the ends of the one on either side of the other?
bool parts(const NumberedSide& line, const NumberedSide& other) {
  const Vec2 along = line.b - line.a;
  return cross(along, other.a - line.a) * cross(along, other.b - line.a) < 0;
}

}  // namespace

Crossings estimate_crossings(std::span<const OverlayRing> rings) {
  const std::vector<NumberedSide> sides = sides_of(rings);
  const std::size_t judged = std::min(sides.size(), most_judged);
  Crossings found;
  std::size_t ends = 0;
  for (std::size_t i = 0; i < judged; ++i) {
    // In step with no pattern of the drawing.
    const double share = std::fmod(static_cast<double>(i) * std::numbers::phi, 1.0);
    const std::size_t picked =
        judged == sides.size()
            ? i
            : static_cast<std::size_t>(share * static_cast<double>(sides.size()));
    const NumberedSide& side = sides[picked];
    const auto crossed =
        static_cast<std::size_t>(std::ranges::count_if(sides, [&](const NumberedSide& other) {
          return parts(side, other) && parts(other, side);
        }));
    ends += crossed;
    if (crossed > found.of_that_side)
      found.ring = side.ring, found.side = side.side, found.of_that_side = crossed;
  }
  if (judged > 0)
    found.count = static_cast<double>(ends) / 2 * static_cast<double>(sides.size()) /
                  static_cast<double>(judged);
  return found;
}

}  // namespace docent::floor
