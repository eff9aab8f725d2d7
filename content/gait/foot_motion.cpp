#include "content/gait/foot_motion.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "content/gait/gait_figures.h"
#include "content/gait/gait_skeleton.h"

namespace docent::gait {
namespace {

/// Speed of the heel at the end of a full swing, metres a second (adults; Winter 1992: 0.4 to 1).
constexpr double strike_speed = 0.12;
/// By how much of a stride the foot is ahead of the smoothest motion, at most.
constexpr double early_progress = 0.06;

/// Seconds of a whole cycle, for the shares of stance: stance takes 60 % of it.
double cycle_of(const Footstep& step) {
  const double stance = step.toe_off - step.strike;
  return std::clamp(stance / gait_figures::stance_share, 0.9, 1.5);
}

double pitch_at_strike(const Footstep& step) {
  // A foot that closes up beside the other comes down almost flat.
  return gait_figures::strike_pitch * radians * std::clamp(1.35 * step.length_in - 0.35, 0.05, 1.1);
}
double pitch_at_toe_off(const Footstep& step) {
  return gait_figures::toe_off_pitch * radians *
         std::clamp(0.35 + 0.65 * step.length_out, 0.0, 1.1);
}

/// From `value` with `rate` (per unit of share) at share 0 to nothing at 1, with no velocity or
/// acceleration there: a quintic with no acceleration at 0 either.
double settle(double value, double rate, double share) {
  const double t = std::clamp(share, 0.0, 1.0);
  const double t3 = t * t * t;
  return value * (1 - t3 * (10 - 15 * t + 6 * t * t)) + rate * (t - t3 * (6 - 8 * t + 3 * t * t));
}

/// Ankle of a foot that turns about a point `forward` metres ahead of the ankle's own place and
/// `height` metres over the floor.
glm::dvec3 ankle_about(GroundPoint ankle, double yaw, double pitch, double forward, double height) {
  const double along = -forward;  // From the pivot to the ankle, flat.
  const double up = walker::ankle_height - height;
  const double z = along * std::cos(pitch) - up * std::sin(pitch);
  const double y = along * std::sin(pitch) + up * std::cos(pitch);
  const GroundPoint ground = ankle + forward_of(yaw) * (forward + z);
  return {ground.x, height + y, ground.y};
}

FootPose stance_pose(const Footstep& step, double time) {
  const double cycle = cycle_of(step);
  const double flat = step.strike + gait_figures::flat_share * cycle;
  const double heel_off =
      step.toe_off - (gait_figures::stance_share - gait_figures::heel_off_share) * cycle;
  FootPose pose{.yaw = step.yaw};
  if (time < flat) {
    const double share = (time - step.strike) / (flat - step.strike);
    pose.pitch = settle(pitch_at_strike(step), -0.9 * pitch_at_strike(step), share);
    pose.toe_pitch = pose.pitch;
    pose.ankle = ankle_about(step.ankle, step.yaw, pose.pitch, -walker::heel_behind, 0);
    return pose;
  }
  if (time > heel_off) {
    const double share = 1 - (time - heel_off) / (step.toe_off - heel_off);
    // Slowly at first, then quicker and quicker until the toes leave.
    pose.pitch = settle(pitch_at_toe_off(step), -2.1 * pitch_at_toe_off(step), share);
  }
  pose.ankle =
      ankle_about(step.ankle, step.yaw, pose.pitch, walker::ankle_to_ball, walker::ball_height);
  return pose;
}

/// The ball of the foot under an ankle.
glm::dvec3 ball_of(const FootPose& pose) {
  const double down = walker::ball_height - walker::ankle_height;
  const double z = walker::ankle_to_ball * std::cos(pose.pitch) - down * std::sin(pose.pitch);
  const double y = walker::ankle_to_ball * std::sin(pose.pitch) + down * std::cos(pose.pitch);
  const GroundPoint forward = forward_of(pose.yaw);
  return pose.ankle + glm::dvec3{forward.x * z, y, forward.y * z};
}

/// Place and pitch of a foot, and how fast they change: metres, radians, seconds.
struct MovingFoot {
  glm::dvec3 ball{}, velocity{};
  double pitch = 0, pitch_rate = 0;
};

MovingFoot moving_at(const Footstep& step, double time, double dt) {
  const FootPose now = stance_pose(step, time);
  const FootPose then = stance_pose(step, time + dt);
  return {ball_of(now), (ball_of(then) - ball_of(now)) / dt, now.pitch,
          (then.pitch - now.pitch) / dt};
}

/// Quintic from a to b with given velocities and no acceleration at the ends; u in [0, 1], the
/// velocities per unit of u.
template <typename T>
T quintic(T a, T velocity_a, T b, T velocity_b, double u) {
  const double u3 = u * u * u;
  const double h = u3 * (10 - 15 * u + 6 * u * u);
  const double start = u - u3 * (6 - 8 * u + 3 * u * u);
  const double end = u3 * (-4 + 7 * u - 3 * u * u);
  return a * (1 - h) + b * h + velocity_a * start + velocity_b * end;
}

/// A value at an end of swing and how fast it changes there, over the whole swing.
struct SwingEnd {
  double value, rate;
};

/// A curve through swing: stance's own value and velocity at both ends, `inside` between them.
double through_swing(SwingEnd off, std::span<const gait_figures::Knot> inside, SwingEnd on,
                     double u) {
  std::vector<gait_figures::Knot> knots{{0, off.value}};
  knots.insert(knots.end(), inside.begin(), inside.end());
  knots.push_back({1, on.value});
  return spline(knots, off.rate, on.rate, u);
}

/// The normative pitch, its toes-down part as deep as this toe-off, its toes-up part as high as
/// this strike.
double swing_pitch(const MovingFoot& off, const MovingFoot& on, double duration, double u) {
  const double push = off.pitch / gait_figures::toe_off_pitch;
  const double strike = on.pitch / gait_figures::strike_pitch;
  std::vector<gait_figures::Knot> inside;
  for (const gait_figures::Knot& knot : gait_figures::swing_pitch())
    inside.push_back({knot.at, knot.value * (knot.value < 0 ? push : strike)});
  return through_swing({off.pitch, off.pitch_rate * duration}, inside,
                       {on.pitch, on.pitch_rate * duration}, u);
}

/// The normative rise of the ball of the foot: lower for a short step, and in its last part only as
/// high as the toes are up.
double swing_height(const MovingFoot& off, const MovingFoot& on, double duration, double length,
                    double u) {
  const double strike = on.pitch / (radians * gait_figures::strike_pitch);
  std::vector<gait_figures::Knot> inside;
  for (const gait_figures::Knot& knot : gait_figures::swing_ball_rise()) {
    const double share = knot.at < 0.7 ? 0.45 + 0.55 * length : 0.15 + 0.85 * strike;
    inside.push_back({knot.at, walker::ball_height + share * knot.value});
  }
  return through_swing({off.ball.y, off.velocity.y * duration}, inside,
                       {on.ball.y, on.velocity.y * duration}, u);
}

FootPose swing_pose(const Footstep& from, const Footstep& to, double time) {
  constexpr double tick = 1e-4;
  const double duration = to.strike - from.toe_off;
  const double u = (time - from.toe_off) / duration;
  const MovingFoot off = moving_at(from, from.toe_off - tick, tick);
  const MovingFoot on = moving_at(to, to.strike, tick);
  const double full = std::clamp(to.length_in, 0.0, 1.1);

  FootPose pose;
  pose.yaw = from.yaw + (to.yaw - from.yaw) * ease((u - 0.05) / 0.85);
  pose.pitch = swing_pitch(off, on, duration, u);

  // The heel strikes while the foot still goes forward; the floor stops it.
  const GroundPoint ahead = forward_of(to.yaw) * (strike_speed * full);
  const glm::dvec3 arrival = on.velocity + glm::dvec3{ahead.x, 0, ahead.y};
  glm::dvec3 ball = quintic(off.ball, off.velocity * duration, on.ball, arrival * duration, u);
  // The hip's pull-off brings the foot forward early in swing, more than the smoothest motion
  // would.
  const double rest = 1 - u;
  ball += (on.ball - off.ball) * (early_progress * u * u * u * rest * rest * rest * rest / 0.00839);
  ball.y = swing_height(off, on, duration, full, u);
  const double down = walker::ball_height - walker::ankle_height;
  const double z = walker::ankle_to_ball * std::cos(pose.pitch) - down * std::sin(pose.pitch);
  const double y = walker::ankle_to_ball * std::sin(pose.pitch) + down * std::cos(pose.pitch);
  const GroundPoint forward = forward_of(pose.yaw);
  pose.ankle = ball - glm::dvec3{forward.x * z, y, forward.y * z};

  // The toes leave the floor last, then straighten.
  pose.toe_pitch = pose.pitch * ease(u / 0.52);
  return pose;
}

}  // namespace

FootPose foot_at(std::span<const Footstep> placings, double time) {
  std::size_t k = 0;
  while (k + 1 < placings.size() && placings[k + 1].strike <= time) ++k;
  const Footstep& step = placings[k];
  if (time <= step.toe_off || k + 1 == placings.size()) return stance_pose(step, time);
  return swing_pose(step, placings[k + 1], time);
}

}  // namespace docent::gait
