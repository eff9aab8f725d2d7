#pragma once

#include "platform/gles/object_shape.h"
#include "platform/gles/program.h"
#include "runtime/scene/draw_list.h"

namespace docent::gles {

/// Draws exhibits that are shapes of their own.
class ObjectPass {
 public:
  Result<void> compile();
  /// Those of the list that are in the picture: the one that is looked at from nearby, where its
  /// detail is there, the others as they are from afar. With both sides, since scans are open.
  void draw(const scene::DrawList& list, const Objects& objects) const noexcept;

 private:
  Program program_;
  struct {
    GLint foot, turn, size, uv_range, glow;
  } at_{};
  GlTexture white_;  ///< Of parts without a picture.
};

}  // namespace docent::gles
