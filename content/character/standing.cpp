#include "content/character/standing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include "content/character/find_bones.h"
#include "content/content_error.h"
#include "content/import/gltf/placing.h"

namespace docent::character {
namespace {

using import::gltf::entry;
using import::gltf::Model;

/// Of a person's bones, most lie half a metre from the hips and none much more than one.
constexpr float farthest_bone = 10;

std::vector<Vec3> places_of(const std::vector<Mat4>& world) {
  std::vector<Vec3> place;
  for (const Mat4& m : world) place.emplace_back(m[3]);
  return place;
}

bool is_sound(const Mat4& m) {
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r)
      if (!std::isfinite(m[c][r]) || std::abs(m[c][r]) > 1e12F) return false;
  return std::abs(glm::determinant(glm::mat3(m))) > 1e-30F;
}

/// The world transforms in which every skin is as it was modelled: where the joint that most of
/// the body hangs on stands at rest, and the others as their inverse bind matrices say.
std::vector<Mat4> binds_of(const Model& model, const std::vector<Mat4>& rest,
                           const BoneMap& bones) {
  std::vector<std::optional<Mat4>> stated(rest.size());
  for (const import::gltf::Skin& skin : model.skins) {
    std::size_t base = 0;
    for (std::size_t j = 0; j < skin.joints.size(); ++j)
      if (skin.joints[j] == bones[HumanBone::Hips]) base = j;
    const Mat4 to_world = rest[entry(skin.joints[base])] * skin.inverse_bind[base];
    if (!is_sound(to_world)) continue;
    for (std::size_t j = 0; j < skin.joints.size(); ++j)
      if (is_sound(skin.inverse_bind[j]) && !stated[entry(skin.joints[j])])
        stated[entry(skin.joints[j])] = to_world * glm::inverse(skin.inverse_bind[j]);
  }
  std::vector<Mat4> bind(rest.size(), Mat4{1});
  for (const std::int32_t n : model.order) {
    const import::gltf::Node& node = model.nodes[entry(n)];
    const Mat4 follows = node.parent < 0 ? node.local : bind[entry(node.parent)] * node.local;
    bind[entry(n)] = stated[entry(n)].value_or(follows);
  }
  return bind;
}

struct Body {
  Vec3 hips, head, left_hip, right_hip, left_foot, right_foot, left_hand, right_hand;
};

Body body_of(const BoneMap& bones, const std::vector<Mat4>& world) {
  const auto at = [&](HumanBone bone) { return Vec3(world[entry(bones[bone])][3]); };
  return {.hips = at(HumanBone::Hips),
          .head = at(HumanBone::Head),
          .left_hip = at(HumanBone::LeftUpperLeg),
          .right_hip = at(HumanBone::RightUpperLeg),
          .left_foot = at(HumanBone::LeftFoot),
          .right_foot = at(HumanBone::RightFoot),
          .left_hand = at(HumanBone::LeftHand),
          .right_hand = at(HumanBone::RightHand)};
}

/// Does the body stand on two legs where this is up?
bool stands(const Body& body, Vec3 up) {
  const Vec3 hips = 0.5F * (body.left_hip + body.right_hip);
  const Vec3 feet = 0.5F * (body.left_foot + body.right_foot);
  const Vec3 trunk = body.head - hips, legs = feet - hips;
  const float trunk_length = glm::length(trunk), leg_length = glm::length(legs);
  if (!(trunk_length > 1e-6F) || !(leg_length > 1e-6F)) return false;
  const float hands = glm::dot(0.5F * (body.left_hand + body.right_hand) - feet, up);
  return glm::dot(trunk, up) > 0.75F * trunk_length && glm::dot(legs, up) < -0.7F * leg_length &&
         hands > 0.2F * leg_length;
}

/// The turn that stands the body upright and facing +z.
std::optional<Mat4> upright(const Body& body, bool& is_turned_up) {
  constexpr std::array<Vec3, 6> axes{Vec3{0, 1, 0}, {0, 0, 1}, {0, 0, -1},
                                     {0, -1, 0},    {1, 0, 0}, {-1, 0, 0}};
  const auto up = std::ranges::find_if(axes, [&](Vec3 axis) { return stands(body, axis); });
  if (up == axes.end()) return {};
  is_turned_up = up != axes.begin();
  Vec3 left = body.left_hip - body.right_hip;
  left -= glm::dot(left, *up) * *up;
  if (!(glm::length(left) > 1e-6F)) return {};
  left = glm::normalize(left);
  const Vec3 forward = glm::cross(left, *up);
  // Rows are the new axes.
  return Mat4(glm::transpose(glm::mat3(left, *up, forward)));
}

/// Refuses a skeleton of which a bone lies far from the others, or nowhere: such a body has no
/// size.
void refuse_far_bones(const BoneMap& bones, const std::vector<Mat4>& world, const char* pose,
                      const std::string& file) {
  const auto at = [&](std::int32_t node) { return Vec3(world[entry(node)][3]); };
  std::vector<float> distances;
  for (const std::int32_t node : bones.node)
    if (node >= 0) distances.push_back(glm::distance(at(node), at(bones[HumanBone::Hips])));
  std::vector<float> sorted = distances;
  // What is no number counts as far: it has no place among the others.
  for (float& d : sorted)
    if (std::isnan(d)) d = std::numeric_limits<float>::infinity();
  std::ranges::nth_element(sorted, sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2));
  const float usual = sorted[sorted.size() / 2];
  std::size_t k = 0;
  for (std::size_t b = 0; b < bone_count; ++b) {
    if (bones.node[b] < 0) continue;
    if (!(distances[k++] <= farthest_bone * usual) || !std::isfinite(usual))
      throw content::ContentError(
          file, 0, 0, "not-humanoid",
          fmt::format("its {} lies more than {} times as far from the hips as most bones, {}",
                      bone_names[b], farthest_bone, pose),
          "put the skeleton right in the program that made it, and export it again");
  }
}

