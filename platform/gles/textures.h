#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "platform/gles/gl_names.h"
#include "platform/image/image.h"
#include "runtime/scene/draw_list.h"

namespace docent::gles {

/// The textures that draw lists name by TextureId: texts and pictures. Their table has a fixed
/// size, so that an upload between frames does not allocate.
class Textures {
 public:
  Textures();

  static constexpr std::size_t most = 16'384;  ///< The largest id.
  /// Keep a text or a picture under an id, which is the caller's to choose: 1 to `most`. What has
  /// no pixels, or another id, is not kept and draws nothing.
  void add_text(scene::TextureId id, std::uint32_t width, std::uint32_t height,
                std::span<const std::uint8_t> coverage) noexcept;
  /// One level is drawn texel for pixel; all of them (image::mip_levels) from any distance.
  void add_image(scene::TextureId id, std::span<const Pixels> levels) noexcept;
  /// Other pixels for an image of one level and of this size.
  void replace_image(scene::TextureId id, const Pixels& picture) noexcept;
  void release(scene::TextureId id) noexcept;

  struct Entry {
    GlTexture texture;
    std::uint32_t width = 0, height = 0;
  };
  /// The texture of an id, or null where there is none.
  const Entry* find(scene::TextureId id) const noexcept;

 private:
  void keep(scene::TextureId id, GlTexture texture, std::uint32_t width,
            std::uint32_t height) noexcept;

  std::vector<Entry> entries_;  // by id - 1
};

}  // namespace docent::gles
