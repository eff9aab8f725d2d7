#pragma once

#include <optional>
#include <span>
#include <vector>

#include "platform/gles/building.h"
#include "platform/gles/program.h"
#include "platform/gles/textures.h"
#include "runtime/scene/theme.h"

namespace docent::gles {

/// Draws the building of a floor.
class SceneryPass {
 public:
  Result<void> compile();

  /// Takes over how far walls have sunk, and where the leaves of doors are. Before a frame is
  /// drawn.
  void prepare(const scene::WallLevels& walls, std::span<const scene::LeafDraw> leaves) noexcept;
  /// Walls, doors, cases, pictures; the exhibit that is `highlighted` glows.
  void draw_solids(const Building& building, std::optional<std::uint32_t> highlighted,
                   const Textures& textures) const noexcept;
  /// Floors and the table that the model stands on (Surface::Ground): after what stands on them, so
  /// that little is drawn twice.
  void draw_floors(const Building& building) const noexcept;
  /// After everything else, since it is drawn over what stands behind it.
  void draw_glass(const Building& building) const noexcept;

 private:
  void draw_surface(const Building& building, Surface surface) const noexcept;

  /// A program of what may sink with its wall, and its uniforms.
  struct Sinking {
    Program program;
    GLint albedo = -1, glow = -1, window = -1, cut = -1;
  };
  void make_levels();
  void make_leaf_array();
  void prepare_leaves(std::span<const scene::LeafDraw> leaves) noexcept;
  void draw_leaves() const noexcept;
  void use(const Sinking& sinking, bool hangs) const noexcept;
  void draw_walls(const Building& building) const noexcept;
  void draw_pictures(const Building& building, std::optional<std::uint32_t> highlighted,
                     const Textures& textures) const noexcept;

  Program solid_, picture_, floor_, ground_, glass_;
  Sinking wall_, hung_picture_;
  struct {
    GLint solid_albedo, solid_glow, picture_glow, floor_albedo, floor_grain, floor_tints;
  } at_{};
  GlTexture levels_;
  scene::WallLevels walls_;  ///< Those in the texture.
  /// The leaves of doors: those that `mesh` was made of, and which of its vertices are bars.
  struct {
    std::vector<scene::LeafDraw> shown;
    std::vector<SceneryVertex> mesh;
    std::size_t bars = 0;
    GlBuffer vertices;
    GlVertexArray array;
  } leaves_;
  scene::Theme theme_;
};

}  // namespace docent::gles
