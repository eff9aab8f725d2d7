#include "content/motion/joint_pops.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "content/motion/fill_gap.h"
#include "content/motion/joint_positions.h"

namespace docent::motion::offline {
namespace {

constexpr double impossible = 30'000;  // rad/s2

/// How fast a joint's own turning changes in a frame that is not an end; rad/s2.
double turn_acceleration(const MotionClip& clip, std::size_t joint, std::size_t frame) {
  const auto turn = [&](std::size_t f) { return clip.rotation[f * clip.joint_count + joint]; };
  const auto towards = [](const Quat& q, const Quat& other) {
    return glm::dot(q, other) < 0 ? -q : q;
  };
  const Quat here = turn(frame);
  const Quat course = towards(turn(frame - 1), here) + towards(turn(frame + 1), here);
  const double length = glm::length(course);
  if (length < 1e-6) return 0;  // A turn and its opposite, which only a clip of three frames has.
  const double along =
      std::min(1.0, std::abs(static_cast<double>(glm::dot(here, course))) / length);
  return 2 * 2 * std::acos(along) * clip.frame_rate * clip.frame_rate;
}

double worst_in(const MotionClip& clip, std::size_t joint, const Gap& gap) {
  const std::int64_t begin = std::max<std::int64_t>(gap.first - 1, 1);
  const std::int64_t end = std::min<std::int64_t>(gap.last + 2, frame_count(clip) - 1);
  double worst = 0;
  for (std::int64_t f = begin; f < end; ++f)
    worst = std::max(worst, turn_acceleration(clip, joint, static_cast<std::size_t>(f)));
  return worst;
}

bool mend(const JointPop& pop, MotionClip& clip) {
  const std::int64_t most = frames_in(0.1, clip.frame_rate), frames = frame_count(clip);
  const Channel<Quat> turn{
      .values = clip.rotation, .stride = clip.joint_count, .offset = pop.joint};
  for (std::int64_t more = 0; more <= most; ++more) {
    const Gap gap = gap_of(pop.first, pop.last, frames, more);
    if (gap.before < 0 && gap.after < 0) return false;
    std::vector<Quat> kept;
    for (std::int64_t f = gap.first; f <= gap.last; ++f) kept.push_back(turn.at(f));
    fill(gap, turn, frames);
    if (worst_in(clip, pop.joint, gap) < 0.25 * impossible) return true;
    for (std::int64_t f = gap.first; f <= gap.last; ++f)
      turn.at(f) = kept[static_cast<std::size_t>(f - gap.first)];
  }
  return false;
}

}  // namespace

std::vector<JointPop> find_joint_pops(const Skeleton& skeleton, const MotionClip& clip) {
  const std::uint32_t bridge = frames_in(0.1, clip.frame_rate);
  std::vector<JointPop> pops;
  for (std::size_t j = 0; j < clip.joint_count; ++j) {
    if (!skeleton.has_rotation[j]) continue;
    for (std::uint32_t f = 1; f + 1 < frame_count(clip); ++f) {
      const double acceleration = turn_acceleration(clip, j, f);
      if (acceleration < impossible) continue;
      if (!pops.empty() && pops.back().joint == j && f - pops.back().last <= bridge) {
        pops.back().last = f;
        pops.back().acceleration = std::max(pops.back().acceleration, acceleration);
      } else {
        pops.push_back({.first = f, .last = f, .joint = j, .acceleration = acceleration});
      }
    }
  }
  return pops;
}

std::vector<JointPop> mend_joint_pops(const Skeleton& skeleton, MotionClip& clip) {
  const std::uint32_t longest = frames_in(0.25, clip.frame_rate);
  std::vector<JointPop> mended;
  for (const JointPop& pop : find_joint_pops(skeleton, clip))
    if (pop.last - pop.first < longest && mend(pop, clip)) mended.push_back(pop);
  return mended;
}

std::string describe(const JointPop& pop, const Skeleton& skeleton) {
  const std::string frames = pop.first == pop.last
                                 ? fmt::format("frame {}", pop.first)
                                 : fmt::format("frames {} to {}", pop.first, pop.last);
  return fmt::format("joint '{}' pops in {}", skeleton.joint[pop.joint].name, frames);
}

}  // namespace docent::motion::offline
