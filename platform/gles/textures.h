#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "platform/gles/gl_names.h"
#include "platform/image/image.h"
#include "runtime/scene/draw_list.h"

namespace docent::gles {

/// Which sizes of a picture are kept: its own alone, drawn texel for pixel, or also all smaller
/// ones for the distance, which take a third more.
enum class Levels : std::uint8_t { One, All };

/// The textures that draw lists name by TextureId: texts and pictures. Its room is fixed, so that
/// an upload between frames does not allocate.
class Textures {
 public:
  Textures();

  scene::TextureId add_text(std::uint32_t width, std::uint32_t height,
                            std::span<const std::uint8_t> coverage) noexcept;
  scene::TextureId add_image(const Pixels& picture, Levels levels) noexcept;
  void release(scene::TextureId id) noexcept;

  struct Entry {
    GlTexture texture;
    std::uint32_t width = 0, height = 0;
  };
  /// The texture of an id, or null where there is none.
  const Entry* find(scene::TextureId id) const noexcept;

 private:
  scene::TextureId keep(GlTexture texture, std::uint32_t width, std::uint32_t height) noexcept;

  std::vector<Entry> entries_;           // by id - 1
  std::vector<std::uint32_t> released_;  // room to be used again
};

}  // namespace docent::gles
