#pragma once

#include <string_view>
#include <vector>

#include "runtime/model/geometry/vec2.h"

namespace docent::import {

/// A piece of a path between two moves.
struct SubPath {
  std::vector<Vec2> points;
  bool closed = false;
};

/// The path data of SVG 2, section 9.3, with its curves as chords. Reads as far as the data is
/// right, as the specification asks, and never fails; at most 100,000 points.
std::vector<SubPath> parse_path(std::string_view data);

/// The numbers of a list, parted by blanks or commas; reads as far as there are any.
std::vector<double> parse_numbers(std::string_view text);

}  // namespace docent::import
