#include "runtime/scene/shown_list.h"

#include <algorithm>
#include <cmath>

#include "runtime/scene/uncovered.h"

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

/// Where the matrices of an avatar end.
std::size_t end_of(const DrawList& list, std::size_t avatar) noexcept {
  return avatar + 1 < list.avatars.size() ? list.avatars[avatar + 1].first_matrix
                                          : list.palette.size();
}

void include(Rect& all, const Quad& quad) noexcept {
  const Rect one = reach_of(quad);
  if (all.width <= 0) {
    all = one;
    return;
  }
  const float end_x = std::max(all.x + all.width, one.x + one.width);
  const float end_y = std::max(all.y + all.height, one.y + one.height);
  all.x = std::min(all.x, one.x);
  all.y = std::min(all.y, one.y);
  all.width = end_x - all.x;
  all.height = end_y - all.y;
}

/// Do two ways lie in the same place, however far they have been walked?
bool lie_alike(const RibbonDraw& a, const RibbonDraw& b) noexcept {
  return a.kind == b.kind && a.look == b.look && a.first == b.first && a.count == b.count &&
         a.revision == b.revision && a.length == b.length;
}

Rect about_what_differs(const std::vector<Quad>& now, const std::vector<Quad>& before) noexcept {
  Rect all{};
  const std::size_t both = std::min(now.size(), before.size());
  for (std::size_t i = 0; i < both; ++i) {
    if (now[i] == before[i]) continue;
    include(all, now[i]);
    include(all, before[i]);
  }
  for (const auto* more : {&now, &before})
    for (std::size_t i = both; i < more->size(); ++i) include(all, (*more)[i]);
  return all;
}

}  // namespace

bool ShownList::model_differs(const DrawList& list) const noexcept {
  return list.floor != kept_.floor || list.camera != kept_.camera || list.light != kept_.light ||
         list.focus != kept_.focus || list.focus_radius != kept_.focus_radius ||
         list.fade != kept_.fade || list.goal != kept_.goal ||
         list.goal_radius != kept_.goal_radius ||
         list.highlighted_exhibit != kept_.highlighted_exhibit || list.walls != kept_.walls ||
         list.objects != kept_.objects || list.leaves != kept_.leaves ||
         list.near_object != kept_.near_object || list.markers != kept_.markers ||
         list.ribbon_point != kept_.ribbon_point ||
         !std::ranges::equal(list.ribbons, kept_.ribbons, lie_alike);
}

Change ShownList::change(const DrawList& list, float pixels_high) const noexcept {
  if (!is_kept_) return {};
  const std::size_t bodies = list.avatars.size();
  Change change{.everything = false, .interface = about_what_differs(list.quads, kept_.quads)};
  change.model = model_differs(list) || bodies != kept_.avatars.size() ||
                 list.palette.size() != kept_.palette.size() ||
                 list.joint.size() != list.palette.size() ||
                 kept_.joint.size() != list.joint.size();
  if (change.model) return change;
  change.ways = list.ribbons != kept_.ribbons;
  for (std::size_t i = 0; i < bodies; ++i) {
    if (!has_moved(list, i, pixels_high)) continue;
    change.model = change.model || i >= Change::most_bodies ||
                   list.avatars[i].look != kept_.avatars[i].look ||
                   list.avatars[i].first_matrix != kept_.avatars[i].first_matrix;
    if (i < Change::most_bodies) change.bodies.set(i);
  }
  return change;
}

bool ShownList::has_moved(const DrawList& list, std::size_t avatar,
                          float pixels_high) const noexcept {
  const AvatarDraw &now = list.avatars[avatar], &before = kept_.avatars[avatar];
  if (now.first_matrix != before.first_matrix || now.look != before.look) return true;
  const float seen = seen_movement(list.camera, now.centre, pixels_high);
  for (std::size_t side = 0; side < 2; ++side)
    if (glm::length(now.feet[side] - before.feet[side]) > seen ||
        std::abs(now.foot_height[side] - before.foot_height[side]) > least_height)
      return true;
  for (std::size_t j = now.first_matrix; j < end_of(list, avatar); ++j)
    if (movement(list.joint[j], kept_.joint[j], list.palette[j], kept_.palette[j]) > seen)
      return true;
  return false;
}

void ShownList::forget(TextureId texture) noexcept {
  if (texture == TextureId::None) return;
  for (Quad& quad : kept_.quads)
    if (quad.texture == texture) quad.texture = TextureId::None;
}

void ShownList::keep_bodies(const DrawList& list, const Change& change) {
  if (change.everything || change.model) {
    copy_into(kept_.avatars, list.avatars);
    copy_into(kept_.palette, list.palette);
    copy_into(kept_.joint, list.joint);
    return;
  }
  for (std::size_t i = 0; i < list.avatars.size(); ++i) {
    if (i >= Change::most_bodies || !change.bodies.test(i)) continue;
    const std::size_t first = list.avatars[i].first_matrix, end = end_of(list, i);
    kept_.avatars[i] = list.avatars[i];
    for (std::size_t j = first; j < end; ++j) {
      kept_.palette[j] = list.palette[j];
      kept_.joint[j] = list.joint[j];
    }
  }
}

void ShownList::keep(const DrawList& list, const Change& change) {
  keep_bodies(list, change);
  copy_into(kept_.quads, list.quads);
  copy_into(kept_.ribbons, list.ribbons);
  if (!change.everything && !change.model) return;
  kept_.floor = list.floor;
  kept_.camera = list.camera;
  kept_.light = list.light;
  kept_.focus = list.focus;
  kept_.focus_radius = list.focus_radius;
  kept_.fade = list.fade;
  kept_.goal = list.goal;
  kept_.goal_radius = list.goal_radius;
  kept_.highlighted_exhibit = list.highlighted_exhibit;
  kept_.walls = list.walls;
  kept_.near_object = list.near_object;
  copy_into(kept_.objects, list.objects);
  copy_into(kept_.leaves, list.leaves);
  copy_into(kept_.ribbon_point, list.ribbon_point);
  copy_into(kept_.markers, list.markers);
  is_kept_ = true;
}

}  // namespace docent::scene
