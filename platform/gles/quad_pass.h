#pragma once

#include <array>
#include <span>
#include <vector>

#include "platform/display.h"
#include "platform/gles/extent.h"
#include "platform/gles/program.h"
#include "platform/gles/textures.h"

namespace docent::gles {

/// Draws the interface: rectangles in order, in as few draw calls as their textures allow.
class QuadPass {
 public:
  Result<void> compile();
  /// Those that reach into a part of the screen.
  void draw(std::span<const scene::Quad> quads, PixelSize screen, const Textures& textures,
            const Region& part) noexcept;

 private:
  /// One instance, in pixels.
  struct Instance {
    std::array<float, 4> rect, uv, colour, shape, clip;
  };
  void flush(GLuint texture) noexcept;

  GlBuffer instances_;
  GlVertexArray array_;
  std::vector<Instance> staging_;
  Program program_;
  GLint screen_ = -1;
};

}  // namespace docent::gles
