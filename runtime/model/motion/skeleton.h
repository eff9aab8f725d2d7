#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "runtime/model/geometry/vec2.h"

namespace docent {

enum class JointIndex : std::int32_t { None = -1 };
constexpr std::size_t index_of(JointIndex j) noexcept {
  return static_cast<std::size_t>(j);
}

/// A joint of the skeleton. `offset` is its place in its parent's frame in the rest pose, in
/// metres.
struct Joint {
  std::string name;
  JointIndex parent = JointIndex::None;  ///< Comes before the joint. None for the root only.
  Vec3 offset{};
};

/// The parts of a body that motion and drawing need to know by name, found from names and shape by
/// the importer.
enum class BodyPart : std::uint8_t {
  Hips,
  Spine,
  Chest,
  Neck,
  Head,
  HeadTop,
  LeftHip,
  LeftKnee,
  LeftAnkle,
  LeftToe,
  LeftToeTip,
  RightHip,
  RightKnee,
  RightAnkle,
  RightToe,
  RightToeTip,
  LeftClavicle,
  LeftShoulder,
  LeftElbow,
  LeftWrist,
  LeftHandTip,
  RightClavicle,
  RightShoulder,
  RightElbow,
  RightWrist,
  RightHandTip,
  Count
};

/// A skeleton with more joints is neither written nor read: so many matrices of one body fit into
/// a uniform block of every OpenGL ES 3 together with what else is told of it.
inline constexpr std::size_t most_joints = 64;

/// A tree of joints, parents before children; joint 0 is the root (the hips). Model frame: metres,
/// y up; in the rest pose, when every rotation is the identity, the body faces +z as nearly as the
/// recording allows. The ends of limbs are joints too, without a rotation (`has_rotation` false).
struct Skeleton {
  std::vector<Joint> joint;
  std::vector<bool> has_rotation;
  std::array<JointIndex, static_cast<std::size_t>(BodyPart::Count)> part{};

  JointIndex operator[](BodyPart p) const noexcept { return part[static_cast<std::size_t>(p)]; }
};

}  // namespace docent
