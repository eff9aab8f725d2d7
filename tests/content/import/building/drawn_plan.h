#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "content/import/building/imported_building.h"
#include "content/import/building/shape.h"

namespace docent::test {

/// A floor of which everything is known, so that what is found in a drawing of it can be judged.
struct KnownFloor {
  struct Room {
    std::string name{};
    import::Shape shape{};
  };
  struct Door {
    Vec2 a{}, b{};         ///< From jamb to jamb, in the middle of the wall.
    double thickness = 0;  ///< Of the wall there.
  };
  std::vector<Room> rooms{};
  std::vector<Door> doors{};
  std::vector<std::vector<import::BuildingRing>> walls{};  ///< Polygons: where nobody walks.
};

/// The floor that a level's rooms and doors make when walls are as thick as that, metres.
KnownFloor known_floor(const import::ImportedLevel& level, double wall_thickness);

/// Rooms along corridors, halls and rooms behind rooms, other ones for each seed; metres.
import::ImportedLevel random_level(std::uint32_t seed);
/// The same with round walls, slanted walls and columns.
import::ImportedLevel curved_level(std::uint32_t seed);

enum class DoorsDrawn : std::uint8_t {
  Gaps,        ///< The wall stops, and goes on.
  Arcs,        ///< A leaf and its arc.
  Blocks,      ///< The same as a block, mirrored where it opens to the other side.
  Sliding,     ///< A leaf that lies along the wall.
  Thresholds,  ///< Lines from jamb to jamb.
  Polylines,   ///< A leaf as a thin box, the arc as a bulge.
};
enum class Furniture : std::uint8_t { None, Blocks, Lines };
enum class Hatch : std::uint8_t { None, Entities, Lines };

/// How a hand draws a floor. The defaults are tidy.
struct DrawingManner {
  std::string name = "tidy";
  double metres_per_unit = 0.001;
  bool states_unit = true;
  double turn = 0;  ///< Radians.
  bool mirror = false;
  Vec2 move{};  ///< Metres.
  std::string wall_layer = "WALL", door_layer = "DOOR", text_layer = "TEXT",
              furniture_layer = "FURNITURE", hatch_layer = "HATCH", dimension_layer = "DIM",
              axis_layer = "AXIS";
  DoorsDrawn doors = DoorsDrawn::Arcs;
  Furniture furniture = Furniture::None;
  Hatch hatch = Hatch::None;
  bool dimensions = false, axes = false, texts = true;
  bool texts_are_attributes = false;
  double gap = 0;             ///< Metres by which lines stop short of their corners.
  double overshoot = 0;       ///< Metres by which lines run past their corners.
  double crooked = 0;         ///< Metres by which corners are off, each line for itself.
  int copies = 1;             ///< Each stroke is drawn so often.
  bool in_pieces = false;     ///< Walls as many short strokes.
  bool polylines = false;     ///< Walls as closed polylines.
  bool single_lines = false;  ///< Walls as one line: the drawing of a floor with thin walls.
};

/// The whole text of a DXF of these floors, side by side.
std::string draw_dxf(const std::vector<KnownFloor>& floors, const DrawingManner& manner);
/// Where the drawing of a floor has a point, metres.
Vec2 drawn_at(Vec2 point, const DrawingManner& manner);

/// What was found of a floor in a level that an importer made of its drawing.
struct FoundShare {
  std::size_t rooms = 0, right = 0;        ///< Known; found, with their area to 5 %.
  std::size_t extra = 0;                   ///< Rooms that are none.
  std::size_t doors = 0, doors_right = 0;  ///< Known; found within half a metre.
  std::size_t doors_extra = 0;
  std::vector<std::string> missed{};  ///< In words.
  FoundShare& operator+=(const FoundShare& other);
};
FoundShare judge(const KnownFloor& floor, const import::ImportedLevel& level,
                 const DrawingManner& manner, Vec2 moved_by);

}  // namespace docent::test
