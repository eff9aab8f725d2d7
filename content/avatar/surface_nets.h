#pragma once

#include <cstdint>
#include <vector>

#include "content/avatar/distance_field.h"

namespace docent::avatar {

/// Model frame, metres.
struct Box3 {
  Vec3 low, high;
};

/// A closed surface of triangles, counter-clockwise seen from outside. Model frame, metres.
struct TriangleSurface {
  std::vector<Vec3> position;
  std::vector<std::uint32_t> indices;
};

/// The zero surface of `field` inside `box`, with one vertex per cell that it crosses (Gibson 1998,
/// surface nets), each pulled onto the surface along the gradient. The surface must lie inside the
/// box. `cell` is the edge of a cell in metres and about the edge of a triangle.
TriangleSurface polygonise(const DistanceField& field, const Box3& box, float cell);

/// Unit gradient of the field by central differences over `step` metres.
Vec3 gradient_of(const DistanceField& field, Vec3 p, float step);

}  // namespace docent::avatar
