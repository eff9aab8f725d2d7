#pragma once

#include <string>
#include <vector>

#include "runtime/model/geometry/floor_plan.h"

namespace docent::command {

/// A line over a sketch, in the floor frame.
struct SketchLine {
  std::vector<Vec2> points;
  bool closed = false;
};

/// An SVG of a floor's walls with lines over it: what `--svg` writes for people who want to look at
/// an answer. (The `show` command draws the whole database.)
std::string sketch_plan(const FloorPlan& plan, const std::vector<SketchLine>& lines);

}  // namespace docent::command
