#include "content/object/crease.h"

#include <meshoptimizer.h>

#include <array>
#include <cmath>
#include <map>
#include <utility>

#include <glm/geometric.hpp>

namespace docent::object {
namespace {

/// Which faces meet at each place, in lists one after another.
struct Meetings {
  std::vector<std::uint32_t> place_of;  ///< By vertex.
  std::vector<std::uint32_t> first, face;
};

Meetings meetings_of(const Shape& shape) {
  std::vector<Vec3> position;
  for (const ShapeVertex& v : shape.vertices) position.push_back(v.position);
  Meetings meetings;
  meetings.place_of.resize(position.size());
  const std::size_t places =
      meshopt_generateVertexRemap(meetings.place_of.data(), nullptr, position.size(),
                                  position.data(), position.size(), sizeof(Vec3));
  meetings.first.assign(places + 1, 0);
  for (const std::uint32_t v : shape.indices) ++meetings.first[meetings.place_of[v] + 1];
  for (std::size_t i = 0; i < places; ++i) meetings.first[i + 1] += meetings.first[i];
  meetings.face.resize(shape.indices.size());
  std::vector<std::uint32_t> next(meetings.first.begin(), meetings.first.end() - 1);
  for (std::size_t k = 0; k < shape.indices.size(); ++k)
    meetings.face[next[meetings.place_of[shape.indices[k]]]++] = static_cast<std::uint32_t>(k / 3);
  return meetings;
}

Vec3 unit_or(Vec3 v, Vec3 otherwise) {
  const float length = glm::length(v);
  return length > 1e-20F && std::isfinite(length) ? v / length : otherwise;
}

}  // namespace

std::vector<Vec3> crease(Shape& shape, float crease) {
  const float sharpest = std::cos(crease);
  constexpr std::uint32_t most_looked_at = 64;
  std::vector<Vec3> across, normal;
  const float scale = 1 / std::max(1e-6F, glm::length(box_of(shape).size()));
  for (std::size_t k = 0; k + 2 < shape.indices.size(); k += 3) {
    const Vec3 a = scale * shape.vertices[shape.indices[k]].position;
    across.push_back(glm::cross(scale * shape.vertices[shape.indices[k + 1]].position - a,
                                scale * shape.vertices[shape.indices[k + 2]].position - a));
    normal.push_back(unit_or(across.back(), Vec3{0}));
  }
  const Meetings meetings = meetings_of(shape);
  Shape creased;
  std::vector<Vec3> normals;
  std::map<std::pair<std::uint32_t, std::array<int, 3>>, std::uint32_t> made;
  for (std::size_t k = 0; k < shape.indices.size(); ++k) {
    const std::uint32_t vertex = shape.indices[k], place = meetings.place_of[vertex];
    const std::uint32_t begin = meetings.first[place], end = meetings.first[place + 1];
    Vec3 sum{0};
    for (std::uint32_t m = begin; m < end; ++m)
      if (end - begin > most_looked_at ||
          glm::dot(normal[k / 3], normal[meetings.face[m]]) >= sharpest)
        sum += across[meetings.face[m]];
    const Vec3 n = unit_or(sum, unit_or(normal[k / 3], Vec3{0, 1, 0}));
    constexpr float fine = 64;
    const std::array<int, 3> rounded{static_cast<int>(std::lround(n.x * fine)),
                                     static_cast<int>(std::lround(n.y * fine)),
                                     static_cast<int>(std::lround(n.z * fine))};
    const auto [known, is_new] = made.emplace(std::pair(vertex, rounded),
                                              static_cast<std::uint32_t>(creased.vertices.size()));
    if (is_new) {
      creased.vertices.push_back(shape.vertices[vertex]);
      normals.push_back(n);
    }
    creased.indices.push_back(known->second);
  }
  shape = std::move(creased);
  return normals;
}

}  // namespace docent::object
