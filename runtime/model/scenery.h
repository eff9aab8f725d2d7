#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "runtime/model/geometry/vec2.h"

namespace docent {

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
  Count
};

/// A vertex of the building (world frame, metres). Light that never changes was computed by the
/// content compiler.
struct SceneryVertex {
  Vec3 position{};
  Vec3 normal{};
  std::array<float, 2>
      uv{};  ///< Floor and Ground: place in the lightmap. Picture: place in the exhibit's image.
  std::uint8_t sky = 255;  ///< Share of the sky that is seen, of 255.
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
  /// Light on the floor: one byte of sky and one of sun a texel, row by row from the south-west
  /// corner.
  std::uint32_t lightmap_width = 0, lightmap_height = 0;
  Vec2 lightmap_min{}, lightmap_max{};  ///< Floor frame: the rectangle that it covers.
  std::vector<std::byte> lightmap;
  Vec3 sun{};  ///< World frame, unit vector towards the sun.
};

}  // namespace docent
