#pragma once

#include <algorithm>

#include "runtime/path/flatten.h"
#include "runtime/path/way.h"

namespace docent::path {

/// Appends a way that begins where `way` ends. Both are Ok.
inline void join(Way& way, const Way& next) {
  way.length += next.length;
  way.clearance_min = std::min(way.clearance_min, next.clearance_min);
  for (const Vec2 point : next.points) append_point(point, way.points);
}

}  // namespace docent::path
