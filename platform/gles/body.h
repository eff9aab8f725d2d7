#pragma once

#include <cstddef>
#include <vector>

#include "platform/gles/gl_names.h"
#include "runtime/model/motion/skinned_mesh.h"
#include "runtime/scene/body_detail.h"

namespace docent::gles {

/// The bodies that avatars wear, in texture memory.
struct Body {
  GlBuffer vertices, indices, colours;
  GlVertexArray array;
  std::vector<scene::BodyLevels::Levels> figure;  ///< Of the indices, one a body.
  /// Of each body: metres from the joints (and nodes of cloth) that move a vertex to the vertex, at
  /// most. In no pose is a part of it further from the smallest box about them.
  std::vector<float> reach;
  GLenum index_type = GL_UNSIGNED_SHORT;
  std::size_t matrices = 0;  ///< That one of them is drawn with.
  bool has_own = false;      ///< The last body is the museum's, with a colour for each vertex.
};
/// `levels`: of that mesh.
Body make_body(const SkinnedMesh& mesh, const scene::BodyLevels& levels);

}  // namespace docent::gles
