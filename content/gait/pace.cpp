#include <algorithm>
#include <cmath>

#include "content/gait/body_motion.h"
#include "content/gait/gait_figures.h"

namespace docent::gait {
namespace {

/// Knots of a quantity that is known when feet come down, linear between them and constant beyond.
struct KnottedCurve {
  std::vector<gait_figures::Knot> knots;

  double at(double time) const {
    const auto after = std::ranges::upper_bound(knots, time, {}, &gait_figures::Knot::at);
    if (after == knots.begin()) return knots.front().value;
    if (after == knots.end()) return knots.back().value;
    const auto before = after - 1;
    const double share = (time - before->at) / (after->at - before->at);
    return before->value + share * (after->value - before->value);
  }
};

std::vector<double> sampled(const KnottedCurve& track, const FrameTimes& times, double sigma) {
  std::vector<double> values;
  values.reserve(times.count);
  for (std::size_t f = 0; f < times.count; ++f) values.push_back(track.at(times.at(f)));
  smooth(values, times.rate, sigma);
  return values;
}

/// Into the bend, radians, by as much of the centripetal force as the trunk takes; the legs take
/// the rest. Speed and gravity in metres and seconds.
std::vector<double> lean_of(const Pace& pace) {
  constexpr double share_of_trunk = 0.55, full_speed = 1.05, gravity = 9.81;
  const std::vector<double>& heading = pace.heading;
  const double rate = pace.times.rate;
  std::vector<double> lean(heading.size());
  for (std::size_t f = 1; f < heading.size(); ++f) {
    const double speed = full_speed * pace.vigour[f];
    lean[f] = share_of_trunk * std::atan((heading[f] - heading[f - 1]) * rate * speed / gravity);
  }
  smooth(lean, rate, 0.10);
  return lean;
}

}  // namespace

Pace pace_of(std::span<const Footstep> steps, const FrameTimes& times) {
  KnottedCurve cycle, vigour, heading;
  const bool begins = stands_from_the_start(steps[1]);
  double phase = 0;
  for (std::size_t k = 1; k < steps.size(); ++k) {
    const Footstep& step = steps[k];
    if (stands_from_the_start(step)) continue;
    phase = cycle.knots.empty() ? (step.foot == Side::Left ? 0.0 : 0.5) : phase + 0.5;
    if (cycle.knots.empty() && begins) {
      cycle.knots.push_back({steps[0].toe_off - 0.15, phase - 0.42});
      vigour.knots.push_back({0.15, 0});
      heading.knots.push_back({0, step.heading});
    }
    const bool last = k + 1 == steps.size();
    const double next = last ? 0.0 : steps[k + 1].length_in;
    cycle.knots.push_back({step.strike, phase});
    vigour.knots.push_back({step.strike, 0.5 * (step.length_in + next)});
    heading.knots.push_back({step.strike, 0.5 * (steps[k - 1].heading + step.heading)});
  }
  const Footstep& last = steps.back();
  if (steps[steps.size() - 2].toe_off > far_away) vigour.knots.push_back({last.strike + 0.35, 0});

  Pace pace{.times = times,
            .cycle = sampled(cycle, times, 0.07),
            .vigour = sampled(vigour, times, 0.12),
            .heading = sampled(heading, times, 0.13),
            .lean = {},
            .loading = loading_of(steps, times)};
  pace.lean = lean_of(pace);
  return pace;
}

std::vector<Footstep> placings_of(std::span<const Footstep> steps, Side foot) {
  std::vector<Footstep> own;
  std::ranges::copy_if(steps, std::back_inserter(own),
                       [&](const Footstep& step) { return step.foot == foot; });
  return own;
}

}  // namespace docent::gait
