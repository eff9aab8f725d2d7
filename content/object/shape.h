#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "content/import/gltf/model.h"

namespace docent::object {

/// A vertex of an object as it was modelled. Two that share a place are one only where all of it is
/// the same.
struct ShapeVertex {
  Vec3 position{};
  glm::vec2 uv{0};
  Vec4 tint{1};  ///< The vertex's own colour, linear, with opacity.
  std::int32_t material = import::gltf::none;
  bool operator==(const ShapeVertex&) const = default;
};
static_assert(sizeof(ShapeVertex) == 40, "no padding: vertices are compared by their bytes");

struct Shape {
  std::vector<ShapeVertex> vertices;
  std::vector<std::uint32_t> indices;  ///< Triangles, each of one material.
};

struct Box {
  Vec3 low{0}, high{0};
  Vec3 size() const noexcept { return high - low; }
};
/// Of all vertices that triangles use.
Box box_of(const Shape& shape);

/// All triangles of the scene in its frame, without what is clear. ContentError
/// (`unreadable-model`) about `file` where nothing is left, or a vertex is nowhere.
Shape shape_of(const import::gltf::Model& model, const std::string& file,
               std::vector<std::string>& notes);

}  // namespace docent::object
