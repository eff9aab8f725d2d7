#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "runtime/model/museum.h"

namespace docent {

/// Each has a texture for itself as long as the museum is shown.
inline constexpr std::size_t most_scenery_images = 12'000;

/// Past the last of Museum::images that the model shows: one only leafs to those that follow, as a
/// rule.
[[nodiscard]] inline std::size_t scenery_images(const Museum& museum) noexcept {
  std::size_t end = 0;
  for (const Exhibit& exhibit : museum.exhibits)
    end = std::max<std::size_t>(end, exhibit.image + std::size_t{1});
  return std::min(end, museum.images.size());
}

/// Pixels, of the longest side of each. A picture on a wall of the model is seldom larger on the
/// screen, and never what one looks at. Where there are very many, each is smaller, so that
/// together they take no more than 40 MB.
[[nodiscard]] inline std::uint32_t scenery_image_side(std::size_t images) noexcept {
  constexpr double largest = 144, at_its_largest = 360;
  const double share = std::min(1.0, at_its_largest / static_cast<double>(images));
  return static_cast<std::uint32_t>(std::ceil(largest * std::sqrt(share)));
}

}  // namespace docent
