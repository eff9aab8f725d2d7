#include "platform/gles/avatar_pass.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "platform/gles/shaders.h"
#include "runtime/scene/theme.h"

namespace docent {
namespace {

constexpr std::size_t most_joints = 64;  // palette in skin.glsl
constexpr GLsizei tile_side = 128;       // texels of shadow a body
constexpr GLsizei tiles_a_row = 4;
constexpr GLsizei atlas_levels = 5;  // the softest shadow is blurred over 16 texels
static_assert(tiles_a_row * tiles_a_row == AvatarPass::most_avatars);
constexpr float body_height = 1.85F;
constexpr float body_reach = 0.75F;  // metres from the hips to an outstretched hand or foot

using Outfit = std::array<Vec4, 8>;

Vec4 matte(std::uint32_t hex, float shine = 0) noexcept {
  const Colour c = srgb(hex);
  return {c.r, c.g, c.b, shine};
}

/// In the order of Material: Skin, Hair, Coat, Trousers, Shoes, Shirt, Eye. The guide's coat is the
/// one saturated thing on it; strolling visitors wear the museum's own quiet colours.
const std::array<Outfit, 5>& outfits() noexcept {
  static const std::array<Outfit, 5> all{{
      {matte(0xC99A7C, 0.02F), matte(0x2E2420, 0.05F), matte(0x1D7874, 0.01F), matte(0x35322F),
       matte(0x2A2420, 0.06F), matte(0xF0EADD), matte(0x241E1B, 0.6F), matte(0)},
      {matte(0xB98467, 0.02F), matte(0x4A3A2E, 0.05F), matte(0x8C8578), matte(0x5B554D),
       matte(0x3A322C), matte(0xD9D2C4), matte(0x241E1B, 0.6F), matte(0)},
      {matte(0xDDB497, 0.02F), matte(0x6F5A45, 0.05F), matte(0xB4A792), matte(0x6A6259),
       matte(0x463C34), matte(0xE6DFD1), matte(0x241E1B, 0.6F), matte(0)},
      {matte(0x8A5E44, 0.02F), matte(0x231D1A, 0.05F), matte(0x6F6F6A), matte(0x4B4844),
       matte(0x2E2924), matte(0xCFC8BA), matte(0x241E1B, 0.6F), matte(0)},
      {matte(0xE3BFA5, 0.02F), matte(0x9A948B, 0.05F), matte(0xA08E7A), matte(0x777066),
       matte(0x4A4139), matte(0xDDD5C6), matte(0x241E1B, 0.6F), matte(0)},
  }};
  return all;
}

void describe_vertices() noexcept {
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

/// Middle and half size of an avatar's tile of the atlas, in clip space.
Vec4 tile_of(std::size_t avatar) noexcept {
  constexpr float half = 1.0F / tiles_a_row;
  const auto column = static_cast<float>(avatar % tiles_a_row);
  const std::size_t whole_rows = avatar / tiles_a_row;
  const auto row = static_cast<float>(whole_rows);
  return {-1 + half * (2 * column + 1), -1 + half * (2 * row + 1), half, half};
}

/// The rows of the picture that a body and its shadow's square can touch.
SceneBuffer::Rows rows_of(const CameraView& camera, Vec3 hips, const Vec4& window) noexcept {
  SceneBuffer::Rows rows{1, -1};
  const Mat4 to_clip = camera.projection * camera.view;
  const auto include = [&](float x, float y, float z) {
    const Vec4 clip = to_clip * Vec4(x, y, z, 1);
    if (clip.w <= 0.01F) {
      rows = {-1, 1};  // behind the eye: anywhere
      return;
    }
    rows.low = std::min(rows.low, clip.y / clip.w);
    rows.high = std::max(rows.high, clip.y / clip.w);
  };
  for (const float sx : {-1.0F, 1.0F})
    for (const float sz : {-1.0F, 1.0F}) {
      for (const float dy : {-1.2F, 1.2F})
        include(hips.x + sx * body_reach, hips.y + dy, hips.z + sz * body_reach);
      include(window.x + sx * window.z, hips.y - 1.2F, window.y + sz * window.z);
      include(window.x + sx * window.z, hips.y - 0.6F, window.y + sz * window.z);
    }
  return rows;
}

}  // namespace

Result<void> AvatarPass::compile() {
  using namespace shaders;
  auto body = link_program("avatar", {frame_glsl, skin_glsl, avatar_vert},
                           {frame_glsl, light_glsl, avatar_frag});
  if (!body) return std::unexpected(body.error());
  auto shadow = link_program("shadow", {frame_glsl, skin_glsl, shadow_vert}, {shadow_frag});
  if (!shadow) return std::unexpected(shadow.error());
  auto decal =
      link_program("decal", {frame_glsl, decal_vert}, {frame_glsl, light_glsl, decal_frag});
  if (!decal) return std::unexpected(decal.error());
  body_ = std::move(*body);
  shadow_ = std::move(*shadow);
  decal_ = std::move(*decal);
  at_ = {body_["material_colour"], shadow_["tile"], shadow_["window"], decal_["window"],
         decal_["tile_uv"],        decal_["foot"],  decal_["centre"]};

  no_attributes_ = make_vertex_array();
  palettes_ = make_buffer();
  staging_.resize(most_avatars * most_joints);
  glBindBuffer(GL_UNIFORM_BUFFER, palettes_.get());
  glBufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(staging_.size() * sizeof(Mat4)), nullptr,
               GL_STREAM_DRAW);
  atlas_ = make_texture();
  bind_texture(static_cast<GLuint>(Unit::ShadowAtlas), atlas_.get());
  glTexStorage2D(GL_TEXTURE_2D, atlas_levels, GL_R8, tiles_a_row * tile_side,
                 tiles_a_row * tile_side);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  atlas_framebuffer_ = make_framebuffer();
  glBindFramebuffer(GL_FRAMEBUFFER, atlas_framebuffer_.get());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, atlas_.get(), 0);
  return {};
}

