#pragma once

#include <optional>
#include <span>
#include <vector>

#include "platform/gles/program.h"
#include "platform/gles/textures.h"
#include "runtime/model/scenery.h"
#include "runtime/scene/theme.h"

namespace docent::gles {

/// Draws the building.
class SceneryPass {
 public:
  Result<void> compile();
  void upload(std::uint32_t floor, const Scenery& scenery,
              std::span<const scene::TextureId> image_of);

  /// The building of a floor without its vertices and texels; null where there is none.
  const Scenery* scenery_of(std::uint32_t floor) const noexcept;
  /// World y of the floor's surface.
  float floor_height(std::uint32_t floor) const noexcept;
  /// Binds the floor's lightmap for every pass.
  void bind_light(std::uint32_t floor) const noexcept;

  /// Walls, cases, pictures; the exhibit that is `highlighted` glows.
  void draw_solids(std::uint32_t floor, std::optional<std::uint32_t> highlighted,
                   const Textures& textures) const noexcept;
  /// Floors and the table that the model stands on (Surface::Ground): after what stands on them, so
  /// that little is drawn twice.
  void draw_floors(std::uint32_t floor) const noexcept;
  /// After everything else, since it is drawn over what stands behind it.
  void draw_glass(std::uint32_t floor) const noexcept;

 private:
  struct Building {
    Scenery scenery;  ///< Its vertices, indices and texels are uploaded and not kept here.
    float floor_height = 0;
    GlBuffer vertices, indices;
    GlVertexArray array;
    GlTexture lightmap;
    std::vector<scene::TextureId> image_of;
  };
  const Building* building(std::uint32_t floor) const noexcept;
  void draw_surface(const Building& building, Surface surface) const noexcept;

  std::vector<Building> buildings_;
  Program solid_, picture_, floor_, ground_, glass_;
  struct {
    GLint solid_albedo, solid_glow, picture_glow, floor_albedo, floor_grain;
  } at_{};
  scene::Theme theme_;
};

}  // namespace docent::gles
