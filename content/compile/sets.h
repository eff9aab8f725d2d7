#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace docent::compile {

/// Sets of numbers that grow together.
class Sets {
 public:
  explicit Sets(std::size_t count) : of_(count) { std::iota(of_.begin(), of_.end(), 0U); }

  std::uint32_t of(std::uint32_t i) {
    while (of_[i] != i) i = of_[i] = of_[of_[i]];
    return i;
  }
  /// The second set becomes part of the first, which keeps its number.
  void join(std::uint32_t set, std::uint32_t other) { of_[other] = set; }
  void leave(std::uint32_t i) { of_[i] = i; }

 private:
  std::vector<std::uint32_t> of_;
};

}  // namespace docent::compile
