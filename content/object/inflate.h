#pragma once

#include <cstddef>
#include <vector>

#include "runtime/model/geometry/vec2.h"

namespace docent::object {

/// A cushion over an outline: as if it were of rubber, and blown up (Poisson's equation with
/// nothing at the outline). Round a limb of half a width w it is w high, and has no ridges where
/// the nearest side changes.
class Cushion {
 public:
  /// Of closed lines that do not cross, in any unit.
  explicit Cushion(const std::vector<std::vector<Vec2>>& rings);

  /// 0 on the outline and outside.
  double height_at(Vec2 p) const;
  double highest() const { return highest_; }

 private:
  double cell_ = 1, highest_ = 0;
  Vec2 low_{};
  std::size_t columns_ = 0, rows_ = 0;
  std::vector<double> squared_;  ///< Heights, by cell.
};

}  // namespace docent::object
