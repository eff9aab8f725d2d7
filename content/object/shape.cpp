#include "content/object/shape.h"

#include <fmt/format.h>

#include <meshoptimizer.h>

#include <cmath>

#include "content/content_error.h"
#include "content/import/gltf/colour.h"
#include "content/import/gltf/placing.h"

namespace docent::object {
namespace {

using import::gltf::AlphaMode;
using import::gltf::entry;
using import::gltf::Model;
using import::gltf::Primitive;

/// Is there anything to see at a corner? What a mask cuts out is cut out when it is drawn.
bool is_seen(const Model& model, const ShapeVertex& v) {
  constexpr float clear = 0.35F;
  if (v.material < 0 || model.materials[entry(v.material)].alpha != AlphaMode::Blend) return true;
  return import::gltf::colour_at(model, v.material, v.uv, v.tint).w >= clear;
}

void add(const Model& model, std::int32_t node, const std::vector<Mat4>& world,
         const Primitive& primitive, Shape& shape, std::size_t& clear) {
  const import::gltf::Placing placing(model, world, node, primitive);
  const auto first = static_cast<std::uint32_t>(shape.vertices.size());
  const bool has_picture = import::gltf::has_picture(model, primitive.material);
  for (std::size_t v = 0; v < primitive.position.size(); ++v) {
    ShapeVertex& it = shape.vertices.emplace_back();
    // -0 is 0: vertices are compared by their bytes.
    it.position = Vec3(placing.at(v) * Vec4(primitive.position[v], 1)) + Vec3{0.0F};
    if (has_picture && !primitive.uv.empty()) it.uv = primitive.uv[v] + glm::vec2(0.0F);
    if (!primitive.colour.empty()) it.tint = primitive.colour[v];
    it.material = primitive.material;
  }
  for (std::size_t k = 0; k + 2 < primitive.indices.size(); k += 3) {
    const std::uint32_t a = first + primitive.indices[k], b = first + primitive.indices[k + 1],
                        c = first + primitive.indices[k + 2];
    if (is_seen(model, shape.vertices[a]) || is_seen(model, shape.vertices[b]) ||
        is_seen(model, shape.vertices[c]))
      shape.indices.insert(shape.indices.end(), {a, b, c});
    else
      ++clear;
  }
}

/// Vertices that are the same become one; those that no triangle uses go.
void weld(Shape& shape) {
  std::vector<std::uint32_t> remap(shape.vertices.size());
  const std::size_t count = meshopt_generateVertexRemap(remap.data(), shape.indices.data(),
                                                        shape.indices.size(), shape.vertices.data(),
                                                        shape.vertices.size(), sizeof(ShapeVertex));
  std::vector<ShapeVertex> welded(count);
  meshopt_remapVertexBuffer(welded.data(), shape.vertices.data(), shape.vertices.size(),
                            sizeof(ShapeVertex), remap.data());
  meshopt_remapIndexBuffer(shape.indices.data(), shape.indices.data(), shape.indices.size(),
                           remap.data());
  shape.vertices = std::move(welded);
}

}  // namespace

Box box_of(const Shape& shape) {
  Box box;
  bool is_first = true;
  for (const std::uint32_t i : shape.indices) {
    const Vec3& p = shape.vertices[i].position;
    box.low = is_first ? p : glm::min(box.low, p);
    box.high = is_first ? p : glm::max(box.high, p);
    is_first = false;
  }
  return box;
}

Shape shape_of(const Model& model, const std::string& file, std::vector<std::string>& notes) {
  Shape shape;
  std::size_t clear = 0;
  const std::vector<Mat4> world = import::gltf::world_of_nodes(model);
  import::gltf::for_each_primitive(model, [&](std::int32_t node, const Primitive& primitive) {
    add(model, node, world, primitive, shape, clear);
  });
  const auto refuse = [&](const std::string& what) {
    throw content::ContentError(file, 0, 0, "unreadable-model", what,
                                "export the object again, as GLB, OBJ, PLY or STL");
  };
  constexpr float farthest = 1e7F;
  for (const ShapeVertex& v : shape.vertices)
    for (int axis = 0; axis < 3; ++axis)
      if (!(std::abs(v.position[axis]) <= farthest))
        refuse("a node of its scene moves a vertex thousands of kilometres away");
  if (shape.indices.empty())
    refuse(clear > 0 ? "all of it is clear: there is nothing to show"
                     : "its scene holds no triangle: there is nothing to show");
  if (clear > 0)
    notes.push_back(
        fmt::format("{} clear triangle{} left out", clear, clear == 1 ? " is" : "s are"));
  weld(shape);
  return shape;
}

}  // namespace docent::object
