#include "content/character/find_bones.h"

#include <fmt/format.h>

#include <algorithm>

#include <glm/geometric.hpp>

#include "content/content_error.h"

namespace docent::character {
namespace {

using import::gltf::Model;

[[noreturn]] void refuse(const std::string& file, const std::string& what, const char* hint) {
  throw content::ContentError(file, 0, 0, "not-humanoid", what, hint);
}

BoneMap bones_of_vrm(const Model& model, const std::string& file) {
  BoneMap bones;
  for (const import::gltf::Vrm::Bone& bone : model.vrm.bones) {
    const auto found = std::ranges::find(bone_names, bone.bone);
    if (found == bone_names.end() || bone.node < 0) continue;
    const auto same = std::ranges::find(bones.node, bone.node);
    if (same != bones.node.end())
      refuse(
          file,
          fmt::format("its humanoid bones {} and {} are the same node, {}", bone.bone,
                      bone_names[static_cast<std::size_t>(same - bones.node.begin())], bone.node),
          "assign the bones anew in the program that wrote it");
    bones.node[static_cast<std::size_t>(found - bone_names.begin())] = bone.node;
  }
  if (const std::string missing = missing_bones(bones); !missing.empty())
    refuse(
        file, fmt::format("its VRM humanoid lacks required bones: {}", missing),
        "assign them in the program that wrote it; what is no person can be an exhibit's object");
  return bones;
}

/// Paths from a node up to the root.
std::vector<std::int32_t> ancestors(const Model& model, std::int32_t node) {
  std::vector<std::int32_t> path;
  for (; node >= 0; node = model.nodes[static_cast<std::size_t>(node)].parent) path.push_back(node);
  return path;
}

}  // namespace

std::vector<bool> skin_joints(const Model& model) {
  std::vector<bool> is_joint(model.nodes.size());
  for (const import::gltf::Skin& skin : model.skins)
    for (const std::int32_t joint : skin.joints) is_joint[static_cast<std::size_t>(joint)] = true;
  return is_joint;
}

std::string missing_bones(const BoneMap& bones) {
  std::string missing;
  for (const HumanBone bone : required_bones)
    if (!bones.has(bone))
      missing += fmt::format("{}{}", missing.empty() ? "" : ", ", bone_names[index_of(bone)]);
  return missing;
}

void name_trunk(const Model& model, BoneMap& bones) {
  const std::vector<std::int32_t> arm = ancestors(model, bones[HumanBone::LeftUpperArm]);
  const std::vector<std::int32_t> legs = ancestors(model, bones[HumanBone::Hips]);
  std::vector<std::int32_t> back, neck;  // from the head down
  std::vector<std::int32_t> path = ancestors(model, bones[HumanBone::Head]);
  path.erase(path.begin());
  const auto is_joint = skin_joints(model);
  for (const std::int32_t node : path) {
    if (std::ranges::find(legs, node) != legs.end()) break;  // the hips, or what they hang on
    const bool carries_arms = std::ranges::find(arm, node) != arm.end();
    (carries_arms ? back : neck).push_back(node);
  }
  std::ranges::reverse(back);
  const auto name = [&](HumanBone bone, std::int32_t node) {
    if (!bones.has(bone) && std::ranges::find(bones.node, node) == bones.node.end())
      bones[bone] = node;
  };
  if (!neck.empty()) name(HumanBone::Neck, neck.back());
  if (!back.empty()) name(HumanBone::Spine, back.front());
  if (back.size() >= 3) name(HumanBone::Chest, back[back.size() - 2]);
  if (back.size() >= 3) name(HumanBone::UpperChest, back.back());
  if (back.size() == 2) name(HumanBone::Chest, back.back());
}

BoneMap find_bones(const Model& model, std::span<const Vec3> place, const std::string& file) {
  if (!model.vrm.version.empty()) return bones_of_vrm(model, file);
  BoneMap bones = bones_by_name(model);
  const std::string missing = missing_bones(bones);
  if (!missing.empty()) {
    if (model.skins.empty())
      refuse(file, fmt::format("it has no skeleton: no skin, and no nodes named for {}", missing),
             "bind the character to a skeleton (Mixamo does it by itself), and export it again");
    bones = bones_by_shape(model, place);
    if (!missing_bones(bones).empty())
      refuse(file,
             fmt::format("it is no human body: none of its joints is called, or lies like, {}",
                         missing),
             "name the joints as Mixamo, Unreal or VRM do");
  }
  name_trunk(model, bones);
  return bones;
}

}  // namespace docent::character
