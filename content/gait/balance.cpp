#include "content/gait/balance.h"

#include <algorithm>
#include <cmath>

#include "content/gait/gait_figures.h"

namespace docent::gait {
namespace {

/// Metres forward of the ankle, on the walker of 1.70 m: where pressure begins and ends on a foot,
/// and where it rests in standing.
constexpr double heel_pressure = -0.020, ball_pressure = 0.105, standing_pressure = 0.035;
/// Seconds of the last weight shift, from the last strike to standing on both feet.
constexpr double last_shift = 0.36;

GroundPoint on_foot(const Footstep& step, double forward) {
  return step.ankle + forward_of(step.yaw) * forward;
}

GroundPoint mix(GroundPoint a, GroundPoint b, double share) {
  return a + (b - a) * share;
}

/// Share of the weight that has come onto step k at a time, from the foot before.
double taken_over(std::span<const Footstep> steps, std::size_t k, double time) {
  const Footstep& step = steps[k];
  if (stands_from_the_start(step)) {
    if (k == 0) return 1;
    // The second foot stands alone when the first has left.
    return 0.5 + 0.5 * ease((time - 0.16) / (steps[0].toe_off - 0.16));
  }
  const double leaves = steps[k - 1].toe_off;
  const bool last = leaves > far_away;
  const double end = last ? step.strike + last_shift : leaves;
  return (last ? 0.5 : 1.0) * ease((time - step.strike) / (end - step.strike));
}

/// The last step that weight has begun to come onto.
std::size_t current_step(std::span<const Footstep> steps, double time) {
  std::size_t k = 1;
  while (k + 1 < steps.size() && steps[k + 1].strike <= time) ++k;
  return k;
}

GroundPoint standing_place(const Footstep& a, const Footstep& b) {
  return mix(on_foot(a, standing_pressure), on_foot(b, standing_pressure), 0.5);
}

/// On the foot that stands while the other closes up beside it: inward already, so that the body
/// comes to rest when both feet do.
GroundPoint closing_pressure(const Footstep& stands, const Footstep& closes) {
  return mix(on_foot(stands, 0.05), standing_place(stands, closes), 0.45);
}

/// From quiet standing on steps 0 and 1 to standing on step 1 alone.
GroundPoint pressure_before_walking(std::span<const Footstep> steps, double time) {
  const GroundPoint rest = standing_place(steps[0], steps[1]);
  const double leaves = steps[0].toe_off;
  const GroundPoint back = mix(rest, on_foot(steps[0], -0.025), 0.42);
  if (time < 0.26) return mix(rest, back, ease(time / 0.26));
  return mix(back, on_foot(steps[1], 0.0), ease((time - 0.26) / (leaves - 0.26)));
}

GroundPoint pressure_at(std::span<const Footstep> steps, double time) {
  const std::size_t k = current_step(steps, time);
  const Footstep& now = steps[k];
  const Footstep& before = steps[k - 1];
  const bool from_standing = stands_from_the_start(now);
  if (from_standing && time < before.toe_off) return pressure_before_walking(steps, time);
  if (before.toe_off > far_away)  // The last step: both feet stay.
    return mix(closing_pressure(before, now), standing_place(before, now),
               ease((time - now.strike) / last_shift));
  const double heel = from_standing ? 0.0 : heel_pressure;
  if (time < before.toe_off) {
    const double share = (time - now.strike) / (before.toe_off - now.strike);
    return mix(on_foot(before, ball_pressure), on_foot(now, heel), ease(share));
  }
  if (k + 1 == steps.size()) return on_foot(now, standing_pressure);
  const double share =
      std::clamp((time - before.toe_off) / (steps[k + 1].strike - before.toe_off), 0.0, 1.0);
  if (now.toe_off > far_away)  // The other foot closes up.
    return mix(on_foot(now, heel), closing_pressure(now, steps[k + 1]), share);
  return on_foot(now, heel + (ball_pressure - heel) * share);
}

}  // namespace

Loading loading_of(std::span<const Footstep> steps, const FrameTimes& times) {
  Loading loading;
  for (std::size_t f = 0; f < times.count; ++f) {
    const double time = times.at(f);
    const std::size_t k = current_step(steps, time);
    const double share = taken_over(steps, k, time);
    const double left = steps[k].foot == Side::Left ? share : 1 - share;
    loading.left.push_back(left);
    loading.right.push_back(1 - left);
  }
  return loading;
}

std::vector<GroundPoint> centre_of_pressure(std::span<const Footstep> steps,
                                            const FrameTimes& times) {
  std::vector<GroundPoint> pressure;
  pressure.reserve(times.count);
  for (std::size_t f = 0; f < times.count; ++f) pressure.push_back(pressure_at(steps, times.at(f)));
  return pressure;
}

/// x'' = w^2 (x - p) has one solution that does not run away: p weighted by exp(-w |t|), which is
/// one pass forwards and one backwards of a first-order filter.
std::vector<GroundPoint> balanced_mass(std::span<const GroundPoint> pressure, double rate) {
  constexpr double gravity = 9.81;
  constexpr double height = 0.94;  // Of the mass over the floor, metres, for the walker of 1.70 m.
  const double keep = std::exp(-std::sqrt(gravity / height) / rate);
  std::vector<GroundPoint> mass(pressure.begin(), pressure.end());
  for (std::size_t f = 1; f < mass.size(); ++f) mass[f] = mix(mass[f], mass[f - 1], keep);
  for (std::size_t f = mass.size() - 1; f-- > 0;) mass[f] = mix(mass[f], mass[f + 1], keep);
  return mass;
}

void smooth(std::vector<double>& values, double rate, double sigma) {
  const auto reach = static_cast<std::ptrdiff_t>(std::ceil(3.2 * sigma * rate));
  std::vector<double> kernel;
  double total = 0;
  for (std::ptrdiff_t k = -reach; k <= reach; ++k) {
    const double t = static_cast<double>(k) / (sigma * rate);
    kernel.push_back(std::exp(-0.5 * t * t));
    total += kernel.back();
  }
  const std::vector<double> rough = values;
  const auto last = static_cast<std::ptrdiff_t>(rough.size()) - 1;
  for (std::ptrdiff_t f = 0; f <= last; ++f) {
    double sum = 0;
    for (std::ptrdiff_t k = -reach; k <= reach; ++k)
      sum += kernel[static_cast<std::size_t>(k + reach)] *
             rough[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(f + k, 0, last))];
    values[static_cast<std::size_t>(f)] = sum / total;
  }
}

}  // namespace docent::gait