/// Degrees that an arm points above the horizontal.
float elevation(Vec3 upper_arm, Vec3 hand) {
  const Vec3 arm = hand - upper_arm;
  const float out = std::sqrt(arm.x * arm.x + arm.z * arm.z);
  return std::atan2(arm.y, out) * 180 / std::numbers::pi_v<float>;
}

}  // namespace

Standing stand_up(const Model& model, const std::string& file, std::vector<std::string>& notes) {
  Standing standing;
  standing.rest = import::gltf::world_of_nodes(model);
  standing.bones = find_bones(model, places_of(standing.rest), file);
  standing.bind = binds_of(model, standing.rest, standing.bones);
  bool is_turned_up = false;
  const auto turn = upright(body_of(standing.bones, standing.rest), is_turned_up);
  if (!turn)
    throw content::ContentError(
        file, 0, 0, "not-humanoid",
        "its bones are named as a person's are, and do not stand like one: the head is not over "
        "the "
        "hips, the feet are not under them, or the hands are at the ground",
        "only what stands on two legs can be a guide; anything else can be an exhibit's object");
  if (is_turned_up) notes.emplace_back("it lay on its back or side, and was stood up");
  standing.turn = *turn;
  for (Mat4& m : standing.rest) m = *turn * m;
  for (Mat4& m : standing.bind) m = *turn * m;
  refuse_far_bones(standing.bones, standing.rest, "as its nodes stand", file);
  refuse_far_bones(standing.bones, standing.bind, "as its skin was bound", file);
  const auto of_arm = [&](HumanBone upper, HumanBone hand) {
    return elevation(standing.at_rest(upper), standing.at_rest(hand));
  };
  standing.arm_elevation = 0.5F * (of_arm(HumanBone::LeftUpperArm, HumanBone::LeftHand) +
                                   of_arm(HumanBone::RightUpperArm, HumanBone::RightHand));
  standing.pose = std::abs(standing.arm_elevation) <= 15 ? RestPose::T
                  : standing.arm_elevation < -65         ? RestPose::ArmsDown
                                                         : RestPose::A;
  return standing;
}

}  // namespace docent::character
