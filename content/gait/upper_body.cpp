#include <algorithm>
#include <cmath>
#include <numbers>

#include "content/gait/body_motion.h"
#include "content/gait/gait_figures.h"
#include "runtime/model/motion/variation.h"

namespace docent::gait {
namespace {

using namespace gait_figures;

constexpr double degree = std::numbers::pi / 180;

glm::dquat about_x(double angle) {
  return glm::angleAxis(angle, glm::dvec3{1, 0, 0});
}
glm::dquat about_y(double angle) {
  return glm::angleAxis(angle, glm::dvec3{0, 1, 0});
}
glm::dquat about_z(double angle) {
  return glm::angleAxis(angle, glm::dvec3{0, 0, 1});
}

/// A part of the trunk in the world frame. `heading` in radians; the others in degrees: front down,
/// left side up, left side forward.
glm::dquat held(double heading, double tilt, double obliquity, double rotation) {
  return about_y(heading - rotation * degree) * about_x(tilt * degree) *
         about_z(obliquity * degree);
}

/// A swing round its mean, as wide as the steps are long.
double swung(const Harmonics& curve, double cycle, double vigour) {
  return curve.mean + vigour * (value_at(curve, cycle) - curve.mean);
}

/// Slow wandering of a held pose, in [-1, 1]: two incommensurate waves with phases of the seed's.
double wander(std::uint32_t seed, std::uint32_t purpose, double time) {
  const double turn = 2 * std::numbers::pi;
  const double a = variation(seed, 0, 16 + purpose);
  const double b = variation(seed, 1, 16 + purpose);
  return 0.6 * std::sin(turn * (0.31 * time + a)) + 0.4 * std::sin(turn * (0.47 * time + b));
}

double at_frame(const std::vector<double>& track, std::size_t frame, double ahead, double rate) {
  const auto moved =
      static_cast<std::ptrdiff_t>(frame) + static_cast<std::ptrdiff_t>(std::lround(ahead * rate));
  const auto last = static_cast<std::ptrdiff_t>(track.size()) - 1;
  return track[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(moved, 0, last))];
}

/// How far the chest is filled, 0 to 1: fifteen breaths a minute.
double breath(double time) {
  const double phase = 2 * std::numbers::pi * 0.25 * time;
  return 0.5 - 0.5 * std::cos(phase + 0.25 * std::sin(phase));
}

/// What differs from step to step in how the body is carried.
enum Purpose : std::uint32_t {
  PelvisSwing = 4,
  PelvisFacing,
  ThoraxSwing,
  ThoraxFacing,
  ThoraxTilt,
  ThoraxSide,
  HeadFacing,
  HeadTilt,
  BothArms,
  ArmSwing,
  ArmHang = ArmSwing + 2,
  ArmBend = ArmHang + 2,
  ArmAside = ArmBend + 2,
  ArmLag = ArmAside + 2,
};

/// A fluctuation that glides from one step's value to the next's as the cycle goes on.
double gliding(std::uint32_t seed, double cycle, std::uint32_t purpose) {
  const double step = std::floor(2 * cycle);
  const auto number = static_cast<std::int64_t>(step);
  return std::lerp(fluctuation(seed, number, purpose), fluctuation(seed, number + 1, purpose),
                   ease(2 * cycle - step));
}

/// How an arm differs from the normative one in a frame. Standard deviations: swing as a share (in
/// the recorded walks of CMU's subject 16 it is 8 to 14 %), a part of it in both arms alike; the
/// others in degrees, the lag in cycles. Most people swing the left arm more (Kuhtz-Buschbeck et
/// al. 2008).
struct ArmVariation {
  double swing, hang, bend, aside, lag;
};
ArmVariation arm_variation(std::uint32_t seed, double cycle, std::size_t side) {
  const auto own = [&](std::uint32_t purpose) {
    return gliding(seed, cycle, purpose + static_cast<std::uint32_t>(side));
  };
  const double habit = side == 0 ? 1.06 : 0.95;
  return {.swing = habit * (1 + 0.09 * gliding(seed, cycle, BothArms) + 0.11 * own(ArmSwing)),
          .hang = 1.9 * own(ArmHang),
          .bend = 4.2 * own(ArmBend),
          .aside = 1.1 * own(ArmAside),
          .lag = 0.012 * own(ArmLag)};
}

void hang_arms(const Pace& pace, std::size_t frame, std::uint32_t seed, UpperBody& body) {
  const double vigour = pace.vigour[frame];
  const double in = breath(pace.times.at(frame));
  for (std::size_t side = 0; side < 2; ++side) {
    const double out = side == 0 ? 1 : -1;
    const ArmVariation own = arm_variation(seed, pace.cycle[frame], side);
    const double cycle = pace.cycle[frame] + (side == 0 ? 0.0 : 0.5) - own.lag;
    const double flexion = swung(shoulder_flexion, cycle, vigour * own.swing) + vigour * own.hang;
    const double standing_bend = elbow_flexion.mean - 8;
    const double swing = own.swing * (value_at(elbow_flexion, cycle) - elbow_flexion.mean);
    const double elbow = standing_bend + vigour * (8 + own.bend + swing);
    // A forward arm comes a little across the body, a backward one leaves it.
    const double away = 7.5 + vigour * own.aside - 0.09 * (flexion - shoulder_flexion.mean);
    body.collar[side] = about_z(out * (0.3 + 0.9 * in) * degree);
    body.shoulder[side] =
        about_z(out * away * degree) * about_x(-flexion * degree) * about_y(-out * 16 * degree);
    body.elbow[side] = about_x(-elbow * degree);
    const double drag = vigour * 3.5 * std::sin(2 * std::numbers::pi * (cycle - 0.55));
    body.wrist[side] = about_x((4 + drag) * -degree) * about_z(-out * 3 * degree);
  }
}

}  // namespace

