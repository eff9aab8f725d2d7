#pragma once

#include <array>
#include <optional>

#include "runtime/guide/leaf_grip.h"
#include "runtime/model/motion/skeleton.h"
#include "runtime/motion/pose.h"
#include "runtime/motion/touch.h"

namespace docent::guide {

/// Where somebody stands to open a leaf with a hand: one who pulls, beside its free end and out of
/// what it sweeps; one who slides it, right before it.
struct DoorStop {
  Placement stand;
  Grasp grasp;
  double held = 0;  ///< How far the hand takes it: radians, or metres of one that slides.
};

/// A leaf that is closed, seen by who stands where `across` points, and where they will walk
/// through.
struct ClosedLeaf {
  HungLeaf hung;
  bool slides = false;
  double passed_at = 0.5;  ///< Metres from the hinge.
  double floor_height = 0;
  Vec2 comes_from{};  ///< From where they go straight to where they stop ...
  double faces = 0;   ///< ... and the heading with which they come there.
};

/// A body that stands, as its arms feel it.
struct Holder {
  const Skeleton& skeleton;
  const motion::Arms& arms;
  Placement body;
  /// What each arm hangs on, by Side. World frame.
  std::array<motion::JointPlace, 2> trunk{};
  Vec3 waist{};       ///< About which it bends.
  double height = 1;  ///< Times as high as its skeleton it is drawn.
};

/// Which hand takes a leaf, and how far, from where the body stands; none where no hand holds it
/// for long enough. Does not allocate.
std::optional<DoorStop> reach_leaf(const ClosedLeaf& leaf, const Holder& holder) noexcept;

/// Metres before a leaf that slides, where who slides it stands, or a little nearer or farther.
inline constexpr double before_slide = 0.5;

/// The places from which it may be opened.
struct DoorStands {
  std::array<Placement, 80> stand{};
  std::size_t count = 0;
};
DoorStands stands_at(const ClosedLeaf& leaf) noexcept;
/// The body there, held as it is now.
Holder moved(const Holder& holder, const Placement& stand) noexcept;
/// How who stands there bends to a leaf that is open so far, to take it farther: turned to the bar,
/// that shoulder first, and leaning to it the more the farther that is.
motion::TrunkBend bend_to(const ClosedLeaf& leaf, const Placement& body, const Grasp& grasp,
                          double amount) noexcept;
/// The same, so far on its way to stand upright again: 0 to 1.
motion::TrunkBend straightening(const motion::TrunkBend& bend, double share) noexcept;
/// Does the hand of a body that is bent as it will be hold the leaf where it is open so far?
bool holds_leaf(const ClosedLeaf& leaf, const Holder& holder, const Grasp& grasp,
                double amount) noexcept;
/// How good a stop is, the more the better.
double worth_of(const ClosedLeaf& leaf, const DoorStop& stop) noexcept;
/// How far who comes turns to go there: radians.
double bend_before(const ClosedLeaf& leaf, const DoorStop& stop) noexcept;

}  // namespace docent::guide
