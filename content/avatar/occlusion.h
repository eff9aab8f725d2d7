#pragma once

#include <cstdint>
#include <vector>

#include "content/avatar/layers.h"

namespace docent::avatar {

/// How much of the sky a point of the body sees past the rest of the body, from the distances met
/// along a few rays over it (Evans 2006, "Fast approximations for global illumination on dynamic
/// scenes"). Distances are sampled once on a coarse grid, since light is soft.
class Occlusion {
 public:
  /// `cell` is the grid's, metres.
  Occlusion(const std::vector<Layer>& layers, const Box3& box, float cell);

  /// 255 where all of it is seen; 64 where nothing is, since creases never go quite black.
  /// Fine creases of the layer itself, which the grid is too coarse for, count too.
  std::uint8_t at(const Layer& layer, Vec3 p, Vec3 normal) const;

 private:
  float distance(Vec3 p) const;

  Vec3 low_;
  float cell_;
  std::array<std::size_t, 3> nodes_{};
  std::vector<float> value_;
};

}  // namespace docent::avatar
