#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "content/object/shape.h"
#include "runtime/model/exhibit/object.h"

namespace docent::object {

/// A shape that is ready: with normals and its own shade, one each a vertex.
struct LitShape {
  Shape shape;
  std::vector<Vec3> normals;
  std::vector<std::uint8_t> occlusion;
};

/// The mesh as texture memory takes it, with a vertex's whole colour, for a distance at which
/// nobody sees its pictures. At most 65,536 vertices.
ObjectMesh pack_distant(const LitShape& lit, const import::gltf::Model& model, const Box& box);

/// Likewise with pictures, so small that all of it takes at most ExhibitObject::most_bytes.
/// ContentError (`unreadable-model`) where a picture cannot be written.
ObjectDetail pack_detail(const LitShape& lit, const import::gltf::Model& model, const Box& box,
                         const std::string& file);

/// A unit vector on the octahedron.
std::array<std::int8_t, 2> octahedral(Vec3 unit);

}  // namespace docent::object
