#include "runtime/guide/avatar.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace docent::guide {
namespace {

/// How long the breathing takes to give way to the first step.
constexpr double leave_idle_seconds = 0.4;
/// Who walks looks where it will be in about a second: the head turns into a bend before the body
/// does (Grasso, Prevost, Ivanenko, Berthoz 1998).
constexpr double looks_ahead = 1.4;   ///< Metres along the way.
constexpr double nearly_there = 0.6;  ///< Metres: from here on it looks at what it came for.
constexpr double most_gaze = 0.75;    ///< Radians.
constexpr double gaze_quickness = 7;  ///< Of a critically damped spring, 1/s.

Placement interpolated(const Placement& a, const Placement& b, double t) noexcept {
  return {glm::mix(a.position, b.position, t),
          a.heading + std::remainder(b.heading - a.heading, 2 * std::numbers::pi) * t};
}

/// Where the body is on its walk at this moment.
void follow(Avatar& avatar) noexcept {
  const motion::Walk& walk = avatar.plan->walk;
  if (walk.body.empty()) return;
  const double at =
      std::clamp(avatar.seconds * walk.frame_rate, 0.0, static_cast<double>(walk.body.size() - 1));
  const auto frame = static_cast<std::size_t>(at);
  const std::size_t after = std::min(frame + 1, walk.body.size() - 1);
  const double t = at - static_cast<double>(frame);
  avatar.body = interpolated(walk.body[frame], walk.body[after], t);
  avatar.along =
      std::lerp(static_cast<double>(walk.along[frame]), static_cast<double>(walk.along[after]), t);
  avatar.gait = has_finished(avatar) ? motion::Gait::Idle : walk.gait[frame];
}

/// When the next plan takes over, in seconds of the present one.
double change_of(const Avatar& avatar) noexcept {
  const plan::WalkOrder& order = avatar.next->order;
  return order.seconds ? order.previous_seconds
                       : order.previous_frame / avatar.plan->walk.frame_rate;
}

/// Changes to the next plan at exactly the frame from which it was made.
void change_plan(Avatar& avatar) noexcept {
  if (!avatar.next) return;
  const double change = change_of(avatar);
  if (avatar.seconds < change) return;
  avatar.seconds -= change;
  avatar.plan = std::move(avatar.next);
}

double wanted_gaze(const Avatar& avatar) noexcept {
  const plan::Plan& plan = *avatar.plan;
  if (has_finished(avatar) || plan.points.size() < 2 || plan.walk.body.empty()) return 0;
  const bool near = plan.is_whole && avatar.along > plan.reach.back() - nearly_there;
  double heading = plan.walk.body.back().heading;
  if (!near) {
    const Vec2 to = plan::point_along(plan, avatar.along + looks_ahead) - avatar.body.position;
    if (dot(to, to) < 0.01) return 0;
    heading = std::atan2(to.y, to.x);
  }
  const double aside = std::remainder(heading - avatar.body.heading, 2 * std::numbers::pi);
  return std::clamp(aside, -most_gaze, most_gaze);
}

void look_ahead(Avatar& avatar, double seconds) noexcept {
  // Steps are at most a frame's: the spring stays stable whatever time went by.
  constexpr double longest_step = 1.0 / 30;
  const double dt = std::min(seconds, longest_step), w = gaze_quickness;
  avatar.gaze_rate += (w * w * (wanted_gaze(avatar) - avatar.gaze) - 2 * w * avatar.gaze_rate) * dt;
  avatar.gaze += avatar.gaze_rate * dt;
}

void pose(const Museum& museum, Avatar& avatar) noexcept {
  const motion::Walk& walk = avatar.plan->walk;
  if (walk.joint_count == 0 || walk.joint_count != avatar.rotation.size()) return;
  motion::PoseView view{.root = {}, .rotation = avatar.rotation};
  motion::sample(walk, avatar.seconds, view);
  if (avatar.idle_weight > 0) {
    std::ranges::copy(avatar.rotation, avatar.still.begin());
    motion::PoseView living{.root = view.root, .rotation = avatar.still};
    motion::add_idle(museum.motion.skeleton, avatar.standing, living);
    const auto weight = static_cast<float>(avatar.idle_weight);
    view.root = glm::mix(view.root, living.root, weight);
    for (std::size_t j = 0; j < avatar.rotation.size(); ++j)
      avatar.rotation[j] = glm::slerp(avatar.rotation[j], avatar.still[j], weight);
  }
  motion::turn_head(museum.motion.skeleton, static_cast<float>(avatar.gaze), view);
  motion::to_world_space(museum.motion.skeleton, view, avatar.world);
  const auto height = static_cast<float>(museum.floors[avatar.floor].plan.height);
  for (Mat4& joint : avatar.world) joint[3].y += height;
}

/// World y of a body part; the floor where the skeleton has no such part.
Vec3 place_of(const Museum& museum, const Avatar& avatar, BodyPart part) noexcept {
  const JointIndex joint = museum.motion.skeleton[part];
  if (joint == JointIndex::None || index_of(joint) >= avatar.world.size()) return {};
  return Vec3(avatar.world[index_of(joint)][3]);
}

}  // namespace

