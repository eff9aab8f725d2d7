#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "runtime/model/geometry/floor_plan.h"

namespace docent {

/// A leaf on its hinges. Floor frame, metres.
struct HungLeaf {
  Vec2 hinge{};
  Vec2 along{1, 0};   ///< From the hinge to its free end where it is closed; of length 1.
  Vec2 across{0, 1};  ///< Square to that: where it is turned to by a positive angle.
  double width = 1;
};

/// Where a leaf turned by an angle (radians, from closed) points, and what of it looks back to
/// where it was turned from. Of length 1.
Vec2 direction_of(const HungLeaf& leaf, double angle) noexcept;

/// The smallest angle of at least 0 by which the leaf must be turned so that a disc that pushes it
/// on is clear of it; 0 where it is far. At most a little more than a right angle.
double angle_clear_of(const HungLeaf& leaf, Vec2 middle, double radius) noexcept;

/// The distance between a leaf turned by an angle and a point.
double distance_to_leaf(const HungLeaf& leaf, double angle, Vec2 point) noexcept;

/// Of two leaves, is one enough to go through?
inline bool is_wide_enough(const HungLeaf& leaf) noexcept {
  constexpr double width = 0.8;
  return leaf.width >= width;
}

/// The leaves of a door, one or two; none where it has none. A positive angle turns each to the
/// left of the line from a to b.
struct HungLeaves {
  std::array<HungLeaf, 2> leaf{};
  std::size_t count = 0;
  std::span<const HungLeaf> all() const noexcept { return std::span(leaf).first(count); }
};
HungLeaves leaves_of(const FloorPlan& plan, const Door& door) noexcept;

}  // namespace docent
