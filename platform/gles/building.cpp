#include "platform/gles/building.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "platform/gles/program.h"

namespace docent::gles {
namespace {

void make_lightmap(const Scenery& scenery, Building& building) noexcept {
  building.lightmap = make_texture();
  bind_texture(static_cast<GLuint>(Unit::LightMap), building.lightmap.get());
  glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGB8, static_cast<GLsizei>(scenery.lightmap_width),
                 static_cast<GLsizei>(scenery.lightmap_height));
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
}

float height_of_floor(const Scenery& scenery) noexcept {
  for (const SceneryPart& part : scenery.parts)
    if (part.surface == Surface::Floor || part.surface == Surface::Stone)
      return scenery.vertices[scenery.indices[part.first_index]].position.y;
  return 0;
}

/// Where a buffer is bound to be filled: no array of vertices that a pass left bound knows of it.
constexpr GLenum carrier = GL_COPY_WRITE_BUFFER;

void make_geometry(const Scenery& scenery, Building& building) noexcept {
  const auto allocate = [](const auto& values) {
    GlBuffer buffer = make_buffer();
    glBindBuffer(carrier, buffer.get());
    glBufferData(carrier, static_cast<GLsizeiptr>(std::as_bytes(std::span(values)).size()), nullptr,
                 GL_STATIC_DRAW);
    return buffer;
  };
  building.vertices = allocate(scenery.vertices);
  building.indices = allocate(scenery.indices);
}

void begin(Building& building, const Scenery& scenery, std::span<const scene::TextureId> image_of) {
  building.image_of.assign(image_of.begin(), image_of.end());
  building.scenery.parts = scenery.parts;
  building.hangs.assign(image_of.size(), false);
  for (const SceneryPart& part : scenery.parts)
    if (part.surface == Surface::Frame && part.exhibit >= 0 &&
        static_cast<std::size_t>(part.exhibit) < building.hangs.size())
      building.hangs[static_cast<std::size_t>(part.exhibit)] = true;
  building.scenery.lightmap_min = scenery.lightmap_min;
  building.scenery.lightmap_max = scenery.lightmap_max;
  building.scenery.sun = scenery.sun;
  if (scenery.vertices.empty()) return;
  building.floor_height = height_of_floor(scenery);
  make_geometry(scenery, building);
  make_lightmap(scenery, building);
}

/// What lies in texture memory one after another: bytes of the vertices, of the indices, and rows
/// of the lightmap.
struct Bytes {
  explicit Bytes(const Scenery& scenery)
      : vertices(std::as_bytes(std::span(scenery.vertices))),
        indices(std::as_bytes(std::span(scenery.indices))),
        lightmap(scenery.lightmap) {}
  [[nodiscard]] std::size_t count() const {
    return vertices.size() + indices.size() + lightmap.size();
  }
  std::span<const std::byte> vertices, indices, lightmap;
};

void carry_buffer(const GlBuffer& buffer, std::span<const std::byte> bytes, std::size_t from,
                  std::size_t count) noexcept {
  glBindBuffer(carrier, buffer.get());
  glBufferSubData(carrier, static_cast<GLintptr>(from), static_cast<GLsizeiptr>(count),
                  bytes.data() + from);
}

void carry_rows(const Building& building, const Scenery& scenery, std::size_t from,
                std::size_t count) noexcept {
  const std::size_t row = std::size_t{scenery.lightmap_width} * Scenery::lightmap_channels;
  bind_texture(static_cast<GLuint>(Unit::LightMap), building.lightmap.get());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, static_cast<GLint>(from / row),
                  static_cast<GLsizei>(scenery.lightmap_width), static_cast<GLsizei>(count / row),
                  GL_RGB, GL_UNSIGNED_BYTE, scenery.lightmap.data() + from);
}

/// Carries at most `most` of the bytes from `from` on, all of one kind; returns how many.
std::size_t carry_some(const Building& building, const Scenery& scenery, std::size_t from,
                       std::size_t most) noexcept {
  const Bytes bytes(scenery);
  if (from < bytes.vertices.size()) {
    most = std::min(most, bytes.vertices.size() - from);
    carry_buffer(building.vertices, bytes.vertices, from, most);
    return most;
  }
  from -= bytes.vertices.size();
  if (from < bytes.indices.size()) {
    most = std::min(most, bytes.indices.size() - from);
    carry_buffer(building.indices, bytes.indices, from, most);
    return most;
  }
  from -= bytes.indices.size();
  const std::size_t row = std::size_t{scenery.lightmap_width} * Scenery::lightmap_channels;
  most = std::min(std::max(most - most % row, row), bytes.lightmap.size() - from);
  carry_rows(building, scenery, from, most);
  return most;
}

void describe_geometry(Building& building) noexcept {
  building.array = make_vertex_array();
  glBindVertexArray(building.array.get());
  glBindBuffer(GL_ARRAY_BUFFER, building.vertices.get());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, building.indices.get());
  describe_scenery_vertices();
  glBindVertexArray(0);
}

}  // namespace

void describe_scenery_vertices() noexcept {
  constexpr auto stride = static_cast<GLsizei>(sizeof(SceneryVertex));
  const auto floats = [&](GLuint index, GLint count, std::size_t offset) {
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, count, GL_FLOAT, GL_FALSE, stride, buffer_offset(offset));
  };
  floats(0, 3, offsetof(SceneryVertex, position));
  floats(1, 3, offsetof(SceneryVertex, normal));
  floats(2, 2, offsetof(SceneryVertex, uv));
  static_assert(offsetof(SceneryVertex, sun) == offsetof(SceneryVertex, sky) + 1);
  glEnableVertexAttribArray(3);
  glVertexAttribPointer(3, 2, GL_UNSIGNED_BYTE, GL_TRUE, stride,
                        buffer_offset(offsetof(SceneryVertex, sky)));
}

bool carry_on(Building& building, const Scenery& scenery,
              std::span<const scene::TextureId> image_of) {
  constexpr std::size_t at_a_time = std::size_t{1} << 20U;
  const std::size_t all = scenery.vertices.empty() ? 0 : Bytes(scenery).count();
  if (building.carried == 0) begin(building, scenery, image_of);
  if (building.carried < all)
    building.carried += carry_some(building, scenery, building.carried, at_a_time);
  if (building.carried < all) return true;
  if (all > 0) describe_geometry(building);
  return false;
}

}  // namespace docent::gles
