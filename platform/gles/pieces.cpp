#include "platform/gles/pieces.h"

#include <algorithm>
#include <numeric>

namespace docent::gles {

namespace {

/// By how many pixels more than both what covers both has; less than 0 where they overlap much.
std::int64_t waste(Region a, const Region& b) noexcept {
  const std::int64_t both = a.area() + b.area();
  a.include(b);
  return a.area() - both;
}

}  // namespace

std::size_t Pieces::nearest(const Region& region) const noexcept {
  const auto all = regions();
  return static_cast<std::size_t>(
      std::ranges::min_element(all, {}, [&](const Region& one) { return waste(one, region); }) -
      all.begin());
}

Region Pieces::take(std::size_t at) noexcept {
  const Region taken = regions_[at];
  regions_[at] = regions_[--count_];
  return taken;
}

void Pieces::add(Region region) noexcept {
  if (region.is_empty()) return;
  for (;;) {
    const std::size_t at = nearest(region);
    if (at == count_ || (count_ < most && waste(regions_[at], region) > 0)) break;
    region.include(take(at));
  }
  regions_[count_++] = region;
}

std::int64_t Pieces::area() const noexcept {
  const auto all = regions();
  return std::accumulate(all.begin(), all.end(), std::int64_t{0},
                         [](std::int64_t sum, const Region& one) { return sum + one.area(); });
}

}  // namespace docent::gles
