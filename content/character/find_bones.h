#pragma once

#include <span>
#include <string>
#include <vector>

#include "content/character/human_bone.h"
#include "content/import/gltf/model.h"

namespace docent::character {

/// Which nodes are the bones of a human body: as VRM states it, else by the names that Mixamo,
/// Unreal, Rigify, MakeHuman, Biped, Daz, VRoid and many others give, else by the shape of the
/// skin's joints. `place` has each node's place in the world.
///
/// ContentError (`not-humanoid`) that names what is missing where it is no human body.
BoneMap find_bones(const import::gltf::Model& model, std::span<const Vec3> place,
                   const std::string& file);

/// By names alone; bones that no name tells stay away.
BoneMap bones_by_name(const import::gltf::Model& model);

/// By the shape of a body that stands upright (+y): two chains end lowest, one highest, two reach
/// out to the sides. Empty where it is not so.
BoneMap bones_by_shape(const import::gltf::Model& model, std::span<const Vec3> place);

/// The joints of any skin.
std::vector<bool> skin_joints(const import::gltf::Model& model);

/// Names spine, chest and neck: what lies between hips and head. What is named already stays.
void name_trunk(const import::gltf::Model& model, BoneMap& bones);

/// The required bones that are missing, as VRM names them: "leftHand, rightHand".
std::string missing_bones(const BoneMap& bones);

}  // namespace docent::character
