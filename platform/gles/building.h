#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "platform/gles/gl_names.h"
#include "runtime/model/scenery.h"
#include "runtime/scene/draw_list.h"

namespace docent::gles {

/// The building of one floor in texture memory.
struct Building {
  std::size_t carried =
      0;  ///< Bytes of the scenery that are there already; until all are, it has no array.
  Scenery scenery;         ///< Without vertices, indices and texels, which are uploaded.
  float floor_height = 0;  ///< World y of the floor's surface.
  GlBuffer vertices, indices;
  GlVertexArray array;
  GlTexture lightmap, shade_map;
  std::vector<scene::TextureId> image_of;  ///< By exhibit.
  std::vector<bool> hangs;                 ///< By exhibit: is it on a wall?
};

/// Describes vertices as a scenery has them, of the buffer that is bound to the array that is.
/// Those of a building are packed.
void describe_scenery_vertices() noexcept;

/// Carries a building there, from the first time on some more of it, at most a megabyte each time;
/// false once nothing is left. One without vertices stays without an array.
bool carry_on(Building& building, const Scenery& scenery,
              std::span<const scene::TextureId> image_of);

}  // namespace docent::gles
