#include "platform/gles/extent.h"

#include <cmath>

namespace docent::gles {

Region region_of(const Extent& extent, PixelSize picture) noexcept {
  constexpr float margin = 2;
  if (extent.outside != 0) return {};
  const auto pixel = [](float clip, std::uint32_t size, float beyond) {
    const auto most = static_cast<float>(size);
    const float at = (0.5F + 0.5F * clip) * most;
    return static_cast<GLint>(
        std::clamp(beyond < 0 ? std::floor(at) + beyond : std::ceil(at) + beyond, 0.0F, most));
  };
  const bool is_whole = extent.reaches_behind_eye;
  return {is_whole ? 0 : pixel(extent.left, picture.width, -margin),
          is_whole ? 0 : pixel(extent.low, picture.height, -margin),
          pixel(is_whole ? 1 : extent.right, picture.width, margin),
          pixel(is_whole ? 1 : extent.high, picture.height, margin)};
}

}  // namespace docent::gles