void AvatarPass::upload(const SkinnedMesh& mesh) noexcept {
  index_count_ = static_cast<GLsizei>(mesh.indices.size());
  joint_count_ = std::min(mesh.inverse_bind.size(), most_joints);
  array_ = make_vertex_array();
  glBindVertexArray(array_.get());
  vertices_ = make_buffer();
  glBindBuffer(GL_ARRAY_BUFFER, vertices_.get());
  glBufferData(GL_ARRAY_BUFFER,
               static_cast<GLsizeiptr>(mesh.vertices.size() * sizeof(SkinnedVertex)),
               mesh.vertices.data(), GL_STATIC_DRAW);
  indices_ = make_buffer();
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.get());
  glBufferData(GL_ELEMENT_ARRAY_BUFFER,
               static_cast<GLsizeiptr>(mesh.indices.size() * sizeof(std::uint32_t)),
               mesh.indices.data(), GL_STATIC_DRAW);
  describe_vertices();
  glBindVertexArray(0);
}

std::size_t AvatarPass::count_of(const DrawList& list) const noexcept {
  return index_count_ > 0 ? std::min(list.avatars.size(), most_avatars) : 0;
}

bool AvatarPass::is_in(std::size_t avatar, SceneBuffer::Rows rows) const noexcept {
  return reach_[avatar].low <= rows.high && reach_[avatar].high >= rows.low;
}

void AvatarPass::bind_palette(std::size_t avatar) const noexcept {
  constexpr std::size_t bytes = most_joints * sizeof(Mat4);
  static_assert(bytes % 256 == 0, "a multiple of every driver's uniform buffer alignment");
  glBindBufferRange(GL_UNIFORM_BUFFER, static_cast<GLuint>(Block::Palette), palettes_.get(),
                    static_cast<GLintptr>(avatar * bytes), bytes);
}

