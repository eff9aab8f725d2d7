#include "platform/gles/body.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace docent::gles {
namespace {

/// A vertex as it lies in texture memory, in little more than half of the room.
struct DrawnVertex {
  std::array<std::int16_t, 3> position{};  ///< In 32,767ths of `most_from_origin`.
  Material material = Material::Skin;
  std::uint8_t occlusion = 255;
  std::uint32_t normal = 0;  ///< Three tens of bits, as OpenGL has them.
  std::array<std::uint8_t, 4> joint{}, weight{};
};
static_assert(sizeof(DrawnVertex) == 20);

/// Metres from the origin, along an axis, that a body has its vertices in; skin.glsl has it too.
/// The steps are an eighth of a millimetre.
constexpr float most_from_origin = 4;

std::int32_t whole(float share, float most) noexcept {
  return static_cast<std::int32_t>(std::lround(std::clamp(share, -1.0F, 1.0F) * most));
}

std::uint32_t packed_normal(Vec3 normal) noexcept {
  const auto bits = [&](float part) {
    return static_cast<std::uint32_t>(whole(part, 511)) & 0x3FFU;
  };
  return bits(normal.x) | bits(normal.y) << 10U | bits(normal.z) << 20U;
}

std::vector<DrawnVertex> drawn_vertices(const std::vector<SkinnedVertex>& vertices) {
  std::vector<DrawnVertex> drawn;
  drawn.reserve(vertices.size());
  for (const SkinnedVertex& v : vertices) {
    const auto place = [](float metres) {
      return static_cast<std::int16_t>(whole(metres / most_from_origin, 32767));
    };
    drawn.push_back({.position = {place(v.position.x), place(v.position.y), place(v.position.z)},
                     .material = v.material,
                     .occlusion = v.occlusion,
                     .normal = packed_normal(v.normal),
                     .joint = v.joint,
                     .weight = v.weight});
  }
  return drawn;
}

void describe_drawn_vertices() noexcept {
  constexpr auto stride = static_cast<GLsizei>(sizeof(DrawnVertex));
  for (GLuint i = 0; i < 6; ++i) glEnableVertexAttribArray(i);
  glVertexAttribPointer(0, 3, GL_SHORT, GL_TRUE, stride,
                        buffer_offset(offsetof(DrawnVertex, position)));
  glVertexAttribPointer(1, 4, GL_INT_2_10_10_10_REV, GL_TRUE, stride,
                        buffer_offset(offsetof(DrawnVertex, normal)));
  glVertexAttribIPointer(2, 4, GL_UNSIGNED_BYTE, stride,
                         buffer_offset(offsetof(DrawnVertex, joint)));
  glVertexAttribPointer(3, 4, GL_UNSIGNED_BYTE, GL_TRUE, stride,
                        buffer_offset(offsetof(DrawnVertex, weight)));
  glVertexAttribIPointer(4, 1, GL_UNSIGNED_BYTE, stride,
                         buffer_offset(offsetof(DrawnVertex, material)));
  glVertexAttribPointer(5, 1, GL_UNSIGNED_BYTE, GL_TRUE, stride,
                        buffer_offset(offsetof(DrawnVertex, occlusion)));
}

/// Colours of all vertices, since those of one draw share their places: black but for the last.
std::vector<std::array<std::uint8_t, 4>> drawn_colours(const SkinnedMesh& mesh) {
  std::vector<std::array<std::uint8_t, 4>> drawn(mesh.vertices.size());
  const std::size_t first = drawn.size() - std::min(drawn.size(), mesh.colour.size());
  for (std::size_t v = first; v < drawn.size(); ++v) {
    const VertexColour& c = mesh.colour[v - first];
    drawn[v] = {c[0], c[1], c[2], 255};
  }
  return drawn;
}

GlBuffer upload_colours(const SkinnedMesh& mesh) {
  GlBuffer buffer = make_buffer();
  glBindBuffer(GL_ARRAY_BUFFER, buffer.get());
  const auto drawn = drawn_colours(mesh);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(drawn.size() * sizeof(drawn[0])),
               drawn.data(), GL_STATIC_DRAW);
  glEnableVertexAttribArray(6);
  glVertexAttribPointer(6, 4, GL_UNSIGNED_BYTE, GL_TRUE, 0, buffer_offset(0));
  return buffer;
}

/// Where joints and nodes of cloth are in a body's rest pose, in the order of its matrices.
std::vector<Vec3> carriers_of(const SkinnedMesh& mesh, std::size_t figure) {
  const std::size_t joints = joints_of(mesh);
  const std::size_t first = has_own_body(mesh) ? figure * joints : 0;
  std::vector<Vec3> place;
  for (std::size_t j = 0; j < joints; ++j)
    place.emplace_back(glm::inverse(mesh.inverse_bind[first + j])[3]);
  for (const ClothNode& node : of_figure(mesh.cloth.node, figure)) place.push_back(node.place);
  return place;
}

/// A vertex is where its joints would carry it, in proportion to their weights.
float reach_of(const SkinnedVertex& vertex, std::span<const Vec3> joints_at) noexcept {
  float all = 0;
  for (std::size_t k = 0; k < vertex.joint.size(); ++k)
    if (vertex.weight[k] > 0 && vertex.joint[k] < joints_at.size())
      all += static_cast<float>(vertex.weight[k]) / 255 *
             glm::length(vertex.position - joints_at[vertex.joint[k]]);
  return all;
}

std::vector<float> reaches_of(const SkinnedMesh& mesh) {
  std::vector<float> reach;
  std::uint32_t first = 0;
  for (const std::uint32_t end : mesh.figure_end) {
    const std::vector<Vec3> joints_at = carriers_of(mesh, reach.size());
    float most = 0;
    for (std::uint32_t i = first; i < end; ++i)
      most = std::max(most, reach_of(mesh.vertices[mesh.indices[i]], joints_at));
    reach.push_back(most);
    first = end;
  }
  return reach;
}

template <typename Index>
void upload_indices(const std::vector<Index>& indices) noexcept {
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(Index)),
               indices.data(), GL_STATIC_DRAW);
}

}  // namespace

Body make_body(const SkinnedMesh& mesh, const scene::BodyLevels& levels) {
  Body body;
  body.matrices = matrices_of(mesh);
  body.has_own = has_own_body(mesh);
  body.figure = levels.figure;
  body.reach = reaches_of(mesh);
  body.array = make_vertex_array();
  glBindVertexArray(body.array.get());
  body.vertices = make_buffer();
  glBindBuffer(GL_ARRAY_BUFFER, body.vertices.get());
  const std::vector<DrawnVertex> drawn = drawn_vertices(mesh.vertices);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(drawn.size() * sizeof(DrawnVertex)),
               drawn.data(), GL_STATIC_DRAW);
  describe_drawn_vertices();
  if (body.has_own) body.colours = upload_colours(mesh);
  body.indices = make_buffer();
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, body.indices.get());
  if (mesh.vertices.size() <= 0x10000) {
    upload_indices(std::vector<std::uint16_t>(levels.indices.begin(), levels.indices.end()));
  } else {
    body.index_type = GL_UNSIGNED_INT;
    upload_indices(levels.indices);
  }
  glBindVertexArray(0);
  return body;
}

}  // namespace docent::gles
