#pragma once

#include <cstdint>

#include "content/import/drawing/arrangement.h"

namespace docent::import {

/// What an edge of the arrangement is; less wins where two lie on one another.
enum LineKind : std::uint32_t { Wall = 0, Window = 1, LeafLine = 2, GapLine = 3, SealLine = 4 };

inline double length_of(const WallLine& line) {
  return glm::length(line.b - line.a);
}

}  // namespace docent::import
