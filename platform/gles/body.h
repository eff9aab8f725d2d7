#pragma once

#include <array>
#include <cstddef>

#include "platform/gles/gl_names.h"
#include "runtime/model/motion/skinned_mesh.h"
#include "runtime/scene/body_detail.h"

namespace docent::gles {

/// The body that every avatar wears, in texture memory.
struct Body {
  GlBuffer vertices, indices;
  GlVertexArray array;
  std::array<scene::BodyLevels::Run, scene::BodyLevels::count> level{};  ///< Of the indices.
  GLenum index_type = GL_UNSIGNED_SHORT;
  std::size_t joints = 0;
  float stature = 1;  ///< Metres.
};
/// `levels`: of that mesh.
Body make_body(const SkinnedMesh& mesh, const scene::BodyLevels& levels);

}  // namespace docent::gles
