#include "platform/gles/object_shape.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "platform/gles/program.h"

namespace docent::gles {
namespace {

GLint wrap_of(ObjectWrap wrap) noexcept {
  switch (wrap) {
    case ObjectWrap::Clamp:
      return GL_CLAMP_TO_EDGE;
    case ObjectWrap::Mirror:
      return GL_MIRRORED_REPEAT;
    case ObjectWrap::Repeat:
      break;
  }
  return GL_REPEAT;
}

void describe_vertices() noexcept {
  constexpr auto stride = static_cast<GLsizei>(sizeof(ObjectVertex));
  static_assert(sizeof(ObjectVertex) == 16);
  static_assert(offsetof(ObjectVertex, occlusion) == offsetof(ObjectVertex, colour) + 3);
  const auto attribute = [&](GLuint index, GLint count, GLenum type, std::size_t offset) {
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, count, type, GL_TRUE, stride, buffer_offset(offset));
  };
  attribute(0, 3, GL_UNSIGNED_SHORT, offsetof(ObjectVertex, position));
  attribute(1, 2, GL_BYTE, offsetof(ObjectVertex, normal));
  attribute(2, 2, GL_UNSIGNED_SHORT, offsetof(ObjectVertex, uv));
  attribute(3, 4, GL_UNSIGNED_BYTE, offsetof(ObjectVertex, colour));
}

}  // namespace

ObjectShape make_object_shape(const ObjectMesh& mesh) noexcept {
  ObjectShape shape;
  if (mesh.triangles.empty()) return shape;
  shape.vertices = make_buffer();
  shape.indices = make_buffer();
  shape.array = make_vertex_array();
  const auto fill = [](GLenum target, const GlBuffer& buffer, auto values) {
    glBindBuffer(target, buffer.get());
    glBufferData(target, static_cast<GLsizeiptr>(std::as_bytes(values).size()), values.data(),
                 GL_STATIC_DRAW);
  };
  glBindVertexArray(shape.array.get());
  fill(GL_ARRAY_BUFFER, shape.vertices, std::span(mesh.vertices));
  fill(GL_ELEMENT_ARRAY_BUFFER, shape.indices, std::span(mesh.triangles));
  describe_vertices();
  glBindVertexArray(0);
  shape.parts[0] = {.first_index = 0,
                    .index_count = static_cast<std::uint32_t>(mesh.triangles.size()),
                    .picture = -1,
                    .wrap = {}};
  shape.part_count = 1;
  return shape;
}

ObjectShape make_object_shape(const ObjectDetail& detail) noexcept {
  ObjectShape shape = make_object_shape(detail.mesh);
  shape.part_count = std::min(detail.parts.size(), shape.parts.size());
  std::copy_n(detail.parts.begin(), shape.part_count, shape.parts.begin());
  shape.uv_range = {detail.uv_low.x, detail.uv_low.y, detail.uv_size.x, detail.uv_size.y};
  return shape;
}

void add_picture(ObjectShape& shape, std::size_t picture, std::span<const Pixels> levels) noexcept {
  if (picture >= shape.pictures.size() || levels.empty() || levels[0].rgba.empty()) return;
  GlTexture texture = make_texture();
  bind_texture(static_cast<GLuint>(Unit::Image), texture.get());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexStorage2D(GL_TEXTURE_2D, static_cast<GLsizei>(levels.size()), GL_SRGB8_ALPHA8,
                 static_cast<GLsizei>(levels[0].width), static_cast<GLsizei>(levels[0].height));
  for (std::size_t level = 0; level < levels.size(); ++level)
    glTexSubImage2D(GL_TEXTURE_2D, static_cast<GLint>(level), 0, 0,
                    static_cast<GLsizei>(levels[level].width),
                    static_cast<GLsizei>(levels[level].height), GL_RGBA, GL_UNSIGNED_BYTE,
                    levels[level].rgba.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  for (const ObjectPart& part : std::span(shape.parts).first(shape.part_count))
    if (part.picture == static_cast<std::int32_t>(picture)) {
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap_of(part.wrap[0]));
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap_of(part.wrap[1]));
    }
  shape.pictures[picture] = std::move(texture);
}

const ObjectShape* Objects::shape_of(std::uint32_t object, bool from_nearby) const noexcept {
  if (object >= entries.size()) return nullptr;
  if (from_nearby && near == object && detail.array) return &detail;
  return entries[object].distant.array ? &entries[object].distant : nullptr;
}

}  // namespace docent::gles
