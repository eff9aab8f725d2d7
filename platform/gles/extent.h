#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "platform/display.h"
#include "platform/gles/gl_names.h"
#include "runtime/model/geometry/vec2.h"
#include "runtime/scene/draw_list.h"

namespace docent::gles {

/// What of the picture the hull of some points may cover, in clip space; of no points: nothing.
struct Extent {
  float left = 1, right = -1;
  float low = 1, high = -1;
  unsigned outside = 0b11111;  ///< Planes of the view that all points are beyond.
  bool reaches_behind_eye = false;

  void include(const Mat4& to_clip, Vec3 point) noexcept {
    const Vec4 clip = to_clip * Vec4(point, 1);
    left = std::min(left, clip.x / clip.w);
    right = std::max(right, clip.x / clip.w);
    low = std::min(low, clip.y / clip.w);
    high = std::max(high, clip.y / clip.w);
    reaches_behind_eye = reaches_behind_eye || clip.w <= 0.01F;
    unsigned beyond = 0;
    for (const bool plane :
         {clip.x<-clip.w, clip.x> clip.w, clip.y<-clip.w, clip.y> clip.w, clip.w <= 0.01F})
      beyond = beyond << 1 | (plane ? 1U : 0U);
    outside &= beyond;
  }
};

/// A part of a picture, in pixels; y runs up.
struct Region {
  GLint left = 0, low = 0, right = 0, high = 0;

  bool is_empty() const noexcept { return left >= right || low >= high; }
  bool overlaps(const Region& other) const noexcept {
    return !is_empty() && !other.is_empty() && left < other.right && other.left < right &&
           low < other.high && other.low < high;
  }
  std::int64_t area() const noexcept {
    return is_empty() ? 0 : std::int64_t{right - left} * (high - low);
  }
  void include(const Region& other) noexcept {
    if (other.is_empty()) return;
    *this = is_empty() ? other
                       : Region{std::min(left, other.left), std::min(low, other.low),
                                std::max(right, other.right), std::max(high, other.high)};
  }
};

/// What lies in both.
constexpr Region common(const Region& a, const Region& b) noexcept {
  return {std::max(a.left, b.left), std::max(a.low, b.low), std::min(a.right, b.right),
          std::min(a.high, b.high)};
}

/// What of a region lies beside another one: to its left and right, below and above.
std::array<Region, 4> beside(const Region& other, const Region& region) noexcept;

/// A picture of this share of the lines and columns; never without pixels.
PixelSize scaled(PixelSize size, float share) noexcept;

/// A part of a picture as it lies in one of another size: all pixels that any of it is in, and
/// those beside them.
Region scaled(const Region& part, PixelSize from, PixelSize to) noexcept;

/// Where the extent lies in a picture, and two pixels about it: edges are soft, and texts lie on
/// whole pixels.
Region region_of(const Extent& extent, PixelSize picture) noexcept;

/// Where a rectangle of the interface lies; of one without width: nowhere.
Extent extent_of(const scene::Rect& rect) noexcept;

/// The pixels that nothing is seen through of a rectangle of the interface.
Region region_behind(const scene::Quad& quad, PixelSize picture) noexcept;

}  // namespace docent::gles
