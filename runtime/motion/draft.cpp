#include "runtime/motion/draft.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "runtime/motion/placement.h"
#include "runtime/motion/replant.h"
#include "runtime/motion/rotation.h"
#include "runtime/motion/smoothing.h"

namespace docent::motion {
namespace {

/// A curve that leaves `value` with `slope` and comes to rest at nothing after `duration`: the
/// quintic whose second derivative also vanishes at both ends.
template <typename Value>
Value fading(Value value, Value slope, double time, double duration) noexcept {
  if (time >= duration) return Value{};
  const auto t = static_cast<float>(time / duration);
  const float t3 = t * t * t;
  const float of_value = 1 - t3 * (10 - t * (15 - 6 * t));
  const float of_slope = t - t3 * (6 - t * (8 - 3 * t));
  return of_value * value + (of_slope * static_cast<float>(duration)) * slope;
}

constexpr double largest_drop = 0.12;   // metres
constexpr double drop_seconds = 0.18;   // half of the time over which hips sink and rise again
constexpr double easing_seconds = 0.1;  // before hips may sink after the first frame
constexpr double velocity_seconds = 0.025;
constexpr float straight_leg = 0.985f;  // of the leg's length: a knee is never quite straight
constexpr float straightest_leg = 0.9985f;

/// How far the hips must sink in each frame for both feet to be in reach.
std::vector<double> hip_drops(const WalkGraph& graph, Draft& draft) {
  const std::size_t frames = draft.walk.root.size();
  std::vector<double> drop(frames, 0.0);
  for (std::size_t f = 0; f < frames; ++f) {
    const PoseView pose = pose_of(draft.walk, f);
    for (const Side side : both_sides) {
      const Leg& leg = graph.legs[side];
      const Vec3 hip = hip_of(graph.motion->skeleton, leg, pose);
      const float reach = std::clamp(draft.reach[index_of(side)][f], straight_leg * leg.length,
                                     straightest_leg * leg.length);
      const float need = drop_into_reach(hip, ankle_of(leg, draft.foot[index_of(side)][f]), reach);
      drop[f] = std::max(drop[f], std::min<double>(need, largest_drop));
    }
  }
  return drop;
}

}  // namespace

std::uint32_t velocity_frames(double rate) noexcept {
  return static_cast<std::uint32_t>(std::max(1L, std::lround(velocity_seconds * rate)));
}

Draft empty_draft(const WalkGraph& graph) {
  Draft draft;
  draft.walk.frame_rate = graph.frame_rate;
  draft.walk.joint_count = static_cast<std::uint32_t>(graph.motion->skeleton.joint.size());
  return draft;
}

PoseView pose_of(Walk& walk, std::size_t frame) noexcept {
  const std::size_t joints = walk.joint_count;
  return {walk.root[frame], std::span(walk.rotation).subspan(frame * joints, joints)};
}

Momentum momentum_at(const WalkGraph& graph, const Walk& walk, std::uint32_t frame) {
  const std::uint32_t last = frame_count(walk) - 1, now = std::min(frame, last);
  const std::uint32_t span = std::min(last, velocity_frames(walk.frame_rate));
  const std::uint32_t to = std::min(now + span, last), from = to - span;
  const float per_second =
      static_cast<float>(walk.frame_rate) / static_cast<float>(std::max(span, 1U));
  const std::size_t joints = walk.joint_count;
  const auto pose_at = [&](std::uint32_t f) {
    const auto first = walk.rotation.begin() + static_cast<std::ptrdiff_t>(f * joints);
    return std::vector<Quat>(first, first + static_cast<std::ptrdiff_t>(joints));
  };
  std::vector<Quat> before = pose_at(from), after = pose_at(to);
  Momentum m;
  m.root = walk.root[now];
  m.rotation = pose_at(now);
  m.root_velocity = (walk.root[to] - walk.root[from]) * per_second;
  for (std::size_t j = 0; j < joints; ++j)
    m.turning.push_back(rotation_vector(after[j] * glm::inverse(before[j])) * per_second);
  for (const Side side : both_sides) {
    const Leg& leg = graph.legs[side];
    const std::size_t i = index_of(side);
    const auto foot_in = [&](std::uint32_t f, std::vector<Quat>& rotation) {
      return foot_of(graph.motion->skeleton, leg, {walk.root[f], rotation});
    };
    m.foot[i] = foot_in(now, m.rotation);
    m.foot_velocity[i] = (foot_in(to, after).toe - foot_in(from, before).toe) * per_second;
  }
  m.planted = {walk.plants[now].left, walk.plants[now].right};
  m.body = walk.body[now];
  m.body_velocity = {
      (walk.body[to].position - walk.body[from].position) * double{per_second},
      wrap_angle(walk.body[to].heading - walk.body[from].heading) * double{per_second}};
  return m;
}

Momentum momentum_of(const WalkGraph& graph, const Stand& stand, const Placement& body) {
  Momentum m;
  m.root = moved(body, stand.root);
  m.rotation = stand.rotation;
  m.rotation[0] = world_rotation(body.heading) * m.rotation[0];
  m.turning.assign(m.rotation.size(), Vec3{});
  for (const Side side : both_sides)
    m.foot[index_of(side)] =
        foot_of(graph.motion->skeleton, graph.legs[side], {m.root, m.rotation});
  m.body = body;
  return m;
}

void inertialise(const Momentum& momentum, double seconds, Draft& draft) {
  Walk& walk = draft.walk;
  const std::size_t joints = walk.joint_count, frames = walk.root.size();
  if (frames < 2 || momentum.rotation.size() != joints) return;
  const std::size_t span = std::min<std::size_t>(velocity_frames(walk.frame_rate), frames - 1);
  const float per_second = static_cast<float>(walk.frame_rate) / static_cast<float>(span);
  const auto count = std::min(frames, static_cast<std::size_t>(seconds * walk.frame_rate) + 1);
  const auto bend = [&](auto offset, auto slope, auto&& add) {
    for (std::size_t f = 0; f < count; ++f)
      add(f, fading(offset, slope, static_cast<double>(f) / walk.frame_rate, seconds));
  };
  const Vec3 velocity = (walk.root[span] - walk.root[0]) * per_second;
  bend(momentum.root - walk.root[0], momentum.root_velocity - velocity,
       [&](std::size_t f, Vec3 offset) { walk.root[f] += offset; });
  for (std::size_t j = 0; j < joints; ++j) {
    const Quat first = walk.rotation[j], later = walk.rotation[span * joints + j];
    const Vec3 turning = rotation_vector(later * glm::inverse(first)) * per_second;
    bend(rotation_vector(momentum.rotation[j] * glm::inverse(first)), momentum.turning[j] - turning,
         [&](std::size_t f, Vec3 offset) {
           Quat& q = walk.rotation[f * joints + j];
           q = glm::normalize(rotation_of(offset) * q);
         });
  }
}

void lower_hips(const WalkGraph& graph, Draft& draft) {
  const auto radius = static_cast<std::size_t>(drop_seconds * draft.walk.frame_rate);
  const std::vector<double> drop = smooth_above(hip_drops(graph, draft), radius);
  const double easing = easing_seconds * draft.walk.frame_rate;
  for (std::size_t f = 0; f < draft.walk.root.size(); ++f) {
    const double t = std::min(1.0, static_cast<double>(f) / easing);
    draft.walk.root[f].y -= static_cast<float>(t * t * t * (10 - t * (15 - 6 * t)) * drop[f]);
  }
}

void place_feet(const WalkGraph& graph, Draft& draft) {
  for (std::size_t f = 0; f < draft.walk.root.size(); ++f) {
    PoseView pose = pose_of(draft.walk, f);
    for (const Side side : both_sides)
      place_foot(graph.motion->skeleton, graph.legs[side], draft.foot[index_of(side)][f], pose);
  }
}

void append(Draft draft, Walk& walk) {
  if (walk.root.empty()) {
    walk = std::move(draft.walk);
    return;
  }
  const Walk& more = draft.walk;
  constexpr std::size_t skip = 1;
  const std::size_t joints = more.joint_count;
  const auto add = [](auto& to, const auto& from, std::size_t first) {
    if (first < from.size())
      to.insert(to.end(), from.begin() + static_cast<std::ptrdiff_t>(first), from.end());
  };
  add(walk.root, more.root, skip);
  add(walk.rotation, more.rotation, skip * joints);
  add(walk.plants, more.plants, skip);
  add(walk.body, more.body, skip);
  add(walk.along, more.along, skip);
  add(walk.gait, more.gait, skip);
  add(walk.source, more.source, skip);
  walk.transitions += more.transitions;
  walk.expanded += more.expanded;
  walk.considered += more.considered;
  walk.scope = std::max(walk.scope, more.scope);
  walk.search_seconds += more.search_seconds;
}

}  // namespace docent::motion
