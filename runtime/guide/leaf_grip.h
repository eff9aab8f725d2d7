#pragma once

#include "runtime/model/geometry/hung_leaf.h"
#include "runtime/model/motion/side.h"
#include "runtime/motion/arm.h"

namespace docent::guide {

/// Where on a leaf's bar a hand is.
struct Grasp {
  Side side = Side::Right;  ///< The hand.
  double along = 0.5;       ///< Metres from the hinge.
};

/// How far a leaf is open.
struct Opening {
  bool slides = false;
  double amount = 0;  ///< Radians to where `across` points; metres of one that slides.
};

/// A leaf as who stands on one side of it sees it: by positive angles it turns to where a sign
/// says.
inline HungLeaf seen(const HungLeaf& leaf, double sign) noexcept {
  return {leaf.hinge, leaf.along, sign * leaf.across, leaf.width};
}

/// Of who pushes it on, by positive angles: the palm lies against the bar.
motion::Grip pushing_grip(const HungLeaf& leaf, double angle, const Grasp& grasp,
                          double floor_height) noexcept;

/// Of who stands where `across` points and draws it there, or slides it: the fingers are hooked
/// over the bar from above. `from`: where they stand; whatever the leaf does, the hand goes on from
/// the arm.
motion::Grip drawing_grip(const HungLeaf& leaf, const Opening& opening, const Grasp& grasp,
                          double floor_height, Vec2 from) noexcept;

/// The same hand, coming away: up off the bar, then back to who stands before a leaf that slides,
/// or out past the free end of one that turns, or it would be behind it. `share`: 0 to 1.
motion::Grip parting_grip(const HungLeaf& leaf, const Opening& opening, const Grasp& grasp,
                          double floor_height, Vec2 from, double share) noexcept;
inline constexpr double parting_seconds = 0.4;  ///< In which a hand comes away, ...
inline constexpr double parting_speed = 0.15;  ///< ... the leaf waits for it, radians a second, ...
inline constexpr double hanging_seconds = 0.5;  ///< ... until the arm hangs.
/// In which who has bent to a leaf stands upright again.
inline constexpr double straightening_seconds = parting_seconds + hanging_seconds;

}  // namespace docent::guide
