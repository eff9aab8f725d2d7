#include "runtime/scene/shown_list.h"

#include <algorithm>
#include <cmath>

namespace docent::scene {
namespace {

constexpr float least_seen = 0.125F;  ///< Pixels.
/// How far a body reaches beyond the joint that moves it, metres: a head, a foot, a hand.
constexpr float reach = 0.3F;
/// The shadow of a foot fades over decimetres; this much of its height is not seen.
constexpr float least_height = 0.002F;

template <typename T>
void copy_into(std::vector<T>& to, const std::vector<T>& from) {
  to.reserve(from.capacity());
  to.assign(from.begin(), from.end());
}

/// Metres that something at `place` has to move to be seen to have.
float seen_movement(const CameraView& camera, Vec3 place, float pixels_high) noexcept {
  const float metres_high = 2 * std::tan(camera.vertical_fov / 2) * glm::length(camera.eye - place);
  return least_seen * metres_high / pixels_high;
}

/// The most that a vertex of the joint can have moved.
float movement(Vec3 joint, Vec3 joint_before, const Mat4& matrix, const Mat4& before) noexcept {
  float turned = 0;
  for (int axis = 0; axis < 3; ++axis)
    turned += glm::length(Vec3(matrix[axis]) - Vec3(before[axis]));
  return glm::length(joint - joint_before) + reach * turned;
}

}  // namespace

bool ShownList::differs(const DrawList& list, float pixels_high) const noexcept {
  return !is_kept_ || list.floor != kept_.floor || list.camera != kept_.camera ||
         list.light != kept_.light || list.focus != kept_.focus ||
         list.focus_radius != kept_.focus_radius || list.goal != kept_.goal ||
         list.goal_radius != kept_.goal_radius ||
         list.highlighted_exhibit != kept_.highlighted_exhibit || list.quads != kept_.quads ||
         list.walls != kept_.walls || list.objects != kept_.objects ||
         list.leaves != kept_.leaves || list.near_object != kept_.near_object ||
         list.markers != kept_.markers || list.ribbons != kept_.ribbons ||
         list.ribbon_point != kept_.ribbon_point || bodies_differ(list, pixels_high);
}

bool ShownList::bodies_differ(const DrawList& list, float pixels_high) const noexcept {
  if (list.avatars.size() != kept_.avatars.size() || list.palette.size() != kept_.palette.size() ||
      list.joint.size() != list.palette.size() || kept_.joint.size() != list.joint.size())
    return true;
  for (std::size_t i = 0; i < list.avatars.size(); ++i) {
    const AvatarDraw &now = list.avatars[i], &before = kept_.avatars[i];
    const float seen = seen_movement(list.camera, now.centre, pixels_high);
    if (now.first_matrix != before.first_matrix || now.look != before.look) return true;
    for (std::size_t side = 0; side < 2; ++side)
      if (glm::length(now.feet[side] - before.feet[side]) > seen ||
          std::abs(now.foot_height[side] - before.foot_height[side]) > least_height)
        return true;
    const std::size_t end =
        i + 1 < list.avatars.size() ? list.avatars[i + 1].first_matrix : list.palette.size();
    for (std::size_t j = now.first_matrix; j < end; ++j)
      if (movement(list.joint[j], kept_.joint[j], list.palette[j], kept_.palette[j]) > seen)
        return true;
  }
  return false;
}

void ShownList::keep(const DrawList& list) {
  kept_.floor = list.floor;
  kept_.camera = list.camera;
  kept_.light = list.light;
  kept_.focus = list.focus;
  kept_.focus_radius = list.focus_radius;
  kept_.goal = list.goal;
  kept_.goal_radius = list.goal_radius;
  kept_.highlighted_exhibit = list.highlighted_exhibit;
  kept_.walls = list.walls;
  kept_.near_object = list.near_object;
  copy_into(kept_.objects, list.objects);
  copy_into(kept_.leaves, list.leaves);
  copy_into(kept_.avatars, list.avatars);
  copy_into(kept_.palette, list.palette);
  copy_into(kept_.joint, list.joint);
  copy_into(kept_.ribbons, list.ribbons);
  copy_into(kept_.ribbon_point, list.ribbon_point);
  copy_into(kept_.markers, list.markers);
  copy_into(kept_.quads, list.quads);
  is_kept_ = true;
}

}  // namespace docent::scene
