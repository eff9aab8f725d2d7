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
  /// Copies the picture into the target: of what has `changed` since the copy before, and what
  /// those before it changed, as much as the target lacks. `age`: as Display::age().
  void copy(const RenderTarget& target, const Region& changed, std::uint32_t age) noexcept;
  /// What the targets hold is no picture of this pass any more.
  void forget() noexcept { copies_ = 0; }

 private:
  Region stale(std::uint32_t age) const noexcept;

  static constexpr std::size_t most_age = 4;  ///< Buffers of a screen that take turns.
  Picture picture_{GL_NEAREST};
  Program program_;
  GLint quarter_turns_ = -1, shift_ = -1;
  GlVertexArray array_;
  RenderTarget copied_to_{};
  std::array<Region, most_age> changed_{};  ///< Of the last copies, the newest first.
  std::size_t copies_ = 0;                  ///< Into that target, one after the other.
};

/// Where a part of the picture lies in the panel's framebuffer, and a pixel about it. Where the
/// picture is shifted, what takes the place of its edge, too.
Region on_panel(const Region& part, const RenderTarget& target) noexcept;

/// The panel's framebuffer: the picture's size, as the panel lies.
PixelSize panel_size(const RenderTarget& target) noexcept;

}  // namespace docent::gles
