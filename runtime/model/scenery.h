#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "runtime/model/geometry/vec2.h"

namespace docent {

/// Metres above the floor at which walls and columns are cut.
inline constexpr double cut_height = 1.45;

/// What a piece of the building is made of; the renderer gives each its colour.
enum class Surface : std::uint8_t {
  Floor,
  Plaster,
  CutFace,
  CaseBody,
  Glass,
  Frame,
  Picture,
  Object,
  Ground,
  Stone,  ///< Floor laid with stone; `Floor` itself is oak.
  Count
};

/// A vertex of the building (world frame, metres). Light that never changes was computed by the
/// content compiler.
struct SceneryVertex {
  Vec3 position{};
  Vec3 normal{};
  /// Picture: place in the exhibit's image, from its upper left. Everything else: place in the
  /// lightmap.
  std::array<float, 2> uv{};
  /// Share of the sky that is seen, of 255. Glass: its opacity. Floor and Stone: their gallery's
  /// tint (floor_tint.h).
  std::uint8_t sky = 255;
  std::uint8_t sun = 255;  ///< Share of the sun's disc that is seen, of 255.
};

/// Triangles of one surface, drawn together.
struct SceneryPart {
  Surface surface = Surface::Floor;
  std::int32_t exhibit = -1;  ///< Whose picture or object it is; -1 where it is nobody's.
  std::uint32_t first_index = 0, index_count = 0;
};

/// The building of one floor, ready to be drawn: geometry with its light baked in.
struct Scenery {
  std::vector<SceneryVertex> vertices;
  std::vector<std::uint32_t> indices;  ///< Triangles, counter-clockwise seen from outside.
  std::vector<SceneryPart> parts;
  /// Light on the floor, three bytes a texel, row by row from the south-west corner: the share of
  /// the sky that is seen, that of the sun, and the height up to which there is shade (255 is
  /// shade_range), by which moving bodies are lit.
  static constexpr std::uint32_t lightmap_channels = 3;
  static constexpr float shade_range = 2.0F;  ///< Metres above the floor.
  std::uint32_t lightmap_width = 0, lightmap_height = 0;
  Vec2 lightmap_min{}, lightmap_max{};  ///< Floor frame: the rectangle that it covers.
  std::vector<std::byte> lightmap;
  Vec3 sun{};  ///< World frame, unit vector towards the sun.
};

}  // namespace docent
