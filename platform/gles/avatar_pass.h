#pragma once

#include <array>

#include "platform/gles/body.h"
#include "platform/gles/program.h"
#include "platform/gles/scene_buffer.h"
#include "runtime/scene/shown_list.h"

namespace docent::gles {

/// Draws the avatars and their shadows on the floor: an instance each, in batches of those of one
/// body, as many as one uniform block holds, and with fewer triangles the smaller they appear.
class AvatarPass {
 public:
  /// More avatars than this are not drawn.
  static constexpr std::size_t most_avatars = scene::Change::most_bodies;

  Result<void> compile();

  /// Chooses who is in the picture and how detailed, sends the palettes and throws the bodies'
  /// shadows into the atlas. Called before the first strip; leaves its own framebuffer bound.
  /// The body stays where it is until the picture is drawn.
  void prepare(const scene::DrawList& list, const Body& body, Vec3 sun, PixelSize picture) noexcept;

  /// About the avatars that have moved and their shadows, where they were drawn and where they will
  /// be, which it remembers: called once for a picture.
  Region moved(const scene::DrawList& list, const scene::Change& change, const Body& body, Vec3 sun,
               PixelSize picture) noexcept;
  /// Draw the avatars or shadows that reach into these rows of the picture.
  void draw_bodies(SceneBuffer::Rows rows) const noexcept;
  void draw_shadows(SceneBuffer::Rows rows) const noexcept;

 private:
  /// An avatar in the picture.
  struct Seen {
    std::uint32_t avatar = 0;  ///< Of the draw list.
    std::uint32_t figure = 0;  ///< Of the body.
    std::uint32_t level = 0;
    float pixels = 0;                ///< How tall the body appears; 0: only its shadow does.
    Vec4 window{};                   ///< Square about its shadow: world x, z, half a side.
    SceneBuffer::Rows body, shadow;  ///< Where they are in the picture.
  };
  void choose(const scene::DrawList& list, Vec3 sun, PixelSize picture) noexcept;
  void choose_levels() noexcept;
  void reserve(std::size_t avatars) noexcept;
  void send(const scene::DrawList& list) noexcept;
  void write_record(const scene::DrawList& list, std::size_t place, Vec4* record) const noexcept;
  void draw_shadow_atlas() const noexcept;
  void soften_shadows() const noexcept;
  template <typename Draw>
  void draw_batches(SceneBuffer::Rows rows, SceneBuffer::Rows Seen::* part,
                    Draw draw) const noexcept;
  void draw_level(const Seen& one, std::uint32_t level, GLsizei instances) const noexcept;

  GlBuffer records_, looks_;
  GlVertexArray no_attributes_;
  GlTexture atlas_, soft_atlas_;
  GlFramebuffer atlas_framebuffer_, soft_framebuffer_;
  std::array<Region, most_avatars> regions_{};  ///< Where they were drawn.
  const Body* worn_ = nullptr;                  ///< In this picture.
  std::size_t record_size_ = 0;                 ///< Vec4s of an avatar.
  std::size_t capacity_ = 0;                    ///< Vec4s that `records_` has room for.
  std::array<Seen, most_avatars> seen_{};       ///< Finest level first, then from below upwards.
  std::size_t seen_count_ = 0;
  Program body_, shadow_, soften_, decal_;
  struct {
    GLint body_record_size, shadow_record_size, soften_record_size, decal_record_size;
  } at_{};
};

}  // namespace docent::gles
