#include "platform/gles/body.h"

#include <cstdint>
#include <vector>

namespace docent::gles {
namespace {

void describe_skinned_vertices() noexcept {
  constexpr auto stride = static_cast<GLsizei>(sizeof(SkinnedVertex));
  for (GLuint i = 0; i < 6; ++i) glEnableVertexAttribArray(i);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, stride,
                        buffer_offset(offsetof(SkinnedVertex, position)));
  glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, stride,
                        buffer_offset(offsetof(SkinnedVertex, normal)));
  glVertexAttribIPointer(2, 4, GL_UNSIGNED_BYTE, stride,
                         buffer_offset(offsetof(SkinnedVertex, joint)));
  glVertexAttribPointer(3, 4, GL_UNSIGNED_BYTE, GL_TRUE, stride,
                        buffer_offset(offsetof(SkinnedVertex, weight)));
  glVertexAttribIPointer(4, 1, GL_UNSIGNED_BYTE, stride,
                         buffer_offset(offsetof(SkinnedVertex, material)));
  glVertexAttribPointer(5, 1, GL_UNSIGNED_BYTE, GL_TRUE, stride,
                        buffer_offset(offsetof(SkinnedVertex, occlusion)));
}

template <typename Index>
void upload_indices(const std::vector<Index>& indices) noexcept {
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(Index)),
               indices.data(), GL_STATIC_DRAW);
}

}  // namespace

Body make_body(const SkinnedMesh& mesh, const scene::BodyLevels& levels) {
  Body body;
  body.joints = mesh.inverse_bind.size();
  body.figure = levels.figure;
  body.array = make_vertex_array();
  glBindVertexArray(body.array.get());
  body.vertices = make_buffer();
  glBindBuffer(GL_ARRAY_BUFFER, body.vertices.get());
  glBufferData(GL_ARRAY_BUFFER,
               static_cast<GLsizeiptr>(mesh.vertices.size() * sizeof(SkinnedVertex)),
               mesh.vertices.data(), GL_STATIC_DRAW);
  describe_skinned_vertices();
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
