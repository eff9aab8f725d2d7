#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "platform/gles/extent.h"

namespace docent::gles {

/// A few regions that cover all that was added to them, and little else. They may overlap: two are
/// one only where that has no more pixels than both.
class Pieces {
 public:
  static constexpr std::size_t most = 16;

  void add(Region region) noexcept;
  std::span<const Region> regions() const noexcept { return {regions_.data(), count_}; }
  std::int64_t area() const noexcept;  ///< Pixels of each, one after the other.

 private:
  Region take(std::size_t at) noexcept;
  /// Which of them has the fewest pixels more together with `region` than both have; count_: none.
  std::size_t nearest(const Region& region) const noexcept;

  std::array<Region, most> regions_{};
  std::size_t count_ = 0;
};

}  // namespace docent::gles