UpperBody upper_body_at(const Pace& pace, std::size_t frame, std::uint32_t seed) {
  const double rate = pace.times.rate;
  const double time = pace.times.at(frame);
  const double cycle = pace.cycle[frame];
  const double vigour = pace.vigour[frame];
  const double still = 1 - 0.7 * vigour;
  const double lean = pace.lean[frame] / degree;
  const double in = breath(time);
  const auto heading = [&](double ahead) { return at_frame(pace.heading, frame, ahead, rate); };

  const auto own = [&](std::uint32_t purpose) { return vigour * gliding(seed, cycle, purpose); };
  const double hips = vigour * (1 + 0.10 * gliding(seed, cycle, PelvisSwing));
  const double shoulders = vigour * (1 + 0.15 * gliding(seed, cycle, ThoraxSwing));

  UpperBody body;
  body.pelvis = held(heading(0), swung(pelvis_tilt, cycle, vigour),
                     swung(pelvis_obliquity, cycle, hips) - 0.35 * lean,
                     swung(pelvis_rotation, cycle, hips) + 0.7 * own(PelvisFacing) +
                         0.5 * still * wander(seed, 0, time));
  body.chest = held(heading(0.05),
                    swung(thorax_tilt, cycle, vigour) - 0.7 * in + 0.3 * wander(seed, 1, time) +
                        0.8 * own(ThoraxTilt),
                    swung(thorax_obliquity, cycle, shoulders) - lean +
                        0.25 * wander(seed, 2, time) + 0.5 * own(ThoraxSide),
                    swung(thorax_rotation, cycle, shoulders) + 1.2 * own(ThoraxFacing) +
                        0.6 * still * wander(seed, 3, time));
  body.spine = glm::slerp(body.pelvis, body.chest, 0.5);
  // The head looks where the body will go and keeps level (Pozzo et al. 1990), and about.
  body.head =
      held(heading(0.24), 1.5 + 0.5 * wander(seed, 4, time) + 1.2 * own(HeadTilt), -0.25 * lean,
           1.6 * wander(seed, 5, time) + 0.15 * swung(thorax_rotation, cycle, vigour) +
               1.8 * own(HeadFacing));
  body.neck = glm::slerp(body.chest, body.head, 0.45);
  hang_arms(pace, frame, seed, body);
  return body;
}

}  // namespace docent::gait
