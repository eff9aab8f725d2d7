#pragma once

#include <array>
#include <vector>

#include "platform/gles/program.h"
#include "platform/gles/scene_buffer.h"
#include "runtime/model/motion/skinned_mesh.h"
#include "runtime/scene/draw_list.h"

namespace docent {

/// Draws the avatars and what they take from the floor's light.
class AvatarPass {
 public:
  /// More avatars than this are not drawn.
  static constexpr std::size_t most_avatars = 16;

  Result<void> compile();
  void upload(const SkinnedMesh& mesh) noexcept;

  /// Sends the palettes and throws the bodies' shadows into the atlas. Before any strip; leaves its
  /// own framebuffer bound.
  void prepare(const DrawList& list, Vec3 sun) noexcept;
  /// Those that reach into these rows of the picture.
  void draw_bodies(const DrawList& list, SceneBuffer::Rows rows) const noexcept;
  void draw_shadows(const DrawList& list, SceneBuffer::Rows rows) const noexcept;

 private:
  std::size_t count_of(const DrawList& list) const noexcept;
  bool is_in(std::size_t avatar, SceneBuffer::Rows rows) const noexcept;
  void bind_palette(std::size_t avatar) const noexcept;

  GlBuffer vertices_, indices_, palettes_;
  GlVertexArray array_, no_attributes_;
  GlTexture atlas_;
  GlFramebuffer atlas_framebuffer_;
  GLsizei index_count_ = 0;
  std::size_t joint_count_ = 0;
  std::vector<Mat4> staging_;
  std::array<Vec4, most_avatars>
      window_{};  ///< Of each avatar: floor square that its shadow fits in.
  std::array<SceneBuffer::Rows, most_avatars> reach_{};  ///< Of each: body and shadow.
  Program body_, shadow_, decal_;
  struct {
    GLint colours, tile, shadow_window, decal_window, tile_uv, foot, centre;
  } at_{};
};

}  // namespace docent
