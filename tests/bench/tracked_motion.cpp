#include "tests/bench/tracked_motion.h"

#include "runtime/motion/placement.h"
#include "runtime/motion/pose.h"

namespace docent::bench {
namespace {

template <typename Motion>
void track_parts(const Skeleton& skeleton, const Motion& motion, TrackedMotion& out) {
  std::vector<Quat> rotation(motion.joint_count);
  std::vector<Mat4> world(motion.joint_count);
  for (std::size_t f = 0; f < motion.root.size(); ++f) {
    motion::PoseView pose{{}, rotation};
    motion::sample(motion, static_cast<double>(f) / motion.frame_rate, pose);
    motion::to_world_space(skeleton, pose, world);
    TrackedMotion::Parts& parts = out.part.emplace_back();
    for (std::size_t p = 0; p < parts.size(); ++p) {
      const JointIndex joint = skeleton.part[p];
      parts[p] = joint == JointIndex::None ? motion.root[f] : Vec3(world[index_of(joint)][3]);
    }
  }
}

}  // namespace

TrackedMotion track(const Skeleton& skeleton, const motion::Walk& walk) {
  TrackedMotion out;
  out.rate = walk.frame_rate;
  track_parts(skeleton, walk, out);
  out.body = walk.body;
  out.plants = walk.plants;
  for (const motion::Gait gait : walk.gait) out.is_walking.push_back(gait == motion::Gait::Walk);
  return out;
}

TrackedMotion track(const motion::WalkGraph& graph, std::size_t clip) {
  const MotionClip& source = graph.motion->clips[clip];
  const motion::ClipPath& path = graph.clip[clip];
  TrackedMotion out;
  out.rate = source.frame_rate;
  track_parts(graph.motion->skeleton, source, out);
  out.body = path.body;
  out.plants = source.plants;
  for (std::size_t f = 0; f < out.frames(); ++f)
    out.is_walking.push_back(f >= path.first && f <= path.last);
  return out;
}

std::vector<TrackedMotion> track_clips(const motion::WalkGraph& graph) {
  std::vector<TrackedMotion> clips;
  for (std::size_t c = 0; c < graph.clip.size(); ++c) clips.push_back(track(graph, c));
  return clips;
}

Vec3 seen_from(const Placement& body, Vec3 place) {
  const Vec2 local = motion::turned(to_floor(place) - body.position, -body.heading);
  return {static_cast<float>(local.x), place.y, static_cast<float>(local.y)};
}

std::vector<std::size_t> strikes(const TrackedMotion& motion, Side side) {
  std::vector<std::size_t> frames;
  for (std::size_t f = 1; f < motion.frames(); ++f)
    if (motion.planted(f, side) && !motion.planted(f - 1, side) && motion.is_walking[f])
      frames.push_back(f);
  return frames;
}

}  // namespace docent::bench
