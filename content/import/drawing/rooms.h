#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "content/import/drawing/drawing.h"
#include "content/import/drawing/layer_kind.h"

namespace docent::import {

/// A room of bare lines: what they enclose, and the texts that stand in it.
struct FoundRoom {
  std::vector<std::vector<Vec2>> rings;  ///< The outer one first, then what stands in it.
  double area = 0;                       ///< Square metres, without the holes.
  std::string name;                      ///< As its texts say; may be empty.
  std::optional<double> stated_area;     ///< Square metres that one of its texts says.
  std::size_t doors = 0;
  std::uint32_t line = 0;  ///< Of the source, where the outline was drawn in one go.
  Vec2 middle{};           ///< Farthest from its walls.
};

struct FoundDoor {
  Vec2 a{}, b{};       ///< From jamb to jamb.
  bool swing = false;  ///< A leaf and its arc are drawn; else it is a gap between walls.
  bool certain = false;
  bool wide = false;      ///< Wider than a door: a hall's open end.
  std::size_t rooms = 0;  ///< Between two rooms, or from one to the outside.
};

/// Stairs, by their treads or by the name of the room that they fill.
struct FoundStairs {
  std::string kind = "stairs";  ///< Or `lift`, `ramp`.
  std::string name{};           ///< Of the room they are in; may be empty.
  Vec2 middle{};
  double width = 0;  ///< Metres; 0 where it is not known.
};

/// One plan of the drawing: what lies together, apart from the others.
struct FoundPlan {
  std::vector<FoundRoom> rooms;
  std::vector<FoundDoor> doors;
  std::vector<std::vector<Vec2>> columns;
  std::vector<FoundStairs> stairs;
  Vec2 low{}, high{};               ///< The box of its walls.
  std::optional<double> ordinal{};  ///< As a text beside it says: `GROUND FLOOR`.
  std::string title{};              ///< That text.
};

struct FoundPlans {
  std::vector<FoundPlan> plans;
  std::map<std::string, std::size_t> culled;  ///< What was left out, and how often.
  std::size_t wings = 0;        ///< Parts that lie apart and were taken for wings of a plan.
  bool outlines_taken = false;  ///< Closed outlines were the rooms.
  std::string refused;          ///< A sentence where there is too much to look at.
};

/// Finds rooms and doors in strokes. Frame: metres. `kinds` has one entry for each layer.
FoundPlans find_rooms(const Drawing& drawing, const std::vector<LayerKind>& kinds);

}  // namespace docent::import
