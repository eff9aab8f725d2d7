#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "platform/display.h"
#include "platform/image/image.h"
#include "runtime/model/motion/skinned_mesh.h"
#include "runtime/model/result.h"
#include "runtime/model/scenery.h"
#include "runtime/scene/draw_list.h"

namespace docent::gles {

struct RendererOptions {
  std::uint32_t samples = 4;  ///< For each pixel of the model; 0 or 1: jagged, in half the time.
  /// The model (building, avatars and way) is drawn in horizontal strips, so that its multisampled
  /// buffers take no more bytes than this, or than 64 rows do. A GPU is quicker with all of the
  /// screen in one strip.
  std::size_t buffer_bytes = std::size_t{5} << 20;
};

/// Draws draw lists with OpenGL ES 3. Made, used and destroyed on the thread on which a context is
/// current; that context outlives it.
///
/// Uploads may be made between frames. `draw` does not allocate, cannot fail, and shows less where
/// a list asks for what was not uploaded.
class Renderer {
 public:
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;
  ~Renderer();

  /// Keeps a set text under an id, 1 to 4096, that draw lists will name. `coverage` says how much
  /// of each pixel the text covers: `width` times `height` bytes, rows from the top. Without a
  /// pixel, or with another id, nothing is kept, and nothing drawn.
  void upload_text(scene::TextureId id, std::uint32_t width, std::uint32_t height,
                   std::span<const std::uint8_t> coverage) noexcept;
  /// Keeps a picture that is drawn texel for pixel.
  void upload_image(scene::TextureId id, const Pixels& picture) noexcept;
  /// Keeps a picture of the building, with smaller versions of itself for the distance.
  void upload_scenery_image(scene::TextureId id, const Pixels& picture) noexcept;
  /// Give back the memory of one texture, or of all.
  void release(scene::TextureId id) noexcept;
  void release_textures() noexcept;

  /// The building of a floor. `image_of` holds a texture per exhibit (SceneryPart::exhibit).
  void upload_scenery(std::uint32_t floor, const Scenery& scenery,
                      std::span<const scene::TextureId> image_of);
  /// The body that every avatar wears.
  void upload_avatar(const SkinnedMesh& mesh);

  /// Draws one of everything into the target, once all floors and the body are uploaded, so that
  /// the driver has compiled what frames need. Takes about a third of a second on a CPU.
  void warm_up(const RenderTarget& target);

  /// Draws everything into the target.
  void draw(const scene::DrawList& list, const RenderTarget& target) noexcept;

 private:
  friend Result<Renderer> make_renderer(const RendererOptions&);
  struct Parts;
  explicit Renderer(std::unique_ptr<Parts> parts) noexcept;
  std::unique_ptr<Parts> parts_;
};

/// Compiles the shaders in the current context. Fails with the driver's own words.
Result<Renderer> make_renderer(const RendererOptions& options = {});

}  // namespace docent::gles
