#include "tests/bench/walk_quality.h"

#include <algorithm>

#include "runtime/motion/pose.h"
#include "tests/bench/measure.h"

namespace docent::bench {
namespace {

struct FootTrack {
  std::vector<Vec2> toe;
  std::vector<double> ankle_height, toe_height;

  void add(Vec3 ankle, Vec3 toe_joint) {
    toe.push_back(to_floor(toe_joint));
    ankle_height.push_back(static_cast<double>(ankle.y));
    toe_height.push_back(static_cast<double>(toe_joint.y));
  }

  [[nodiscard]] std::vector<bool> flat(double ankle_rest, double toe_rest) const {
    std::vector<bool> result;
    for (std::size_t f = 0; f < toe.size(); ++f)
      result.push_back(ankle_height[f] < ankle_rest + 0.02 && toe_height[f] < toe_rest + 0.015);
    return result;
  }
};

using Feet = std::array<FootTrack, 2>;

/// Adds the frames of a walk or a clip.
template <typename Motion>
void track_feet(const Skeleton& skeleton, const Motion& walk, Feet& feet) {
  std::vector<Quat> rotation(walk.joint_count);
  std::vector<Mat4> world(walk.joint_count);
  for (std::size_t f = 0; f < walk.root.size(); ++f) {
    motion::PoseView pose{{}, rotation};
    motion::sample(walk, static_cast<double>(f) / walk.frame_rate, pose);
    motion::to_world_space(skeleton, pose, world);
    const auto place = [&](BodyPart part) { return Vec3(world[index_of(skeleton[part])][3]); };
    feet[0].add(place(BodyPart::LeftAnkle), place(BodyPart::LeftToe));
    feet[1].add(place(BodyPart::RightAnkle), place(BodyPart::RightToe));
  }
}

void measure_feet(const Skeleton& skeleton, const RestingHeights& rest, const motion::Walk& walk,
                  WalkQuality& quality) {
  constexpr double shortest_plant = 0.08;  // seconds
  double slid = 0;
  std::size_t samples = 0;
  std::vector<double> drifts;
  Feet feet;
  track_feet(skeleton, walk, feet);
  for (std::size_t side = 0; side < 2; ++side) {
    const FootTrack& foot = feet[side];
    const std::vector<bool> flat = foot.flat(rest.ankle[side], rest.toe[side]);
    for (std::size_t f = 0; f < flat.size();) {
      std::size_t end = f;
      while (end < flat.size() && flat[end]) ++end;
      const Vec2 middle = foot.toe[std::min((f + end) / 2, foot.toe.size() - 1)];
      double drift = 0;
      for (std::size_t k = f; k < end; ++k) {
        drift = std::max(drift, glm::distance(foot.toe[k], middle));
        if (k == f) continue;
        slid += glm::distance(foot.toe[k], foot.toe[k - 1]);
        ++samples;
      }
      if (static_cast<double>(end - f) >= shortest_plant * walk.frame_rate) drifts.push_back(drift);
      f = std::max(end, f + 1);
    }
  }
  quality.skate = slid * walk.frame_rate / static_cast<double>(samples);
  quality.drift = quantile(drifts, 0.95);
  quality.flat_share = static_cast<double>(samples) / static_cast<double>(2 * walk.root.size());
}

}  // namespace

RestingHeights resting_heights(const MotionGraph& motion) {
  Feet feet;
  for (const MotionClip& clip : motion.clips) track_feet(motion.skeleton, clip, feet);
  RestingHeights rest;
  for (std::size_t side = 0; side < 2; ++side) {
    rest.ankle[side] = quantile(feet[side].ankle_height, 0.01);
    rest.toe[side] = quantile(feet[side].toe_height, 0.01);
  }
  return rest;
}

WalkQuality measure_walk(const Skeleton& skeleton, const RestingHeights& rest,
                         const motion::Walk& walk, std::span<const Vec2> path) {
  WalkQuality quality;
  const std::vector<Vec2> track = floor_track(walk);
  quality.deviation = motion::offline::measure_deviation(track, walk.frame_rate, path);
  quality.seconds = static_cast<double>(track.size()) / walk.frame_rate;
  quality.end_gap = glm::distance(track.back(), path.back());
  measure_feet(skeleton, rest, walk, quality);
  return quality;
}

std::vector<Vec2> floor_track(const motion::Walk& walk) {
  std::vector<Vec2> track;
  for (const Vec3 root : walk.root) track.push_back(to_floor(root));
  return track;
}

}  // namespace docent::bench
