#include "runtime/motion/vary_strides.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "runtime/model/motion/side.h"
#include "runtime/model/motion/variation.h"

namespace docent::motion {
namespace {

/// What differs from step to step. Shoulders and elbows: left, right.
enum Purpose : std::uint32_t {
  ChestFacing,
  ChestTilt,
  ChestSide,
  HeadFacing,
  HeadTilt,
  Swing,
  Hang = Swing + 2,
  Bend = Hang + 2,
  Aside = Bend + 2,
  Purposes = Aside + 2,
};

constexpr double degree = 0.017453292519943295;
constexpr double farthest_off = 1.8;  ///< Standard deviations.
/// Standard deviations: shares of swing and bend (of recorded walks 8 to 14 %), else radians.
constexpr double chest_facing = 2.1 * degree, chest_tilt = 1.3 * degree, chest_side = 0.8 * degree,
                 head_facing = 2.2 * degree, head_tilt = 1.3 * degree, arm_swing = 0.17,
                 arm_hang = 3.8 * degree, arm_bend = 0.24, arm_aside = 1.9 * degree;
constexpr double widest_swing = 0.12;     ///< More than the clips: arms would be too quick.
constexpr double settling_seconds = 1.0;  ///< After standing, and before it.

using Amounts = std::array<double, Purposes>;

Amounts amounts_of(std::uint32_t seed, std::int64_t step) {
  Amounts amounts;
  for (std::uint32_t p = 0; p < Purposes; ++p)
    amounts[p] = std::clamp(fluctuation(seed, step, p), -farthest_off, farthest_off);
  return amounts;
}

double eased(double t) {
  return t * t * (3 - 2 * t);
}

/// A small turn about the axes of a parent whose body faces +z, left at +x.
Quat small_turn(double tilt, double facing, double side) {
  return glm::normalize(Quat(1, static_cast<float>(tilt / 2), static_cast<float>(facing / 2),
                             static_cast<float>(side / 2)));
}

/// A rotation as much farther from another as a share says.
Quat farther(const Quat& rotation, Quat from, double share) {
  if (glm::dot(rotation, from) < 0) from = -from;
  return glm::normalize(rotation + (rotation - from) * static_cast<float>(share));
}

/// The joints that carry what differs; None where a skeleton has none.
struct Joints {
  JointIndex chest, head;
  std::array<JointIndex, 2> shoulder, elbow;
};
Joints joints_of(const Skeleton& skeleton) {
  using enum BodyPart;
  return {skeleton[Chest],
          skeleton[Neck] == JointIndex::None ? skeleton[Head] : skeleton[Neck],
          {skeleton[LeftShoulder], skeleton[RightShoulder]},
          {skeleton[LeftElbow], skeleton[RightElbow]}};
}

/// A joint that hardly moves in the clips does not begin to: it would be too quick (speed_limit.h).
Joints moving_joints_of(const WalkGraph& graph) {
  constexpr double least_speed = 0.3;  // radians a second
  const auto if_moving = [&](JointIndex joint) {
    const bool moves = joint != JointIndex::None && index_of(joint) < graph.quickest.joint.size() &&
                       graph.quickest.joint[index_of(joint)] >= least_speed;
    return moves ? joint : JointIndex::None;
  };
  Joints joints = joints_of(graph.motion->skeleton);
  for (JointIndex* joint : {&joints.chest, &joints.head, &joints.shoulder[0], &joints.shoulder[1],
                            &joints.elbow[0], &joints.elbow[1]})
    *joint = if_moving(*joint);
  return joints;
}

void vary_pose(const Joints& joints, const ArmsAtEase& ease, const Amounts& amount,
               std::span<Quat> rotation) {
  const auto turn = [&](JointIndex joint, const Quat& by) {
    if (joint != JointIndex::None) rotation[index_of(joint)] = by * rotation[index_of(joint)];
  };
  const double facing = chest_facing * amount[ChestFacing], tilt = chest_tilt * amount[ChestTilt];
  turn(joints.chest, small_turn(tilt, facing, chest_side * amount[ChestSide]));
  // The head keeps level and looks ahead above a chest that does not.
  turn(joints.head, small_turn(head_tilt * amount[HeadTilt] - 0.7 * tilt,
                               head_facing * amount[HeadFacing] - 0.7 * facing, 0));
  for (const Side side : both_sides) {
    const std::size_t i = index_of(side);
    if (joints.shoulder[i] != JointIndex::None) {
      Quat& shoulder = rotation[index_of(joints.shoulder[i])];
      shoulder = small_turn(-arm_hang * amount[Hang + i], 0,
                            static_cast<double>(sign_of(side)) * arm_aside * amount[Aside + i]) *
                 farther(shoulder, ease.shoulder[i],
                         std::min(widest_swing, arm_swing * amount[Swing + i]));
    }
    if (joints.elbow[i] != JointIndex::None) {
      Quat& elbow = rotation[index_of(joints.elbow[i])];
      elbow = farther(elbow, Quat(1, 0, 0, 0), arm_bend * amount[Bend + i]);
    }
  }
}

}  // namespace

ArmsAtEase arms_at_ease(const MotionGraph& motion) {
  const Joints joints = joints_of(motion.skeleton);
  ArmsAtEase ease;
  for (const Side side : both_sides) {
    const JointIndex shoulder = joints.shoulder[index_of(side)];
    if (shoulder == JointIndex::None) continue;
    Quat sum(0, 0, 0, 0), first(1, 0, 0, 0);
    for (const MotionClip& clip : motion.clips)
      for (std::size_t f = 0; f < clip.root.size(); f += 4) {
        const Quat& q = clip.rotation[f * clip.joint_count + index_of(shoulder)];
        if (f == 0 && &clip == &motion.clips.front()) first = q;
        sum = sum + (glm::dot(first, q) < 0 ? -q : q);
      }
    ease.shoulder[index_of(side)] = glm::normalize(sum);
  }
  return ease;
}

double steps_a_frame(const WalkGraph& graph) noexcept {
  return 2 / std::max(1.0, graph.stride_seconds * graph.frame_rate);
}

double share_before_end(const WalkGraph& graph, std::size_t frames_left) noexcept {
  return eased(
      std::min(1.0, static_cast<double>(frames_left) / (settling_seconds * graph.frame_rate)));
}

void vary_strides(const WalkGraph& graph, const StrideVariety& variety, Draft& draft) {
  Walk& walk = draft.walk;
  const Joints joints = moving_joints_of(graph);
  const std::size_t frames = walk.root.size();
  const double each = steps_a_frame(graph);
  auto step = static_cast<std::int64_t>(variety.first_step);
  Amounts before = amounts_of(variety.seed, step), after = amounts_of(variety.seed, step + 1);
  for (std::size_t f = 0; f < frames; ++f) {
    const double steps = variety.first_step + each * static_cast<double>(f);
    if (const auto now = static_cast<std::int64_t>(steps); now != step) {
      step = now;
      before = after;
      after = amounts_of(variety.seed, step + 1);
    }
    const double share = eased(steps - static_cast<double>(step));
    const double whole = share_before_end(graph, frames - 1 - f) *
                         std::lerp(variety.first_share, 1.0, share_before_end(graph, f));
    Amounts amount;
    for (std::size_t p = 0; p < Purposes; ++p)
      amount[p] = whole * std::lerp(before[p], after[p], share);
    vary_pose(joints, graph.arms, amount,
              std::span(walk.rotation).subspan(f * walk.joint_count, walk.joint_count));
  }
}

std::uint32_t seed_of(std::span<const Vec2> path) noexcept {
  std::uint64_t hash = 0xCBF29CE484222325ULL;  // FNV-1a
  for (const Vec2 point : path)
    for (const double value : {point.x, point.y})
      hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 0x100000001B3ULL;
  return static_cast<std::uint32_t>((hash ^ hash >> 32U) & 0xFFFFFFU);
}

}  // namespace docent::motion
