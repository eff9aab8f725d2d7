#include "content/object/simplify.h"

#include <limits>

#include <meshoptimizer.h>

namespace docent::object {
namespace {

void drop_unused(Shape& shape) {
  std::vector<ShapeVertex> used(shape.vertices.size());
  used.resize(meshopt_optimizeVertexFetch(used.data(), shape.indices.data(), shape.indices.size(),
                                          shape.vertices.data(), shape.vertices.size(),
                                          sizeof(ShapeVertex)));
  shape.vertices = std::move(used);
}

/// Each triangle keeps one material: where a cell joins corners of several, the first decides.
void keep_one_material(Shape& shape) {
  std::vector<ShapeVertex> vertices;
  for (std::size_t k = 0; k + 2 < shape.indices.size(); k += 3) {
    const std::int32_t material = shape.vertices[shape.indices[k]].material;
    for (std::size_t c = 0; c < 3; ++c) {
      std::uint32_t& corner = shape.indices[k + c];
      if (shape.vertices[corner].material == material) continue;
      ShapeVertex other = shape.vertices[corner];
      other.material = material;
      other.uv = shape.vertices[shape.indices[k]].uv;
      corner = static_cast<std::uint32_t>(shape.vertices.size());
      shape.vertices.push_back(other);
    }
  }
}

}  // namespace

void simplify(Shape& shape, std::size_t triangles) {
  if (shape.indices.size() <= 3 * triangles) return;
  constexpr float any_error = std::numeric_limits<float>::max();
  std::vector<std::uint32_t> left(shape.indices.size());
  left.resize(meshopt_simplify(left.data(), shape.indices.data(), shape.indices.size(),
                               &shape.vertices[0].position.x, shape.vertices.size(),
                               sizeof(ShapeVertex), 3 * triangles, any_error, 0, nullptr));
  if (left.size() > 3 * triangles) {
    std::vector<std::uint32_t> coarse(left.size());
    coarse.resize(meshopt_simplifySloppy(coarse.data(), left.data(), left.size(),
                                         &shape.vertices[0].position.x, shape.vertices.size(),
                                         sizeof(ShapeVertex), 3 * triangles, any_error, nullptr));
    left = std::move(coarse);
  }
  // A shape that no cell divides as wanted is thinned out.
  if (left.size() > 3 * triangles) left.resize(3 * triangles);
  if (!left.empty()) shape.indices = std::move(left);
  keep_one_material(shape);
  drop_unused(shape);
}

Shape without_seams(const Shape& shape) {
  std::vector<Vec3> place;
  for (const ShapeVertex& v : shape.vertices) place.push_back(v.position);
  std::vector<std::uint32_t> remap(place.size());
  const std::size_t count =
      meshopt_generateVertexRemap(remap.data(), shape.indices.data(), shape.indices.size(),
                                  place.data(), place.size(), sizeof(Vec3));
  Shape welded;
  welded.vertices.resize(count);
  for (std::size_t v = place.size(); v-- > 0;)
    if (remap[v] < count) welded.vertices[remap[v]] = shape.vertices[v];
  for (std::size_t k = 0; k + 2 < shape.indices.size(); k += 3) {
    const std::uint32_t a = remap[shape.indices[k]], b = remap[shape.indices[k + 1]],
                        c = remap[shape.indices[k + 2]];
    if (a != b && b != c && c != a) welded.indices.insert(welded.indices.end(), {a, b, c});
  }
  return welded;
}

}  // namespace docent::object
