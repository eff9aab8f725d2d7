#include "content/gait/footsteps.h"

#include <algorithm>
#include <cmath>

#include "content/gait/gait_figures.h"
#include "runtime/model/motion/variation.h"

namespace docent::gait {

GroundPoint forward_of(double heading) noexcept {
  return {std::sin(heading), std::cos(heading)};
}
GroundPoint left_of_heading(double heading) noexcept {
  return {std::cos(heading), -std::sin(heading)};
}

double step_length(double speed) noexcept {
  return std::sqrt(60 * speed * gait_figures::walk_ratio);
}
double step_duration(double speed) noexcept {
  return step_length(speed) / speed;
}

namespace {

constexpr double always = 1e3;  ///< Seconds: beyond either end of any clip.
constexpr std::int64_t steps_each_way = 11;

/// Metres of the ankles from the line they walk on, for the walker of 1.70 m: half the stride
/// width, and half the distance in which one stands at ease. Toes point out a little (radians).
constexpr double walking_half_width = 0.055, standing_half_width = 0.085;
constexpr double walking_toe_out = 6 * radians, standing_toe_out = 8 * radians;

/// Standard deviations from step to step of healthy adults: shares of length and of time (Hausdorff
/// 2005; Terrier and Deriaz 2011: 2 to 3 %), metres of width (Owings and Grabiner 2004: some 2 cm
/// from foot to foot, of which each foot has its share), and of the angle of the foot.
constexpr double length_variation = 0.024, time_variation = 0.017, width_variation = 0.009;
constexpr double yaw_variation = 1.3 * radians;

enum Purpose : std::uint32_t { Length, Time, Width, Yaw };

/// The line that a plan walks along, `s` in metres: straight, a bend round s = 0 whose curvature
/// comes and goes softly, straight.
struct Way {
  const GaitPlan& plan;

  double heading(double s) const { return plan.turn * ease(s / plan.turn_length + 0.5); }

  double speed(double s) const {
    const double u = std::min(std::abs(s) / plan.turn_length, 1.0);
    const double dip = plan.turn == 0 ? 0 : 0.5 + 0.5 * std::cos(std::numbers::pi * u);
    return plan.speed + dip * (plan.turn_speed - plan.speed);
  }