Avatar make_avatar(const Museum& museum, std::uint32_t floor,
                   std::unique_ptr<plan::Plan> standing) {
  Avatar avatar;
  avatar.floor = floor;
  avatar.plan = std::move(standing);
  avatar.rotation.resize(avatar.plan->walk.joint_count, Quat(1, 0, 0, 0));
  avatar.still = avatar.rotation;
  avatar.world.resize(avatar.rotation.size(), Mat4(1));
  advance(museum, avatar, 0);
  avatar.ankle_rest = place_of(museum, avatar, BodyPart::LeftAnkle).y;
  avatar.toe_rest = place_of(museum, avatar, BodyPart::LeftToe).y;
  return avatar;
}

bool has_finished(const Avatar& avatar) noexcept {
  return !avatar.next && avatar.plan->is_whole && avatar.seconds >= avatar.plan->seconds();
}

std::uint32_t frame_ahead(const Avatar& avatar, double lead) noexcept {
  const motion::Walk& walk = avatar.plan->walk;
  if (walk.root.empty()) return 0;
  const double frame = std::ceil((avatar.seconds + lead) * walk.frame_rate);
  return static_cast<std::uint32_t>(std::min(frame, static_cast<double>(walk.root.size() - 1)));
}

bool take_plan(Avatar& avatar, std::unique_ptr<plan::Plan> plan) noexcept {
  const motion::Walk& walk = avatar.plan->walk;
  if (plan->order.seconds) {
    if (avatar.seconds > plan->order.previous_seconds + 1e-6) return false;
    avatar.next = std::move(plan);
    return true;
  }
  const double change = plan->order.previous_frame / walk.frame_rate;
  const bool stands_there = plan->order.previous_frame + 1 >= walk.root.size() &&
                            avatar.seconds >= avatar.plan->seconds();
  if (stands_there) {
    avatar.seconds = change;  // however long it has stood: it sets out now
  } else if (avatar.seconds > change) {
    return false;
  }
  avatar.next = std::move(plan);
  return true;
}

void advance(const Museum& museum, Avatar& avatar, double seconds) noexcept {
  avatar.seconds += seconds;
  change_plan(avatar);
  follow(avatar);
  if (has_finished(avatar)) {
    if (avatar.idle_weight < 1) avatar.standing = 0;
    avatar.idle_weight = 1;
  } else {
    avatar.idle_weight = std::max(0.0, avatar.idle_weight - seconds / leave_idle_seconds);
  }
  if (avatar.breathes) avatar.standing += seconds;
  look_ahead(avatar, seconds);
  pose(museum, avatar);
}

void draw(const Museum& museum, const Avatar& avatar, scene::DrawList& list) noexcept {
  const std::vector<Mat4>& inverse_bind = museum.avatar.inverse_bind;
  if (avatar.world.empty() || inverse_bind.size() != avatar.world.size()) return;
  const std::size_t first = list.palette.size();
  list.palette.resize(first + avatar.world.size());
  motion::fill_skinning_palette(avatar.world, inverse_bind,
                                std::span(list.palette).subspan(first, avatar.world.size()));
  list.joint.resize(first + avatar.world.size());
  for (std::size_t j = 0; j < avatar.world.size(); ++j)
    list.joint[first + j] = Vec3(avatar.world[j][3]);

  scene::AvatarDraw it;
  it.first_matrix = static_cast<std::uint32_t>(first);
  it.look = avatar.look;
  it.centre = Vec3(avatar.world[0][3]);
  const auto floor = static_cast<float>(museum.floors[avatar.floor].plan.height);
  constexpr std::array feet{std::pair{BodyPart::LeftAnkle, BodyPart::LeftToe},
                            std::pair{BodyPart::RightAnkle, BodyPart::RightToe}};
  for (std::size_t side = 0; side < feet.size(); ++side) {
    const Vec3 ankle = place_of(museum, avatar, feet[side].first);
    const Vec3 toe = place_of(museum, avatar, feet[side].second);
    it.feet[side] = {(ankle.x + toe.x) / 2, floor, (ankle.z + toe.z) / 2};
    it.foot_height[side] =
        std::max(0.0F, std::min(ankle.y - avatar.ankle_rest, toe.y - avatar.toe_rest));
  }
  list.avatars.push_back(it);
}

}  // namespace docent::guide
