#include "content/object/simplify.h"

#include <algorithm>
#include <array>
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

/// Which vertices are at one place: a number for each; returns how many places there are.
std::size_t number_places(const Shape& shape, std::vector<std::uint32_t>& number) {
  std::vector<Vec3> place;
  for (const ShapeVertex& v : shape.vertices) place.push_back(v.position);
  number.resize(place.size());
  return meshopt_generateVertexRemap(number.data(), shape.indices.data(), shape.indices.size(),
                                     place.data(), place.size(), sizeof(Vec3));
}

/// Of how many triangles is the place a corner that is one of most?
std::size_t most_about_a_place(const Shape& shape) {
  std::vector<std::uint32_t> number;
  std::vector<std::size_t> about(number_places(shape, number));
  for (const std::uint32_t corner : shape.indices) ++about[number[corner]];
  return std::ranges::max(about);
}

}  // namespace

void simplify(Shape& shape, std::size_t triangles) {
  if (shape.indices.size() <= 3 * triangles) return;
  drop_repeated(shape);
  if (shape.indices.size() <= 3 * triangles) return drop_unused(shape);
  constexpr float any_error = std::numeric_limits<float>::max();
  /// Edges are collapsed in a time that grows with the square of that.
  constexpr std::size_t most_of_a_surface = 4000;
  std::vector<std::uint32_t> left = shape.indices;
  if (most_about_a_place(shape) <= most_of_a_surface)
    left.resize(meshopt_simplify(left.data(), shape.indices.data(), shape.indices.size(),
                                 &shape.vertices[0].position.x, shape.vertices.size(),
                                 sizeof(ShapeVertex), 3 * triangles, any_error, 0, nullptr));
  if (left.size() > 3 * triangles) {
    std::vector<std::uint32_t> coarse(left.size());
    coarse.resize(meshopt_simplifySloppy(coarse.data(), left.data(), left.size(),
                                         &shape.vertices[0].position.x, shape.vertices.size(),
                                         sizeof(ShapeVertex), 3 * triangles, any_error, nullptr));
    if (!coarse.empty()) left = std::move(coarse);
  }
  // A shape that no cell divides as wanted, or whose cells leave nothing, is thinned out.
  if (left.empty()) left = shape.indices;
  if (left.size() > 3 * triangles) left.resize(3 * triangles);
  shape.indices = std::move(left);
  keep_one_material(shape);
  drop_unused(shape);
}

void drop_repeated(Shape& shape) {
  std::vector<std::uint32_t> number;
  number_places(shape, number);
  std::vector<std::array<std::uint32_t, 4>> triangles;  // three places, and which it is
  for (std::uint32_t k = 0; k + 2 < shape.indices.size(); k += 3) {
    std::array<std::uint32_t, 3> at{number[shape.indices[k]], number[shape.indices[k + 1]],
                                    number[shape.indices[k + 2]]};
    std::ranges::rotate(at, std::ranges::min_element(at));
    triangles.push_back({at[0], at[1], at[2], k});
  }
  std::ranges::sort(triangles);
  const auto corners = [](const auto& triangle) {
    return std::array{triangle[0], triangle[1], triangle[2]};
  };
  triangles.erase(std::ranges::unique(triangles, {}, corners).begin(), triangles.end());
  std::ranges::sort(triangles, {}, [](const auto& triangle) { return triangle[3]; });
  std::vector<std::uint32_t> left;
  left.reserve(3 * triangles.size());
  for (const auto& triangle : triangles)
    for (std::uint32_t c = 0; c < 3; ++c) left.push_back(shape.indices[triangle[3] + c]);
  shape.indices = std::move(left);
}

Shape without_seams(const Shape& shape) {
  std::vector<std::uint32_t> remap;
  const std::size_t count = number_places(shape, remap);
  Shape welded;
  welded.vertices.resize(count);
  for (std::size_t v = remap.size(); v-- > 0;)
    if (remap[v] < count) welded.vertices[remap[v]] = shape.vertices[v];
  for (std::size_t k = 0; k + 2 < shape.indices.size(); k += 3) {
    const std::uint32_t a = remap[shape.indices[k]], b = remap[shape.indices[k + 1]],
                        c = remap[shape.indices[k + 2]];
    if (a != b && b != c && c != a) welded.indices.insert(welded.indices.end(), {a, b, c});
  }
  return welded;
}

}  // namespace docent::object