  GroundPoint place(double s) const {
    constexpr double step = 0.004;
    const auto count = static_cast<int>(std::ceil(std::abs(s) / step));
    GroundPoint sum{0, 0};
    for (int k = 0; k < count; ++k) sum += forward_of(heading(s * (k + 0.5) / count));
    return count == 0 ? sum : sum * (s / count);
  }
};

/// Where along the line (metres) and when (seconds) a foot comes down.
struct Beat {
  double s = 0, strike = 0, half_width = walking_half_width, toe_out = walking_toe_out;
  double length = 1;  ///< Of the step that ends here, as a share of a full step.
};

/// Seconds of a step in a bend that slows the walker down to `speed`: people shorten their strides
/// there and hardly lower their cadence (Courtine and Schieppati 2003).
double duration_in_bend(const GaitPlan& plan, double speed) {
  constexpr double slower = 0.15;
  return step_duration(plan.speed) * std::pow(plan.speed / speed, slower);
}

double varied_length(const GaitPlan& plan, double speed, std::int64_t step) {
  return speed * duration_in_bend(plan, speed) *
         (1 + length_variation * fluctuation(plan.seed, step, Length));
}
double varied_duration(const GaitPlan& plan, double speed, std::int64_t step) {
  return duration_in_bend(plan, speed) * (1 + time_variation * fluctuation(plan.seed, step, Time));
}

/// The middle beat is at s = 0 and time 0; the others follow from it in both directions.
std::vector<Beat> walking_beats(const Way& way) {
  std::vector<Beat> beats(2 * steps_each_way + 1);
  for (const std::int64_t direction : {-1, 1})
    for (std::int64_t k = direction; std::abs(k) <= steps_each_way; k += direction) {
      const Beat& from = beats[static_cast<std::size_t>(steps_each_way + k - direction)];
      const double speed = way.speed(from.s + 0.3 * static_cast<double>(direction));
      const std::int64_t step = direction > 0 ? k : k + 1;  // It ends at the later beat.
      Beat& beat = beats[static_cast<std::size_t>(steps_each_way + k)];
      beat.s = from.s + static_cast<double>(direction) * varied_length(way.plan, speed, step);
      beat.strike =
          from.strike + static_cast<double>(direction) * varied_duration(way.plan, speed, step);
    }
  const double full = step_length(way.plan.speed);
  for (std::size_t k = 1; k < beats.size(); ++k)
    beats[k].length = (beats[k].s - beats[k - 1].s) / full;
  return beats;
}

/// Both feet stand until time 0; then weight shifts, the first foot leaves after half a second, and
/// the steps grow to full length (Breniere and Do 1986: steady by the third).
std::vector<Beat> starting_beats(const Way& way) {
  constexpr double weight_shift = 0.52;
  constexpr std::array<double, 3> growth{0.72, 0.93, 1.0};
  std::vector<Beat> beats(2, {.s = 0,
                              .strike = -always,
                              .half_width = standing_half_width,
                              .toe_out = standing_toe_out,
                              .length = 0});
  beats[1].s = 0.012;  // Nobody stands with the feet quite even.
  double strike = weight_shift;
  for (std::int64_t k = 0; k < 2 * steps_each_way; ++k) {
    const double share = k < 3 ? growth[static_cast<std::size_t>(k)] : 1.0;
    Beat beat;
    beat.s = beats.back().s + share * varied_length(way.plan, way.plan.speed, k);
    // The first foot is in the air from the end of the weight shift: a swing, not a whole step.
    strike += varied_duration(way.plan, way.plan.speed, k) * (k == 0 ? 0.86 : 1.0);
    beat.strike = strike;
    beat.length = share;
    if (k == 0) beat.half_width = 0.06;
    beats.push_back(beat);
  }
  return beats;
}

/// The last steps shorten and slow down; the last foot comes down beside the other at time 0.
std::vector<Beat> stopping_beats(const Way& way) {
  constexpr std::array<double, 4> shrink{0.0, 0.70, 1.0, 1.0};  // From the last step back.
  constexpr std::array<double, 4> slower{1.02, 1.02, 1.0, 1.0};
  std::vector<Beat> beats(1, {.s = 0.0,
                              .strike = 0,
                              .half_width = standing_half_width,
                              .toe_out = standing_toe_out,
                              .length = 0.34});
  double length_ahead = 0;
  for (std::int64_t k = 0; k < 2 * steps_each_way; ++k) {
    const auto near = static_cast<std::size_t>(std::min<std::int64_t>(k, 3));
    Beat beat;
    const Beat& after = beats.back();
    beat.strike = after.strike - slower[near] * varied_duration(way.plan, way.plan.speed, -k);
    length_ahead = shrink[near] * varied_length(way.plan, way.plan.speed, -k);
    beat.s = after.s - length_ahead;
    if (k == 0) {
      beat.s = -0.010;
      beat.half_width = 0.07;
      beat.toe_out = standing_toe_out;
    }
    beat.length = k < 2 ? shrink[near + 1] : 1.0;
    beats.push_back(beat);
  }
  std::ranges::reverse(beats);
  return beats;
}

std::vector<Beat> beats_of(const Way& way) {
  switch (way.plan.kind) {
    case GaitPlan::Kind::FromStanding:
      return starting_beats(way);
    case GaitPlan::Kind::ToStanding:
      return stopping_beats(way);
    case GaitPlan::Kind::Walking:
      break;
  }
  return walking_beats(way);
}

/// The index of the beat that `plan.first` falls on.
std::size_t middle_beat(const GaitPlan& plan, const std::vector<Beat>& beats) {
  switch (plan.kind) {
    case GaitPlan::Kind::FromStanding:
      return 2;
    case GaitPlan::Kind::ToStanding:
      return beats.size() - 1;
    case GaitPlan::Kind::Walking:
      break;
  }
  return static_cast<std::size_t>(steps_each_way);
}

/// When each foot leaves the ground: after a double support of a tenth of the cycle, a fifth of the
/// step, that the other foot began.
void set_toe_offs(const GaitPlan& plan, std::vector<Footstep>& steps) {
  constexpr double double_support = 2 * (gait_figures::stance_share - 0.5);
  for (std::size_t k = 0; k < steps.size(); ++k) {
    steps[k].toe_off = always;
    if (k + 2 >= steps.size()) continue;
    const double began = steps[k + 1].strike;
    const double step = steps[k + 2].strike - began;
    steps[k].toe_off = began + double_support * step;
    steps[k].length_out = steps[k + 2].length_in;
  }
  if (plan.kind != GaitPlan::Kind::FromStanding) return;
  // The first foot is lifted from under the body, without the roll of a step behind it.
  steps[0].toe_off = steps[2].strike - (1 - double_support) * step_duration(plan.speed);
  steps[0].length_out = 0.25;
}

}  // namespace

std::vector<Footstep> plan_footsteps(const GaitPlan& plan) {
  const Way way{plan};
  const std::vector<Beat> beats = beats_of(way);
  const std::size_t middle = middle_beat(plan, beats);
  std::vector<Footstep> steps;
  for (std::size_t k = 0; k < beats.size(); ++k) {
    const Beat& beat = beats[k];
    const bool same = (k % 2) == (middle % 2);
    const auto number = static_cast<std::int64_t>(k) - static_cast<std::int64_t>(middle);
    Footstep step{.foot = same ? plan.first : other(plan.first)};
    const double side = sign_of(step.foot);
    const double ahead = 0.25 * beat.length * step_length(plan.speed);
    step.heading = way.heading(beat.s);
    // Where the line bends towards this foot its toes lead; away from it, they follow.
    step.yaw = way.heading(beat.s + ahead) + side * beat.toe_out +
               yaw_variation * fluctuation(plan.seed, number, Yaw);
    const double width = beat.half_width + width_variation * fluctuation(plan.seed, number, Width);
    step.ankle = way.place(beat.s) + left_of_heading(step.heading) * (side * width);
    step.strike = beat.strike;
    step.length_in = beat.length;
    steps.push_back(step);
  }
  set_toe_offs(plan, steps);
  return steps;
}

}  // namespace docent::gait
