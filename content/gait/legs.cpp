#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "content/gait/body_motion.h"
#include "content/gait/gait_figures.h"
#include "content/gait/gait_skeleton.h"
#include "runtime/model/motion/variation.h"

namespace docent::gait {
namespace {

constexpr double degree = 0.017453292519943295;
/// Metres from the walker's hip to the ankle with the knee at its straightest, 3.5 degrees: it
/// never locks.
const double longest_reach = std::sqrt(walker::thigh * walker::thigh + walker::shin * walker::shin +
                                       2 * walker::thigh * walker::shin * std::cos(3.5 * degree));

double reach_at(double knee) {
  return std::sqrt(walker::thigh * walker::thigh + walker::shin * walker::shin +
                   2 * walker::thigh * walker::shin * std::cos(knee));
}

/// The knee of a foot in stance, radians.
double normative_knee(const Footstep& step, double time) {
  const double cycle =
      std::clamp((step.toe_off - step.strike) / gait_figures::stance_share, 0.9, 1.5);
  const double loading = through(gait_figures::knee_loading(), (time - step.strike) / cycle);
  const double release = through(gait_figures::knee_release(), (time - step.toe_off) / cycle);
  return degree * (gait_figures::knee_at_ease + loading * std::min(step.length_in, 1.1) +
                   release * std::min(step.length_out, 1.1));
}

/// Seconds before its foot strikes in which a leg begins to hold the body.
constexpr double takes_over_before = 0.23;

/// The placing that a foot stands on, or is about to.
const Footstep& placing_at(std::span<const Footstep> placings, double time) {
  std::size_t k = 0;
  while (k + 1 < placings.size() && placings[k + 1].strike - takes_over_before <= time) ++k;
  return placings[k];
}

/// The left leg's share in how high the body is held; the rest is the right one's. A leg takes over
/// before its foot strikes and not when the weight comes onto it, so that it meets the ground bent
/// and ready to yield: near straight, a millimetre of height is two degrees of the knee.
double hold_of_left(std::span<const Footstep> steps, double time, const Loading& loading,
                    std::size_t frame) {
  constexpr double step_time = 0.36;  // seconds in which no other foot is about to strike
  for (std::size_t k = 0; k + 1 < steps.size(); ++k) {
    const Footstep& step = steps[k];
    const double since = time - step.strike;
    if (stands_from_the_start(step) || since < -takes_over_before || since > step_time) continue;
    const double share = ease(1 + since / takes_over_before);
    return step.foot == Side::Left ? share : 1 - share;
  }
  return loading.left[frame];
}

/// Metres over the floor: where a leg holds the root, and beyond which it cannot reach.
struct Support {
  double held, highest;
};
Support support_of(const glm::dvec3& hip_from_root, GroundPoint root, const FootPose& foot,
                   double knee) {
  const double dx = root.x + hip_from_root.x - foot.ankle.x;
  const double dz = root.y + hip_from_root.z - foot.ankle.z;
  const double across = dx * dx + dz * dz;
  const auto over_ankle = [&](double length) {
    return foot.ankle.y - hip_from_root.y + std::sqrt(std::max(length * length - across, 0.04));
  };
  return {over_ankle(reach_at(knee)), over_ankle(longest_reach)};
}

/// Lowers a track wherever it exceeds a limit, and eases it down to there and up again over `sigma`
/// seconds on either side.
void keep_below(std::vector<double>& track, const std::vector<double>& limit, double rate,
                double sigma) {
  for (int pass = 0; pass < 4; ++pass) {
    std::vector<double> excess(track.size());
    double worst = 0;
    for (std::size_t f = 0; f < track.size(); ++f) {
      excess[f] = std::max(track[f] - limit[f], 0.0);
      worst = std::max(worst, excess[f]);
    }
    if (worst < 1e-5) return;
    // The widest excess in reach, so that smoothing does not let the peak through.
    const auto width = static_cast<std::size_t>(sigma * rate);
    std::vector<double> widened(track.size());
    for (std::size_t f = 0; f < track.size(); ++f)
      for (std::size_t g = f < width ? 0 : f - width; g <= std::min(f + width, track.size() - 1);
           ++g)
        widened[f] = std::max(widened[f], excess[g]);
    smooth(widened, rate, 0.5 * sigma);
    for (std::size_t f = 0; f < track.size(); ++f) track[f] -= widened[f];
  }
}

}  // namespace

LegRotations reach(const glm::dvec3& hip, const FootPose& foot, double pelvis_heading) {
  constexpr double thigh = walker::thigh;
  constexpr double shin = walker::shin;
  const glm::dvec3 line = foot.ankle - hip;
  const double length = std::clamp(glm::length(line), std::abs(thigh - shin) + 0.02, longest_reach);
  const double knee_cosine = (length * length - thigh * thigh - shin * shin) / (2 * thigh * shin);
  const double knee = std::acos(std::clamp(knee_cosine, -1.0, 1.0));
  const double lead = std::atan2(shin * std::sin(knee), thigh + shin * std::cos(knee));

  // The hinge of the knee lies across the knee's direction, which is between pelvis' and toes'.
  const double yaw = pelvis_heading + 0.55 * (foot.yaw - pelvis_heading);
  const glm::dvec3 down = line / glm::length(line);
  const glm::dvec3 forward{std::sin(yaw), 0, std::cos(yaw)};
  const glm::dvec3 hinge = glm::normalize(glm::cross(-down, forward));
  const glm::dvec3 ahead = glm::cross(hinge, -down);
  const glm::dquat straight = glm::quat_cast(glm::dmat3(hinge, -down, ahead));
  LegRotations leg;
  leg.knee = knee;
  leg.thigh = straight * glm::angleAxis(-lead, glm::dvec3{1, 0, 0});
  leg.shin = leg.thigh * glm::angleAxis(knee, glm::dvec3{1, 0, 0});
  const glm::dquat turned = glm::angleAxis(foot.yaw, glm::dvec3{0, 1, 0});
  leg.foot = turned * glm::angleAxis(-foot.pitch, glm::dvec3{1, 0, 0});
  leg.toes = turned * glm::angleAxis(-foot.toe_pitch, glm::dvec3{1, 0, 0});
  return leg;
}

std::vector<glm::dvec3> root_places(std::span<const Footstep> steps, const Pace& pace,
                                    std::uint32_t seed) {
  // Standing, the body's mass is a little before the hips; walking, the hips are ahead of it.
  // Metres, of the walker of 1.70 m.
  constexpr double mass_ahead_standing = 0.020, mass_ahead_walking = -0.038;
  const FrameTimes& times = pace.times;
  const std::vector<GroundPoint> mass = balanced_mass(centre_of_pressure(steps, times), times.rate);
  const std::vector<Footstep> placings[2] = {placings_of(steps, Side::Left),
                                             placings_of(steps, Side::Right)};
  std::vector<double> height(times.count), highest(times.count, 2.0);
  std::vector<GroundPoint> ground(times.count);
  for (std::size_t f = 0; f < times.count; ++f) {
    const double time = times.at(f);
    const double mass_ahead =
        mass_ahead_standing + pace.vigour[f] * (mass_ahead_walking - mass_ahead_standing);
    ground[f] = mass[f] - forward_of(pace.heading[f]) * mass_ahead;
    const glm::dquat pelvis = upper_body_at(pace, f, seed).pelvis;
    const double left = hold_of_left(steps, time, pace.loading, f);
    for (std::size_t side = 0; side < 2; ++side) {
      const double out = side == 0 ? 1 : -1;
      const glm::dvec3 hip = pelvis * glm::dvec3{out * walker::hip_half, -walker::hip_drop, 0};
      const double share = side == 0 ? left : 1 - left;
      const double knee = normative_knee(placing_at(placings[side], time), time);
      const Support support = support_of(hip, ground[f], foot_at(placings[side], time), knee);
      height[f] += share * support.held;
      highest[f] = std::min(highest[f], support.highest);
    }
  }
  smooth(height, times.rate, 0.012);
  keep_below(height, highest, times.rate, 0.028);
  std::vector<glm::dvec3> places;
  places.reserve(times.count);
  for (std::size_t f = 0; f < times.count; ++f)
    places.emplace_back(ground[f].x, height[f], ground[f].y);
  return places;
}

}  // namespace docent::gait
