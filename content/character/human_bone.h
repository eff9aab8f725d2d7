#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace docent::character {

/// The bones of a humanoid as VRM 1.0 names them ("Humanoid", list of humanoid bones), parents
/// before children.
enum class HumanBone : std::uint8_t {
  Hips,
  Spine,
  Chest,
  UpperChest,
  Neck,
  Head,
  LeftEye,
  RightEye,
  Jaw,
  LeftUpperLeg,
  LeftLowerLeg,
  LeftFoot,
  LeftToes,
  RightUpperLeg,
  RightLowerLeg,
  RightFoot,
  RightToes,
  LeftShoulder,
  LeftUpperArm,
  LeftLowerArm,
  LeftHand,
  RightShoulder,
  RightUpperArm,
  RightLowerArm,
  RightHand,
  LeftThumbMetacarpal,
  LeftThumbProximal,
  LeftThumbDistal,
  LeftIndexProximal,
  LeftIndexIntermediate,
  LeftIndexDistal,
  LeftMiddleProximal,
  LeftMiddleIntermediate,
  LeftMiddleDistal,
  LeftRingProximal,
  LeftRingIntermediate,
  LeftRingDistal,
  LeftLittleProximal,
  LeftLittleIntermediate,
  LeftLittleDistal,
  RightThumbMetacarpal,
  RightThumbProximal,
  RightThumbDistal,
  RightIndexProximal,
  RightIndexIntermediate,
  RightIndexDistal,
  RightMiddleProximal,
  RightMiddleIntermediate,
  RightMiddleDistal,
  RightRingProximal,
  RightRingIntermediate,
  RightRingDistal,
  RightLittleProximal,
  RightLittleIntermediate,
  RightLittleDistal,
  Count
};
inline constexpr std::size_t bone_count = static_cast<std::size_t>(HumanBone::Count);
constexpr std::size_t index_of(HumanBone bone) noexcept {
  return static_cast<std::size_t>(bone);
}

inline constexpr std::array<std::string_view, bone_count> bone_names{
    "hips",
    "spine",
    "chest",
    "upperChest",
    "neck",
    "head",
    "leftEye",
    "rightEye",
    "jaw",
    "leftUpperLeg",
    "leftLowerLeg",
    "leftFoot",
    "leftToes",
    "rightUpperLeg",
    "rightLowerLeg",
    "rightFoot",
    "rightToes",
    "leftShoulder",
    "leftUpperArm",
    "leftLowerArm",
    "leftHand",
    "rightShoulder",
    "rightUpperArm",
    "rightLowerArm",
    "rightHand",
    "leftThumbMetacarpal",
    "leftThumbProximal",
    "leftThumbDistal",
    "leftIndexProximal",
    "leftIndexIntermediate",
    "leftIndexDistal",
    "leftMiddleProximal",
    "leftMiddleIntermediate",
    "leftMiddleDistal",
    "leftRingProximal",
    "leftRingIntermediate",
    "leftRingDistal",
    "leftLittleProximal",
    "leftLittleIntermediate",
    "leftLittleDistal",
    "rightThumbMetacarpal",
    "rightThumbProximal",
    "rightThumbDistal",
    "rightIndexProximal",
    "rightIndexIntermediate",
    "rightIndexDistal",
    "rightMiddleProximal",
    "rightMiddleIntermediate",
    "rightMiddleDistal",
    "rightRingProximal",
    "rightRingIntermediate",
    "rightRingDistal",
    "rightLittleProximal",
    "rightLittleIntermediate",
    "rightLittleDistal",
};

/// Without these nobody can walk. VRM requires them, and the spine, which can be done without.
inline constexpr std::array required_bones{
    HumanBone::Hips,          HumanBone::Head,      HumanBone::LeftUpperLeg,
    HumanBone::LeftLowerLeg,  HumanBone::LeftFoot,  HumanBone::RightUpperLeg,
    HumanBone::RightLowerLeg, HumanBone::RightFoot, HumanBone::LeftUpperArm,
    HumanBone::LeftLowerArm,  HumanBone::LeftHand,  HumanBone::RightUpperArm,
    HumanBone::RightLowerArm, HumanBone::RightHand,
};

/// Which node is which bone; -1 where the character has none.
struct BoneMap {
  std::array<std::int32_t, bone_count> node{};

  BoneMap() { node.fill(-1); }
  std::int32_t& operator[](HumanBone bone) noexcept { return node[index_of(bone)]; }
  std::int32_t operator[](HumanBone bone) const noexcept { return node[index_of(bone)]; }
  bool has(HumanBone bone) const noexcept { return node[index_of(bone)] >= 0; }
};

}  // namespace docent::character
