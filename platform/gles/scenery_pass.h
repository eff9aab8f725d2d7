#pragma once

#include <optional>

#include "platform/gles/building.h"
#include "platform/gles/program.h"
#include "platform/gles/textures.h"
#include "runtime/scene/theme.h"

namespace docent::gles {

/// Draws the building of a floor.
class SceneryPass {
 public:
  Result<void> compile();

  /// Walls, cases, pictures; the exhibit that is `highlighted` glows.
  void draw_solids(const Building& building, std::optional<std::uint32_t> highlighted,
                   const Textures& textures) const noexcept;
  /// Floors and the table that the model stands on (Surface::Ground): after what stands on them, so
  /// that little is drawn twice.
  void draw_floors(const Building& building) const noexcept;
  /// After everything else, since it is drawn over what stands behind it.
  void draw_glass(const Building& building) const noexcept;

 private:
  void draw_surface(const Building& building, Surface surface) const noexcept;

  Program solid_, picture_, floor_, ground_, glass_;
  struct {
    GLint solid_albedo, solid_glow, picture_glow, floor_albedo, floor_grain;
  } at_{};
  scene::Theme theme_;
};

}  // namespace docent::gles