void AvatarPass::prepare(const DrawList& list, Vec3 sun) noexcept {
  const std::size_t count = count_of(list);
  if (count == 0) return;
  for (std::size_t a = 0; a < count; ++a) {
    const std::size_t first =
        std::min<std::size_t>(list.avatars[a].first_matrix, list.palette.size());
    const std::size_t joints = std::min(joint_count_, list.palette.size() - first);
    std::copy_n(list.palette.begin() + static_cast<std::ptrdiff_t>(first), joints,
                staging_.begin() + static_cast<std::ptrdiff_t>(a * most_joints));
    // The square from the feet to the tip of the shadow.
    const Vec3 throw_of_head = sun * (-body_height / std::max(sun.y, 0.2F));
    const Vec3 middle = list.avatars[a].centre + 0.5F * throw_of_head;
    const float half =
        0.5F * std::max(std::abs(throw_of_head.x), std::abs(throw_of_head.z)) + body_reach;
    window_[a] = {middle.x, middle.z, half, 0};
    reach_[a] = rows_of(list.camera, list.avatars[a].centre, window_[a]);
  }
  glBindBuffer(GL_UNIFORM_BUFFER, palettes_.get());
  glBufferSubData(GL_UNIFORM_BUFFER, 0, static_cast<GLsizeiptr>(count * most_joints * sizeof(Mat4)),
                  staging_.data());

  glBindFramebuffer(GL_FRAMEBUFFER, atlas_framebuffer_.get());
  glViewport(0, 0, tiles_a_row * tile_side, tiles_a_row * tile_side);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
  shadow_.use();
  glBindVertexArray(array_.get());
  for (std::size_t a = 0; a < count; ++a) {
    const Vec4 tile = tile_of(a);
    glUniform4fv(at_.tile, 1, &tile.x);
    glUniform4fv(at_.shadow_window, 1, &window_[a].x);
    bind_palette(a);
    glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
  }
  bind_texture(static_cast<GLuint>(Unit::ShadowAtlas), atlas_.get());
  glGenerateMipmap(GL_TEXTURE_2D);
}

void AvatarPass::draw_bodies(const DrawList& list, SceneBuffer::Rows rows) const noexcept {
  const std::size_t count = count_of(list);
  if (count == 0) return;
  body_.use();
  glBindVertexArray(array_.get());
  for (std::size_t a = 0; a < count; ++a) {
    if (!is_in(a, rows)) continue;
    const Outfit& outfit = outfits()[list.avatars[a].look % outfits().size()];
    glUniform4fv(at_.colours, static_cast<GLsizei>(outfit.size()), &outfit[0].x);
    bind_palette(a);
    glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
  }
}

void AvatarPass::draw_shadows(const DrawList& list, SceneBuffer::Rows rows) const noexcept {
  const std::size_t count = count_of(list);
  if (count == 0) return;
  decal_.use();
  glBindVertexArray(no_attributes_.get());
  for (std::size_t a = 0; a < count; ++a) {
    if (!is_in(a, rows)) continue;
    const AvatarDraw& avatar = list.avatars[a];
    const Vec4 tile = tile_of(a);
    glUniform4f(at_.tile_uv, 0.5F + 0.5F * tile.x, 0.5F + 0.5F * tile.y, 0.5F * tile.z,
                0.5F * tile.w);
    glUniform4fv(at_.decal_window, 1, &window_[a].x);
    const Vec4 feet[2] = {Vec4(avatar.feet[0], avatar.foot_height[0]),
                          Vec4(avatar.feet[1], avatar.foot_height[1])};
    glUniform4fv(at_.foot, 2, &feet[0].x);
    glUniform4f(at_.centre, avatar.centre.x, avatar.centre.y, avatar.centre.z, 0);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  }
}

}  // namespace docent
