#include "content/motion/rest_pose.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "content/motion/joint_positions.h"

namespace docent::motion::offline {
namespace {

/// World rotations of all joints in a frame.
std::vector<Quat> world_rotations(const Skeleton& skeleton, const Quat* local) {
  std::vector<Quat> world;
  for (std::size_t j = 0; j < skeleton.joint.size(); ++j) {
    const JointIndex parent = skeleton.joint[j].parent;
    world.push_back(parent == JointIndex::None ? local[j] : world[index_of(parent)] * local[j]);
  }
  return world;
}

/// How far the feet of a frame are from standing side by side, metres.
double unrest(const Skeleton& skeleton, const JointPositions& track, std::size_t frame) {
  const auto at = [&](BodyPart part) { return track.at(frame, index_of(skeleton[part])); };
  return std::abs(at(BodyPart::LeftAnkle).y - at(BodyPart::RightAnkle).y) +
         std::abs(at(BodyPart::LeftToe).y - at(BodyPart::RightToe).y) +
         glm::distance(to_floor(at(BodyPart::LeftToe)), to_floor(at(BodyPart::RightToe)));
}

bool has_legs(const Skeleton& skeleton) {
  constexpr std::array parts{BodyPart::LeftHip,    BodyPart::RightHip, BodyPart::LeftAnkle,
                             BodyPart::RightAnkle, BodyPart::LeftToe,  BodyPart::RightToe};
  return std::ranges::all_of(parts,
                             [&](BodyPart part) { return skeleton[part] != JointIndex::None; });
}

/// The turn about the vertical after which a body that faces as this one looks along z.
Quat turned_forwards(const Skeleton& skeleton, const JointPositions& track, std::size_t frame) {
  const Vec3 left = track.at(frame, index_of(skeleton[BodyPart::LeftHip])) -
                    track.at(frame, index_of(skeleton[BodyPart::RightHip]));
  // The left hip is to be at positive x.
  return glm::angleAxis(std::atan2(left.z, left.x), Vec3(0, 1, 0));
}

}  // namespace

bool stands_at_rest(const Skeleton& skeleton) {
  std::vector<Vec3> at;
  for (const Joint& joint : skeleton.joint)
    at.push_back(joint.parent == JointIndex::None ? Vec3{}
                                                  : at[index_of(joint.parent)] + joint.offset);
  const auto height = [&](BodyPart part, float otherwise) {
    return skeleton[part] == JointIndex::None ? otherwise : at[index_of(skeleton[part])].y;
  };
  const float hips = height(BodyPart::LeftHip, 0), size = static_cast<float>(size_of(skeleton));
  return height(BodyPart::Head, 1e9F) > hips + 0.3F * size &&
         height(BodyPart::LeftAnkle, -1e9F) < hips - 0.4F * size;
}

void rest_upright(Skeleton& skeleton, std::span<MotionClip* const> clips) {
  if (!has_legs(skeleton)) return;
  constexpr std::size_t every = 4;
  double least = std::numeric_limits<double>::infinity();
  std::vector<Quat> rest;
  for (const MotionClip* clip : clips) {
    const JointPositions track = joint_positions(skeleton, *clip);
    for (std::size_t f = 0; f < frame_count(*clip); f += every) {
      const double off = unrest(skeleton, track, f);
      if (off >= least) continue;
      least = off;
      rest = world_rotations(skeleton, &clip->rotation[f * clip->joint_count]);
      const Quat forwards = turned_forwards(skeleton, track, f);
      for (Quat& rotation : rest) rotation = forwards * rotation;
    }
  }
  if (rest.empty()) return;
  for (MotionClip* clip : clips)
    for (std::size_t f = 0; f < frame_count(*clip); ++f) {
      Quat* local = &clip->rotation[f * clip->joint_count];
      std::vector<Quat> world = world_rotations(skeleton, local);
      for (std::size_t j = 0; j < world.size(); ++j) world[j] = world[j] * glm::inverse(rest[j]);
      for (std::size_t j = 0; j < world.size(); ++j) {
        const JointIndex parent = skeleton.joint[j].parent;
        local[j] = glm::normalize(parent == JointIndex::None
                                      ? world[j]
                                      : glm::inverse(world[index_of(parent)]) * world[j]);
      }
    }
  for (Joint& joint : skeleton.joint)
    if (joint.parent != JointIndex::None)
      joint.offset = rest[index_of(joint.parent)] * joint.offset;
}

}  // namespace docent::motion::offline
