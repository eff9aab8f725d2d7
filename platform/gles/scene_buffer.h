#pragma once

#include <cstddef>
#include <cstdint>

#include "platform/display.h"
#include "platform/gles/extent.h"
#include "platform/gles/gl_names.h"

namespace docent::gles {

/// The multisampled buffers that the model is drawn into, a horizontal strip of the picture at a
/// time.
class SceneBuffer {
 public:
  /// `samples` and `most_bytes` are as in RendererOptions.
  SceneBuffer(std::uint32_t samples, std::size_t most_bytes) noexcept;

  /// Makes the buffers fit the picture; nothing happens while its size stays.
  void fit(PixelSize picture) noexcept;

  std::uint32_t strips() const noexcept { return strips_; }
  std::uint32_t strip_of(GLint row) const noexcept {
    return static_cast<std::uint32_t>(row) / strip_height_;
  }
  /// What a strip has of a part of the picture; empty where it has none of it.
  Region part(std::uint32_t strip, const Region& of) const noexcept;
  /// Directs drawing to that part of a strip: the viewport is that of the whole picture, moved.
  void begin(std::uint32_t strip, const Region& part) const noexcept;
  /// Of the part of the strip that drawing is directed to, nothing is drawn in `hidden` of the
  /// picture: all that is drawn afterwards lies behind it.
  void hide(std::uint32_t strip, const Region& part, const Region& hidden) const noexcept;
  /// A part's lower and upper edge in clip space.
  struct Rows {
    float low = -1, high = 1;
  };
  Rows rows(const Region& part) const noexcept;
  /// Resolves that part of the strip into `framebuffer`, which encodes sRGB as this one does.
  void resolve(std::uint32_t strip, const Region& part, GLuint framebuffer) const noexcept;

 private:
  GLsizei samples_ = 1;
  std::size_t most_bytes_ = 0;
  PixelSize picture_;
  std::uint32_t strips_ = 0, strip_height_ = 1;
  GlRenderbuffer colour_, depth_, resolved_;
  GlFramebuffer framebuffer_, resolved_framebuffer_;
};

/// A picture that encodes sRGB and can be read as a texture, for targets that can do neither.
class Picture {
 public:
  enum class Read : std::uint8_t { Decoded, Encoded };
  /// `filter`: between its pixels. `read`: what the texture gives; Encoded is an extension.
  explicit Picture(GLint filter, Read read = Read::Decoded) noexcept
      : filter_(filter), read_(read) {}
  void fit(PixelSize size) noexcept;
  GLuint framebuffer() const noexcept { return framebuffer_.get(); }
  GLuint texture() const noexcept { return texture_.get(); }

 private:
  GLint filter_;
  Read read_;
  PixelSize size_;
  GlTexture texture_;
  GlFramebuffer framebuffer_;
};

}  // namespace docent::gles
