#pragma once

#include "platform/display.h"
#include "platform/gles/gl_names.h"
#include "platform/gles/program.h"
#include "runtime/model/result.h"

namespace docent::bench {

/// What a frame's cost is measured by: 50,000 triangles that fill the picture, each pixel lit by a
/// sun whose shadow map is 1,024 pixels wide and made anew in every frame. Nothing in it is clever.
class ReferenceScene {
 public:
  /// `samples`: for each pixel of the picture.
  static Result<ReferenceScene> make(PixelSize size, int samples);
  void draw() const noexcept;
  int triangles() const noexcept;

 private:
  void draw_shadow_map() const noexcept;
  void draw_picture() const noexcept;

  PixelSize size_;
  gles::Program lit_, depth_;
  gles::GlVertexArray array_;
  gles::GlBuffer vertices_, indices_;
  gles::GlTexture shadow_;
  gles::GlRenderbuffer colour_, depth_buffer_, shown_;
  gles::GlFramebuffer to_shadow_, to_samples_, to_picture_;
};

}  // namespace docent::bench
