#include "content/gait/gait.h"

#include <cmath>
#include <numbers>

#include "content/gait/body_motion.h"
#include "content/gait/gait_skeleton.h"

namespace docent::gait {
namespace {

/// Seconds made before and after the kept frames, so that smoothing and balance see what comes.
constexpr double margin = 2.2;

std::size_t index(WalkerJoint joint) {
  return static_cast<std::size_t>(joint);
}

/// Writes a limb's rotations, which are given in the world frame, relative to their parents.
void write_chain(const glm::dquat& base, std::span<const WalkerJoint> joints,
                 std::span<const glm::dquat> in_room, std::span<Quat> local) {
  glm::dquat parent = base;
  for (std::size_t k = 0; k < joints.size(); ++k) {
    local[index(joints[k])] = Quat(glm::normalize(glm::inverse(parent) * in_room[k]));
    parent = in_room[k];
  }
}

void write_upper_body(const UpperBody& body, std::span<Quat> local) {
  using enum WalkerJoint;
  local[index(Hips)] = Quat(body.pelvis);
  const std::array<WalkerJoint, 4> joints{Spine, Chest, Neck, Head};
  const std::array<glm::dquat, 4> in_room{body.spine, body.chest, body.neck, body.head};
  write_chain(body.pelvis, joints, in_room, local);
  const std::array<std::array<WalkerJoint, 4>, 2> arms{
      {{LeftCollar, LeftShoulder, LeftElbow, LeftWrist},
       {RightCollar, RightShoulder, RightElbow, RightWrist}}};
  for (std::size_t side = 0; side < 2; ++side) {
    local[index(arms[side][0])] = Quat(body.collar[side]);
    local[index(arms[side][1])] = Quat(body.shoulder[side]);
    local[index(arms[side][2])] = Quat(body.elbow[side]);
    local[index(arms[side][3])] = Quat(body.wrist[side]);
  }
}

/// Is the foot flat on the ground and still?
bool planted(std::span<const Footstep> placings, double time) {
  const FootPose foot = foot_at(placings, time);
  for (const Footstep& step : placings)
    if (time >= step.strike && time <= step.toe_off) return std::abs(foot.pitch) < 0.003;
  return false;
}

}  // namespace

MotionClip make_gait_clip(const GaitRecipe& recipe) {
  using enum WalkerJoint;
  constexpr double rate = 120;
  const auto extra = static_cast<std::size_t>(margin * rate);
  const FrameTimes times{
      .begin = recipe.begin - margin, .rate = rate, .count = recipe.frames + 2 * extra};
  const std::vector<Footstep> steps = plan_footsteps(recipe.plan);
  const Pace pace = pace_of(steps, times);
  const std::vector<glm::dvec3> root = root_places(steps, pace, recipe.plan.seed);
  const std::array<std::vector<Footstep>, 2> placings{placings_of(steps, Side::Left),
                                                      placings_of(steps, Side::Right)};
  constexpr std::array<std::array<WalkerJoint, 4>, 2> legs{
      {{LeftHip, LeftKnee, LeftAnkle, LeftToe}, {RightHip, RightKnee, RightAnkle, RightToe}}};

  MotionClip clip;
  clip.name = recipe.name;
  clip.frame_rate = rate;
  clip.joint_count = static_cast<std::uint32_t>(Count);
  const glm::dvec3 origin{root[extra].x, 0, root[extra].z};
  clip.rotation.assign(static_cast<std::size_t>(recipe.frames) * clip.joint_count,
                       Quat{1, 0, 0, 0});
  for (std::size_t f = 0; f < recipe.frames; ++f) {
    const std::size_t made = f + extra;
    const std::span<Quat> local =
        std::span(clip.rotation).subspan(f * clip.joint_count, clip.joint_count);
    const UpperBody body = upper_body_at(pace, made, recipe.plan.seed);
    write_upper_body(body, local);
    for (std::size_t side = 0; side < 2; ++side) {
      const double out = side == 0 ? 1 : -1;
      const glm::dvec3 hip =
          root[made] + body.pelvis * glm::dvec3{out * walker::hip_half, -walker::hip_drop, 0};
      const LegRotations leg =
          reach(hip, foot_at(placings[side], times.at(made)), pace.heading[made]);
      const std::array<glm::dquat, 4> in_room{leg.thigh, leg.shin, leg.foot, leg.toes};
      write_chain(body.pelvis, legs[side], in_room, local);
    }
    clip.root.emplace_back(root[made] - origin);
    clip.plants.push_back(
        {planted(placings[0], times.at(made)), planted(placings[1], times.at(made))});
  }
  return clip;
}

std::vector<GaitRecipe> default_clips() {
  using Kind = GaitPlan::Kind;
  constexpr double degree = std::numbers::pi / 180;
  const auto middle = [](std::uint32_t frames) { return -0.5 * frames / 120; };
  const auto turn = [&](double angle, double length, double speed, std::uint32_t seed) {
    return GaitPlan{.speed = 1.06,
                    .turn = angle * degree,
                    .turn_speed = speed,
                    .turn_length = length,
                    .kind = Kind::Walking,
                    // Turning away from the foot that is down opens the stride: a step turn.
                    .first = angle > 0 ? Side::Right : Side::Left,
                    .seed = seed};
  };
  return {
      {"stand-to-walk", {.kind = Kind::FromStanding, .first = Side::Right, .seed = 3}, -0.85, 424},
      {"walk", {.kind = Kind::Walking, .first = Side::Left, .seed = 5}, middle(471), 471},
      {"walk-to-stand", {.kind = Kind::ToStanding, .first = Side::Left, .seed = 8}, -1.95, 285},
      {"turn-left-90", turn(90, 1.75, 0.86, 13), middle(520), 520},
      {"turn-right-90", turn(-90, 1.65, 0.86, 21), middle(503), 503},
      {"turn-left-45", turn(45, 1.35, 0.97, 34), middle(441), 441},
      {"turn-right-45", turn(-45, 1.40, 0.97, 55), middle(444), 444},
      {"corner-left-130", turn(130, 0.70, 0.50, 89), middle(400), 400},
      {"corner-right-130", turn(-130, 0.70, 0.50, 144), middle(400), 400},
  };
}

}  // namespace docent::gait
