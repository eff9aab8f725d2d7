#pragma once

#include <vector>

#include "content/avatar/skin_weights.h"
#include "content/avatar/surface_nets.h"

namespace docent::avatar {

/// A part of the avatar that is polygonised by itself: one material, one way to follow the joints.
/// Layers overlap and hide each other, as clothes do, so that the edge between two materials is as
/// sharp as the meeting of two surfaces.
struct Layer {
  Material material = Material::Coat;
  BodyRegion region = BodyRegion::Coat;
  DistanceField solid{};
  Box3 box{};
  float cell = 0.02F;           ///< Metres: the finest detail.
  float error = 0.0005F;        ///< Metres that simplification may take off or put on.
  std::size_t triangles = 500;  ///< That simplification leaves, unless the error allows more.
  /// How simplification sees a place: it keeps what is magnified finer, and divides what is bent.
  /// May be empty.
  std::function<Vec3(Vec3)> lens{};
  /// A solid of the layers above this one: what lies deep inside it is covered and left out. May be
  /// empty.
  DistanceField covered{};
};

/// All layers of a body, which must outlive them.
std::vector<Layer> layers_of(const BodyShape& body);

}  // namespace docent::avatar
