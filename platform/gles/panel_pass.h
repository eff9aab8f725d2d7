#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "platform/display.h"
#include "platform/gles/extent.h"
#include "platform/gles/gl_names.h"
#include "platform/gles/program.h"
#include "platform/gles/scene_buffer.h"
#include "runtime/model/result.h"

namespace docent::gles {

/// Brings the picture onto a screen whose framebuffers keep what they are given, and which may be
/// mounted turned.
class PanelPass {
 public:
  Result<void> compile();

  /// Where the picture of that size is drawn; it encodes sRGB, and keeps what was drawn.
  GLuint picture(PixelSize size) noexcept;
  /// Does `copy_of` take a picture as `picture` is?
  bool copies_encoded() const noexcept { return is_read_encoded_; }
  /// What the target lacks of the picture: of what has `changed` since it was asked before, and
  /// what changed before that, as much as it has not. `age`: as Display::age().
  Region lacking(const RenderTarget& target, const Region& changed, std::uint32_t age) noexcept;
  /// Copies a part of the picture into the target that was asked for.
  void copy(const Region& part) noexcept { copy_of(picture_.texture(), part); }
  /// Copies the part out of another picture of all that is seen, which is as large or is enlarged.
  void copy_of(GLuint texture, const Region& part) noexcept;
  /// What the targets hold is no picture of this pass any more.
  void forget() noexcept { copies_ = 0; }

 private:
  Region stale(std::uint32_t age) const noexcept;

  static constexpr std::size_t most_age = 4;  ///< Buffers of a screen that take turns.
  Picture picture_{GL_NEAREST};
  bool is_read_encoded_ = false;
  Program program_;
  GLint quarter_turns_ = -1, shift_ = -1;
  GlVertexArray array_;
  RenderTarget target_{};
  std::array<Region, most_age> changed_{};  ///< Of the last copies, the newest first.
  std::size_t copies_ = 0;                  ///< Into that target, one after the other.
};

/// Where a part of the picture lies in the panel's framebuffer. Where the picture is shifted, what
/// takes the place of its edge, too.
Region on_panel(const Region& part, const RenderTarget& target) noexcept;

/// The panel's framebuffer: the picture's size, as the panel lies.
PixelSize panel_size(const RenderTarget& target) noexcept;

}  // namespace docent::gles
