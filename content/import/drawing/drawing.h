#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "runtime/model/geometry/vec2.h"

namespace docent::import {

constexpr std::uint32_t no_arc = 0xffffffff;

/// A straight stroke of a drawing; curves are many of them.
struct DrawnSegment {
  Vec2 a{}, b{};
  std::uint32_t layer = 0;     ///< Index into Drawing::layers.
  bool of_curve = false;       ///< A piece of an arc, a circle, an ellipse or a spline.
  std::uint32_t arc = no_arc;  ///< Index into Drawing::arcs, where it is a piece of one.
  bool of_block = false;       ///< Came with a block (INSERT): a door, a chair, a basin.
  bool dashed = false;         ///< In dashes and dots, as axes are, and what is overhead.
};

/// A circular arc, counter-clockwise or clockwise from `start` to `end`. Its strokes are in
/// Drawing::segments too.
struct DrawnArc {
  Vec2 centre{}, start{}, end{};
  double radius = 0;
  double sweep = 0;  ///< Radians, positive.
  std::uint32_t layer = 0;
};

/// A closed outline, drawn in one go. Its strokes are in Drawing::segments too.
struct DrawnRing {
  std::vector<Vec2> corners{};
  std::uint32_t layer = 0;
  std::uint32_t line = 0;  ///< Of the source.
};

struct DrawnText {
  std::string text{};  ///< UTF-8, without codes of formatting; lines are parted by '\n'.
  Vec2 at{};           ///< In the middle of the letters, as far as the file tells.
  double height = 0;
  std::uint32_t layer = 0;
};

/// A flat drawing as CAD and vector programs keep it: strokes without meaning, on named layers.
/// Frame: the drawing's own, y up, in its own unit.
struct Drawing {
  std::vector<std::string> layers{};
  std::vector<DrawnSegment> segments{};
  std::vector<DrawnArc> arcs{};
  std::vector<DrawnRing> rings{};
  std::vector<DrawnText> texts{};
  std::optional<double> metres_per_unit{};  ///< As the file states it.
  std::string unit{};                       ///< Its name: `mm`; empty where nothing is stated.
  std::map<std::string, std::size_t>
      left_out{};  ///< What was not taken over, by its name: how many.
};

}  // namespace docent::import
