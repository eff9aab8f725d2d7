#pragma once

#include <cstdint>
#include <numbers>
#include <vector>

#include <glm/vec2.hpp>

#include "runtime/model/motion/side.h"

namespace docent::gait {

/// The ground of a gait clip: x to the left of the first walking direction, z along it, so that a
/// heading of 0 looks along +z and turning left is positive. Metres and radians.
using GroundPoint = glm::dvec2;
GroundPoint forward_of(double heading) noexcept;
GroundPoint left_of_heading(double heading) noexcept;

inline constexpr double radians = std::numbers::pi / 180;  ///< In a degree.

/// One placing of a foot, from its heel strike to its toe-off. Times in seconds.
struct Footstep {
  Side foot = Side::Left;
  GroundPoint ankle{};    ///< Under the ankle while the foot is flat.
  double yaw = 0;         ///< Heading in which the foot points.
  double heading = 0;     ///< In which the body goes, halfway through the step that ends here.
  double strike = 0;      ///< Long before any clip for feet that stand at the start.
  double toe_off = 0;     ///< Long after any clip for feet that stand at the end.
  double length_in = 0;   ///< Of the step that ends here, as a share of a full step.
  double length_out = 0;  ///< Of the step that this foot takes next, likewise.
};

/// Beyond it lies the "always" of a foot that stands. Seconds.
inline constexpr double far_away = 500;
inline bool stands_from_the_start(const Footstep& step) noexcept {
  return step.strike < -far_away;
}

/// What a clip is asked to do. Time 0 of the plan's clock is the middle of the turn (Walking), when
/// the weight begins to shift for the first step (FromStanding), or when the last foot comes down
/// (ToStanding).
struct GaitPlan {
  double speed = 1.1;       ///< Metres a second on the straight.
  double turn = 0;          ///< Radians, left positive; begins and ends straight.
  double turn_speed = 1.1;  ///< Metres a second in the middle of the turn.
  double turn_length = 1;   ///< Metres walked in the turn.
  enum class Kind : std::uint8_t { Walking, FromStanding, ToStanding } kind = Kind::Walking;
  Side first = Side::Left;  ///< Is placed at time 0; from standing, steps first.
  std::uint32_t seed = 1;   ///< For the variation from step to step.
};

/// The footsteps of a plan, by time of strike, from well before to well after any clip's frames.
///
/// Feet fall on both sides of a line; on a bend the inner foot's steps are therefore shorter and
/// its toes turn further. Speed, step length and cadence keep the walk ratio (gait_figures.h). From
/// standing the first step is short; to standing the last ones are, and the feet end side by side.
std::vector<Footstep> plan_footsteps(const GaitPlan& plan);

/// Seconds that an adult's step takes at a speed (metres a second), and its length in metres.
double step_duration(double speed) noexcept;
double step_length(double speed) noexcept;

}  // namespace docent::gait
