#pragma once

#include <string>
#include <vector>

#include "content/character/human_bone.h"
#include "content/import/gltf/model.h"

namespace docent::character {

/// How the arms of a rest pose are held: VRM's T-pose, an A-pose, or hanging.
enum class RestPose : std::uint8_t { T, A, ArmsDown };

/// A character upright: metres, y up, facing +z, its own left at +x.
///
/// `rest` is how the file's nodes stand; `bind` is the pose in which the skin was modelled, which
/// need not be the same. Both are upright.
struct Standing {
  BoneMap bones;
  std::vector<Mat4> rest, bind;  ///< World transforms, one a node.
  Mat4 turn{1};                  ///< From the file's frame.
  RestPose pose = RestPose::T;
  float arm_elevation = 0;  ///< Degrees of the arms above the horizontal, mean of both.

  Vec3 at_rest(HumanBone bone) const { return Vec3(rest[place_of(bone)][3]); }
  Vec3 at_bind(HumanBone bone) const { return Vec3(bind[place_of(bone)][3]); }

 private:
  std::size_t place_of(HumanBone bone) const { return static_cast<std::size_t>(bones[bone]); }
};

/// Finds the bones and stands the character upright. ContentError (`not-humanoid`) about `file`
/// where it is none or no person: an animal on four legs, a heap of bones. What was turned or is
/// strange is added to `notes`.
Standing stand_up(const import::gltf::Model& model, const std::string& file,
                  std::vector<std::string>& notes);

}  // namespace docent::character
