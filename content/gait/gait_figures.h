#pragma once

#include <array>
#include <span>

namespace docent::gait {

/// Normative figures of healthy adults who walk at a comfortable pace, restated as small tables of
/// our own.
///
/// The cycle runs from 0, heel strike, to 1, the next heel strike of the same foot. Angles are in
/// degrees here, as the literature prints them, and flexion and toe-up are positive. They hold for
/// any stature; metres are those of the walker of 1.70 m (gait_skeleton.h).
///
/// Sources: D. A. Winter, "The Biomechanics and Motor Control of Human Gait" (1991) and
/// "Biomechanics and Motor Control of Human Movement" (4th ed., 2009; natural cadence);
/// J. Perry and J. M. Burnfield, "Gait Analysis: Normal and Pathological Function" (2nd ed., 2010);
/// M. P. Murray, "Gait as a total pattern of movement" (1967; trunk and arms); N. Sekiya and
/// H. Nagasaki (1998; walk ratio). The numbers are read off their curves to about a degree.
namespace gait_figures {

/// A curve over the cycle c as a mean and two harmonics, degrees (p1, p2: shares of the cycle):
/// mean + a1 cos(2 pi (c - p1)) + a2 cos(4 pi (c - p2)).
struct Harmonics {
  double mean, a1, p1, a2, p2;
};
double value_at(const Harmonics& curve, double cycle) noexcept;

/// Over the left foot's cycle. Positive: the pelvis' left side up, left side forward, front down.
inline constexpr Harmonics pelvis_obliquity{0, 3.4, 0.13, 0.9, 0.10};
inline constexpr Harmonics pelvis_rotation{0, 4.6, 0.98, 0.4, 0.0};
inline constexpr Harmonics pelvis_tilt{3.0, 0, 0, 1.1, 0.45};
/// The thorax in the world frame, over the same cycle and with the same signs: it turns against the
/// pelvis, stays nearly level and leans a little forward.
inline constexpr Harmonics thorax_rotation{0, 3.6, 0.49, 0.3, 0.0};
inline constexpr Harmonics thorax_obliquity{0, 1.2, 0.60, 0.3, 0.1};
inline constexpr Harmonics thorax_tilt{2.5, 0, 0, 0.9, 0.55};
/// The arm over the cycle of its own side's foot: furthest back at heel strike, furthest forward
/// half a cycle later.
inline constexpr Harmonics shoulder_flexion{-3.0, 8.0, 0.52, 0.5, 0.1};
inline constexpr Harmonics elbow_flexion{24.0, 6.5, 0.55, 1.0, 0.1};

/// A knot of a curve: the share of the cycle or of swing, and the value there.
struct Knot {
  double at, value;
};

/// Degrees of knee flexion that stance adds after heel strike (loading response), by the share of
/// the cycle since the strike.
std::span<const Knot> knee_loading() noexcept;
/// Degrees of knee flexion that push-off adds, by the share of the cycle since toe-off (negative).
std::span<const Knot> knee_release() noexcept;
/// Degrees of knee flexion in quiet stance; what stance and push-off add comes on top.
inline constexpr double knee_at_ease = 4.5;

/// Pitch of the foot against the floor at heel strike and just before toe-off, degrees, for a full
/// step.
inline constexpr double strike_pitch = 21;
inline constexpr double toe_off_pitch = -62;
/// The foot's pitch inside swing, degrees by share of swing; the values at both ends are stance's.
std::span<const Knot> swing_pitch() noexcept;
/// How far the ball of the foot is above its height when flat inside swing: metres, of the walker
/// of 1.70 m, by share of swing, for a full step.
std::span<const Knot> swing_ball_rise() noexcept;

/// Stance takes 60 % of the cycle: each double support takes 10 %. Shares of the cycle since
/// strike: foot flat, and heel off.
inline constexpr double stance_share = 0.60;
inline constexpr double flat_share = 0.085;
inline constexpr double heel_off_share = 0.32;

/// Step length over cadence, metres per (steps a minute): what adults keep when they change speed.
inline constexpr double walk_ratio = 0.0058;

}  // namespace gait_figures

/// A smooth curve through knots (monotone between them, Fritsch and Carlson 1980), constant beyond.
double through(std::span<const gait_figures::Knot> knots, double at) noexcept;

/// The smoothest curve through knots that has the given slopes at its ends (clamped cubic spline).
double spline(std::span<const gait_figures::Knot> knots, double first_slope, double last_slope,
              double at);

/// 0 at 0, 1 at 1, with no velocity or acceleration at either end.
double ease(double share) noexcept;

}  // namespace docent::gait
