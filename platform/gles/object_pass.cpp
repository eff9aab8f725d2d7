#include "platform/gles/object_pass.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "platform/gles/shaders.h"

namespace docent::gles {
namespace {

/// May any of a ball be in the picture?
bool is_in_picture(const Mat4& view_projection, Vec3 middle, float radius) noexcept {
  const Vec4 clip = view_projection * Vec4(middle, 1);
  if (clip.w < -radius) return false;
  // A lens of 10 degrees or more makes a metre at most that much of the picture's half.
  constexpr float longest_lens = 12;
  const float edge = clip.w + longest_lens * radius;
  return std::abs(clip.x) <= edge && std::abs(clip.y) <= edge;
}

}  // namespace

Result<void> ObjectPass::compile() {
  using namespace shaders;
  auto program =
      link_program("object", {frame_glsl, object_vert}, {frame_glsl, light_glsl, object_frag});
  if (!program) return std::unexpected(program.error());
  program_ = std::move(*program);
  at_ = {program_["foot"], program_["turn"], program_["size"], program_["uv_range"],
         program_["glow"]};
  white_ = make_texture();
  bind_texture(static_cast<GLuint>(Unit::Image), white_.get());
  constexpr std::array<std::uint8_t, 4> white{255, 255, 255, 255};
  glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, 1, 1);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, white.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  return {};
}

void ObjectPass::draw(const scene::DrawList& list, const Objects& objects) const noexcept {
  if (list.objects.empty()) return;
  const Mat4 view_projection = list.camera.projection * list.camera.view;
  program_.use();
  glDisable(GL_CULL_FACE);
  for (const scene::ObjectDraw& object : list.objects) {
    const ObjectShape* shape = objects.shape_of(object.object, list.near_object == object.object);
    if (shape == nullptr) continue;
    const Vec3 size = objects.entries[object.object].size;
    const float radius = object.scale * std::sqrt(glm::dot(size, size));
    if (!is_in_picture(view_projection, object.foot, radius)) continue;
    glUniform4f(at_.foot, object.foot.x, object.foot.y, object.foot.z, object.scale);
    // Its front is +z, and the floor's north is -z.
    glUniform2f(at_.turn, -std::sin(object.heading), std::cos(object.heading));
    glUniform3f(at_.size, size.x, size.y, size.z);
    glUniform4fv(at_.uv_range, 1, shape->uv_range.data());
    glUniform1f(at_.glow, object.glow);
    glBindVertexArray(shape->array.get());
    for (const ObjectPart& part : std::span(shape->parts).first(shape->part_count)) {
      const bool has_picture =
          part.picture >= 0 && shape->pictures[static_cast<std::size_t>(part.picture)];
      bind_texture(static_cast<GLuint>(Unit::Image),
                   has_picture ? shape->pictures[static_cast<std::size_t>(part.picture)].get()
                               : white_.get());
      glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(part.index_count), GL_UNSIGNED_SHORT,
                     buffer_offset(part.first_index * sizeof(std::uint16_t)));
    }
  }
  glEnable(GL_CULL_FACE);
}

}  // namespace docent::gles
