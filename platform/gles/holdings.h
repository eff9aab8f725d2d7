#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "platform/image/image.h"
#include "runtime/model/exhibit/object.h"
#include "runtime/model/motion/skinned_mesh.h"
#include "runtime/model/scenery.h"
#include "runtime/scene/body_detail.h"
#include "runtime/scene/draw_list.h"

namespace docent::gles {

/// What a draw list may name, in texture memory: texts and pictures, the building of each floor,
/// and the body that every avatar wears. One museum's may be made, a piece between two frames,
/// while another's are drawn.
///
/// Filled and destroyed on the thread on which the renderer's context is current; that context
/// outlives it. It may be made, and moved while it is empty, on any.
class Holdings {
 public:
  Holdings();
  Holdings(Holdings&&) noexcept;
  Holdings& operator=(Holdings&&) noexcept;
  ~Holdings();

  /// Keeps a set text under an id, 1 to 4096, that draw lists will name. `coverage` says how much
  /// of each pixel the text covers: `width` times `height` bytes, rows from the top. Without a
  /// pixel, or with another id, nothing is kept, and nothing drawn.
  void add_text(scene::TextureId id, std::uint32_t width, std::uint32_t height,
                std::span<const std::uint8_t> coverage) noexcept;
  /// Keeps a picture that is drawn texel for pixel.
  void add_image(scene::TextureId id, const Pixels& picture) noexcept;
  /// Keeps a picture of the building and the smaller ones of it for the distance
  /// (image::mip_levels).
  void add_scenery_image(scene::TextureId id, std::span<const Pixels> levels) noexcept;
  /// Puts other pixels into a picture of one level that is kept; nothing happens where it is not of
  /// their size. What was drawn of it looks different now. Does not allocate.
  void replace_image(scene::TextureId id, const Pixels& picture) noexcept;
  /// How large a kept text or picture is; no pixels: it is not kept.
  struct Size {
    std::uint32_t width = 0, height = 0;
    bool operator==(const Size&) const = default;
  };
  Size size_of(scene::TextureId id) const noexcept;
  /// Gives back the memory of a text or a picture.
  void release(scene::TextureId id) noexcept;

  /// Some more of the building of a floor, a megabyte at most, until all of it is there and it is
  /// drawn: false then. `image_of` holds a texture per exhibit (SceneryPart::exhibit).
  bool add_scenery(std::uint32_t floor, const Scenery& scenery,
                   std::span<const scene::TextureId> image_of);
  /// The body that every avatar wears; `levels` are that mesh's.
  void set_body(const SkinnedMesh& mesh, const scene::BodyLevels& levels);

  /// Keeps an exhibit's object as it is from afar; `object` is its index, in ascending order.
  void add_object(std::uint32_t object, Vec3 size, const ObjectMesh& distant);
  /// The shape of one object from nearby; its pictures follow one by one, and then it is shown
  /// instead of the one before. None of this allocates.
  void begin_object_detail(const ObjectDetail& detail) noexcept;
  void add_object_picture(std::size_t picture, std::span<const Pixels> levels) noexcept;
  void show_object_detail(std::uint32_t object) noexcept;
  void drop_object_detail() noexcept;

  struct Parts;
  const Parts& parts() const noexcept { return *parts_; }  ///< For the renderer.

 private:
  std::unique_ptr<Parts> parts_;
};

}  // namespace docent::gles
