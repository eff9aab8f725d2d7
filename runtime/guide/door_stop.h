#pragma once

#include <array>
#include <optional>

#include "runtime/guide/leaf_grip.h"
#include "runtime/model/motion/skeleton.h"
#include "runtime/motion/pose.h"

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
  Vec2 comes_from{};  ///< Where they are now.
};

/// A body that stands, as its arms feel it.
struct Holder {
  const Skeleton& skeleton;
  const motion::Arms& arms;
  Placement body;
  /// What each arm hangs on, by Side. World frame.
  std::array<motion::JointPlace, 2> trunk{};
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
/// Does the hand hold the leaf where it is open so far?
bool holds_leaf(const ClosedLeaf& leaf, const Holder& holder, const Grasp& grasp,
                double amount) noexcept;
/// How good a stop is, the more the better.
double worth_of(const ClosedLeaf& leaf, const DoorStop& stop) noexcept;

}  // namespace docent::guide
