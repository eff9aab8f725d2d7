#pragma once

#include <span>
#include <string>
#include <vector>

#include "runtime/model/geometry/floor_plan.h"

namespace docent::command {

/// A line over a sketch, in the floor frame.
struct SketchLine {
  std::vector<Vec2> points;
  bool closed = false;
};

/// A floor and what is drawn over it.
struct FloorSketch {
  const FloorPlan& plan;
  std::vector<SketchLine> lines;
};

/// An SVG of floors' walls with lines over them, side by side, so that what lies above one another
/// is at the same height: what `--svg` writes for people who want to look at
/// an answer. (The `show` command draws the whole database.)
std::string sketch_plans(std::span<const FloorSketch> floors);
std::string sketch_plan(const FloorPlan& plan, std::vector<SketchLine> lines);

}  // namespace docent::command
