#pragma once

#include <algorithm>
#include <cstddef>

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

}  // namespace docent
