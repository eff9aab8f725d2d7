#include "tests/runtime/motion/walk_measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "runtime/motion/pose.h"

namespace docent::test {
namespace {

/// From the nearest point of the path.
Vec2 offset_from(const std::vector<Vec2>& path, Vec2 point) {
  Vec2 best(std::numeric_limits<double>::infinity(), 0);
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Vec2 a = path[i - 1], step = path[i] - a;
    const double square = dot(step, step);
    const double t = square > 0 ? std::clamp(dot(point - a, step) / square, 0.0, 1.0) : 0;
    const Vec2 offset = point - a - t * step;
    if (glm::length(offset) < glm::length(best)) best = offset;
  }
  return best;
}

std::vector<Vec3> places_of(const Skeleton& skeleton, const motion::Walk& walk, BodyPart part) {
  std::vector<Vec3> out;
  std::vector<Quat> rotation(walk.joint_count);
  std::vector<Mat4> world(walk.joint_count);
  for (std::size_t f = 0; f < walk.root.size(); ++f) {
    motion::PoseView pose{{}, rotation};
    motion::sample(walk, static_cast<double>(f) / walk.frame_rate, pose);
    motion::to_world_space(skeleton, pose, world);
    out.emplace_back(world[index_of(skeleton[part])][3]);
  }
  return out;
}

struct FootOfWalk {
  std::vector<Vec3> toe;
  std::vector<bool> planted;
};

std::array<FootOfWalk, 2> feet_of(const Skeleton& skeleton, const motion::Walk& walk) {
  std::array<FootOfWalk, 2> feet{{{places_of(skeleton, walk, BodyPart::LeftToe), {}},
                                  {places_of(skeleton, walk, BodyPart::RightToe), {}}}};
  for (const FootPlants& plants : walk.plants) {
    feet[0].planted.push_back(plants.left);
    feet[1].planted.push_back(plants.right);
  }
  return feet;
}

double angle_between(Quat a, Quat b) {
  const Quat q = glm::inverse(a) * b;
  return 2 * std::atan2(std::hypot(std::hypot(q.x, q.y), q.z), std::abs(q.w));
}

template <typename Motion>
Quickest quickest_of(const Motion& walk, std::size_t from, std::size_t to) {
  Quickest out;
  const double rate = walk.frame_rate;
  const std::size_t joints = walk.joint_count;
  out.of_joint.assign(joints, 0);
  for (std::size_t f = std::max<std::size_t>(from, 1); f + 1 < std::min(to, walk.root.size());
       ++f) {
    const Vec3 step = walk.root[f] - walk.root[f - 1], next = walk.root[f + 1] - walk.root[f];
    out.root = std::max<double>(out.root, glm::length(step) * rate);
    out.root_change = std::max<double>(out.root_change, glm::length(next - step) * rate * rate);
    for (std::size_t j = 0; j < joints; ++j) {
      const auto at = [&](std::size_t frame) { return walk.rotation[frame * joints + j]; };
      const double turn = angle_between(at(f - 1), at(f)), then = angle_between(at(f), at(f + 1));
      out.joint = std::max(out.joint, turn * rate);
      out.of_joint[j] = std::max(out.of_joint[j], turn * rate);
      out.joint_change = std::max(out.joint_change, std::abs(then - turn) * rate * rate);
    }
  }
  return out;
}

}  // namespace

double largest_deviation(const motion::Walk& walk, const std::vector<Vec2>& path) {
  const auto half = static_cast<std::size_t>(walk.frame_rate / 2);
  const std::size_t frames = walk.root.size();
  std::vector<Vec2> sums(1, Vec2{});
  for (const Vec3& root : walk.root)
    sums.push_back(sums.back() + offset_from(path, to_floor(root)));
  double largest = 0;
  for (std::size_t f = 0; f < frames; ++f) {
    const std::size_t radius = std::min({half, f, frames - 1 - f});
    const Vec2 sum = sums[f + radius + 1] - sums[f - radius];
    largest = std::max(largest, glm::length(sum) / static_cast<double>(2 * radius + 1));
  }
  return largest;
}

double largest_drift(const Skeleton& skeleton, const motion::Walk& walk) {
  double largest = 0;
  for (const FootOfWalk& foot : feet_of(skeleton, walk)) {
    Vec2 stands{};
    for (std::size_t f = 0; f < foot.toe.size(); ++f) {
      if (!foot.planted[f]) continue;
      if (f == 0 || !foot.planted[f - 1]) stands = to_floor(foot.toe[f]);
      largest = std::max(largest, glm::distance(stands, to_floor(foot.toe[f])));
    }
  }
  return largest;
}

double deepest_toe(const Skeleton& skeleton, const motion::Walk& walk) {
  double deepest = 0;
  for (const FootOfWalk& foot : feet_of(skeleton, walk)) {
    float floor = std::numeric_limits<float>::infinity(), lowest = floor;
    for (std::size_t f = 0; f < foot.toe.size(); ++f) {
      lowest = std::min(lowest, foot.toe[f].y);
      if (foot.planted[f]) floor = std::min(floor, foot.toe[f].y);
    }
    deepest = std::max<double>(deepest, floor - lowest);
  }
  return deepest;
}

Quickest quickest(const motion::Walk& walk, std::size_t from, std::size_t to) {
  return quickest_of(walk, from, to);
}

Quickest quickest(const MotionGraph& graph) {
  Quickest out;
  for (const MotionClip& clip : graph.clips) {
    const Quickest in_clip = quickest_of(clip, 0, clip.root.size());
    out.root = std::max(out.root, in_clip.root);
    out.root_change = std::max(out.root_change, in_clip.root_change);
    out.joint = std::max(out.joint, in_clip.joint);
    out.joint_change = std::max(out.joint_change, in_clip.joint_change);
    out.of_joint.resize(in_clip.of_joint.size(), 0);
    for (std::size_t j = 0; j < out.of_joint.size(); ++j)
      out.of_joint[j] = std::max(out.of_joint[j], in_clip.of_joint[j]);
  }
  return out;
}

double haste(const Quickest& walk, const Quickest& recorded) {
  double most = walk.root / recorded.root;
  for (std::size_t j = 0; j < walk.of_joint.size(); ++j)
    most = std::max(most, walk.of_joint[j] / std::max(recorded.of_joint[j], 0.05));
  return most;
}

motion::Walk spliced(const motion::Walk& before, std::size_t frames, const motion::Walk& after) {
  motion::Walk out = before;
  const auto join = [](auto& a, std::size_t keep, const auto& b) {
    a.resize(keep);
    a.insert(a.end(), b.begin(), b.end());
  };
  join(out.root, frames, after.root);
  join(out.rotation, frames * before.joint_count, after.rotation);
  join(out.plants, frames, after.plants);
  join(out.body, frames, after.body);
  join(out.along, frames, after.along);
  join(out.gait, frames, after.gait);
  join(out.source, frames, after.source);
  return out;
}

}  // namespace docent::test
