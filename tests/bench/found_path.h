#pragma once

#include <limits>
#include <vector>

#include "runtime/model/geometry/vec2.h"

namespace docent::bench {

/// What every way of finding a path answers: the whole path in memory.
struct FoundPath {
  double length =
      std::numeric_limits<double>::infinity();  ///< Metres; infinite where there is none.
  std::vector<Vec2> points{};                   ///< Both ends included.
};

}  // namespace docent::bench
