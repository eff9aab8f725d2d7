#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "runtime/model/motion/skinned_mesh.h"
#include "runtime/model/pixels.h"

namespace docent::character {

/// A picture that figures are painted into: soft light from the upper left on a pale ground.
/// Everything is seen from afar (orthographic), a little from above.
class Painting {
 public:
  Painting(std::uint32_t width, std::uint32_t height);

  /// Where a figure stands in the picture and how it is seen.
  struct View {
    float x = 0, floor = 0;  ///< Pixels: its middle, and the floor's line.
    float scale = 100;       ///< Pixels of a metre.
    float yaw = 0;           ///< Radians: 0 sees its face, a quarter its left side.
    Vec3 middle{0};          ///< World, metres: what stands at x on the floor.
  };
  /// Paints a body of this palette (world transform times inverse bind, one a joint).
  void add(const SkinnedMesh& body, std::span<const Mat4> palette, const View& view);

  /// The picture, four samples a pixel.
  Pixels picture() const;

 private:
  struct Corner {
    Vec3 at;      ///< Samples; z towards the eye, metres.
    Vec3 colour;  ///< Linear, lit.
  };
  void fill(const Corner& a, const Corner& b, const Corner& c);
  void shade_floor(const View& view);

  std::uint32_t width_, height_;  ///< Samples.
  std::vector<Vec3> colour_;
  std::vector<float> depth_;
};

}  // namespace docent::character
