#include "runtime/guide/avatar.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "runtime/scene/look.h"

namespace docent::guide {
namespace {

/// How long the breathing takes to give way to the first step.
constexpr double leave_idle_seconds = 0.6;
/// Who walks looks where it will be in about a second: the head turns into a bend before the body
/// does (Grasso, Prevost, Ivanenko, Berthoz 1998).
constexpr double looks_ahead = 1.4;   ///< Metres along the way.
constexpr double nearly_there = 0.6;  ///< Metres: from here on it looks at what it came for.
constexpr double most_aside = 0.75;   ///< Radians that one looks into a bend.

constexpr double lift_step_seconds = 1.2;  ///< In which one steps into a lift, or out of it.
constexpr double lift_depth = 0.9;         ///< Metres from the stop to where one stands in it.

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

const Connection& connection_of(const Museum& museum, const plan::Ride& ride) noexcept {
  return museum.connections[ride.connection];
}

/// How high the ground is under body and feet: 0 but on a flight of stairs.
motion::Climb ground_under(const Avatar& avatar) noexcept {
  const motion::Walk& walk = avatar.plan->walk;
  if (walk.climb.empty() || ride_of(avatar) == nullptr) return {};
  const double last = static_cast<double>(walk.climb.size() - 1);
  const double at = std::clamp(avatar.seconds * walk.frame_rate, 0.0, last);
  const auto frame = static_cast<std::size_t>(at);
  const motion::Climb &now = walk.climb[frame],
                      &next = walk.climb[std::min(frame + 1, walk.climb.size() - 1)];
  motion::Climb ground = now;
  ground.body = std::lerp(now.body, next.body, static_cast<float>(at - static_cast<double>(frame)));
  return ground;
}

/// Is it carried, and does not walk from stop to stop?
bool is_carried(const plan::Plan& plan) noexcept {
  return plan.rests_until > 0;
}

/// How far a carried body is from where its plan has it: at the far stop. In a lift it steps in,
/// stands within while it is carried, and steps out.
Vec2 off_far_stop(const Connection& connection, const ConnectionStop& from,
                  const ConnectionStop& to, double seconds, double whole) noexcept {
  const double stepping = std::min(lift_step_seconds, whole / 4);
  const double carried = std::clamp((seconds - stepping) / (whole - 2 * stepping), 0.0, 1.0);
  const Vec2 off = from.placement.position - to.placement.position;
  if (connection.kind != ConnectionKind::Lift) return (1 - seconds / whole) * off;
  const auto into = [](const ConnectionStop& stop) {
    return lift_depth * Vec2{std::cos(stop.placement.heading), std::sin(stop.placement.heading)};
  };
  const double in = std::clamp(seconds / stepping, 0.0, 1.0);
  const double out = std::clamp((whole - seconds) / stepping, 0.0, 1.0);
  return glm::mix(off + in * into(from), out * into(to), carried);
}

/// Where on its ride the body is: a walk tells where on the floor's plan, and how far it has come
/// how high. Who is carried has the place of the far stop in its plan.
void ride(const Museum& museum, Avatar& avatar) noexcept {
  const auto floor_height = [&](std::uint32_t floor) { return museum.floors[floor].plan.height; };
  avatar.height = floor_height(avatar.floor);
  avatar.shown_floor = avatar.floor;
  avatar.aside = {};
  avatar.ground = ground_under(avatar);
  const plan::Ride* on = ride_of(avatar);
  if (on == nullptr) return;
  const Connection& connection = connection_of(museum, *on);
  const ConnectionStop &from = connection.stops[on->from], &to = connection.stops[on->to];
  const double share = ride_share(museum, avatar);
  avatar.height = std::lerp(floor_height(from.floor), floor_height(to.floor), share);
  if (!avatar.plan->walk.climb.empty())
    avatar.height = floor_height(from.floor) + static_cast<double>(avatar.ground.body);
  if (share >= 0.5) avatar.shown_floor = to.floor;
  if (!is_carried(*avatar.plan)) return;
  const double whole = avatar.plan->seconds();
  avatar.aside = off_far_stop(connection, from, to, std::min(avatar.seconds, whole), whole);
  avatar.body.position += avatar.aside;
}

/// At the end of a ride it is on the other floor.
void land(const Museum& museum, Avatar& avatar) noexcept {
  const plan::Ride* on = ride_of(avatar);
  if (on == nullptr || avatar.seconds < avatar.plan->seconds()) return;
  avatar.floor = connection_of(museum, *on).stops[on->to].floor;
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

/// Where the way leads, from where the body faces: radians.
double way_ahead(const Avatar& avatar) noexcept {
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
  return std::clamp(aside, -most_aside, most_aside);
}

Bearing bearing_of(const Avatar& avatar) noexcept {
  const plan::Plan& plan = *avatar.plan;
  return {.body = avatar.body,
          .height = avatar.height,
          .way_ahead = way_ahead(avatar),
          .metres_left = plan.reach.empty() ? 0 : plan.reach.back() - avatar.along,
          .stands = avatar.gait == motion::Gait::Idle,
          .walks = avatar.gait == motion::Gait::Walk};
}

/// Fills the palette that the body is drawn with; cloth and hair swing.
void dress(const Museum& museum, Avatar& avatar, double seconds) noexcept {
  const SkinnedMesh& mesh = museum.avatar;
  const std::size_t joints = avatar.world.size();
  const std::size_t bound = mesh.inverse_bind.size();
  if (joints == 0 || bound == 0 || bound % joints != 0 || avatar.palette.size() < joints) return;
  const bool each_has_its_own = bound > joints;
  const std::size_t body = scene::body_of(
      avatar.look, std::max(mesh.figure_end.size(), bound / joints), each_has_its_own);
  motion::fill_skinning_palette(
      avatar.world,
      std::span(mesh.inverse_bind).subspan(each_has_its_own ? body * joints : 0, joints),
      avatar.palette);
  const motion::ClothView cloth{of_figure(mesh.cloth.node, body),
                                of_figure(mesh.cloth.collider, body)};
  const std::size_t matrices = joints + cloth.node.size();
  if (matrices > avatar.palette.size()) return;
  const auto palette = std::span(avatar.palette).first(matrices);
  if (avatar.breathes && avatar.dressed_as == body)
    motion::swing(cloth, seconds, palette, avatar.cloth);
  else
    motion::hang(cloth, palette, avatar.cloth);
  avatar.dressed_as = body;
  // What hangs on other bodies only is nowhere beside this one.
  const auto worn = static_cast<std::ptrdiff_t>(cloth.node.size());
  std::fill(avatar.cloth.place.begin() + worn, avatar.cloth.place.end(), Vec3(avatar.world[0][3]));
}

void pose(const Museum& museum, Avatar& avatar, double seconds) noexcept {
  const motion::Walk& walk = avatar.plan->walk;
  if (walk.joint_count == 0 || walk.joint_count != avatar.rotation.size()) return;
  const Skeleton& skeleton = museum.motion.skeleton;
  motion::PoseView view{.root = {}, .rotation = avatar.rotation};
  motion::sample(walk, avatar.seconds, view);
  view.root += to_world(avatar.aside, avatar.height);
  motion::add_idle(skeleton, avatar.limbs, {avatar.standing, avatar.idle_weight, avatar.manner.who},
                   view);
  behave(skeleton, avatar.limbs.arms, avatar.company, bearing_of(avatar), seconds, avatar.manner,
         view);
  motion::to_world_space(skeleton, view, avatar.world);
  dress(museum, avatar, seconds);
}

/// World y of a body part; the floor where the skeleton has no such part.
Vec3 place_of(const Museum& museum, const Avatar& avatar, BodyPart part) noexcept {
  const JointIndex joint = museum.motion.skeleton[part];
  if (joint == JointIndex::None || index_of(joint) >= avatar.world.size()) return {};
  return Vec3(avatar.world[index_of(joint)][3]);
}

}  // namespace

const plan::Ride* ride_of(const Avatar& avatar) noexcept {
  const plan::WalkOrder& order = avatar.plan->order;
  return order.ride && order.floor == avatar.floor ? &*order.ride : nullptr;
}

double ride_share(const Museum& museum, const Avatar& avatar) noexcept {
  const plan::Ride* on = ride_of(avatar);
  if (on == nullptr) return 0;
  const Connection& connection = connection_of(museum, *on);
  if (is_carried(*avatar.plan)) {
    const double whole = avatar.plan->seconds();
    const double still =
        connection.kind == ConnectionKind::Lift ? std::min(lift_step_seconds, whole / 4) : 0.0;
    return std::clamp((avatar.seconds - still) / (whole - 2 * still), 0.0, 1.0);
  }
  const Vec2 from = connection.stops[on->from].placement.position;
  const Vec2 to = connection.stops[on->to].placement.position;
  const double length = glm::distance(from, to);
  return std::clamp(dot(avatar.body.position - from, to - from) / (length * length), 0.0, 1.0);
}

Avatar make_avatar(const Museum& museum, std::uint32_t floor, std::unique_ptr<plan::Plan> standing,
                   std::uint64_t who) {
  Avatar avatar;
  avatar.manner.who = who;
  avatar.limbs = motion::find_limbs(museum.motion.skeleton);
  avatar.floor = floor;
  avatar.plan = std::move(standing);
  avatar.rotation.resize(avatar.plan->walk.joint_count, Quat(1, 0, 0, 0));
  avatar.world.resize(avatar.rotation.size(), Mat4(1));
  if (!museum.avatar.inverse_bind.empty()) {
    const std::size_t nodes = nodes_of(museum.avatar);
    avatar.palette.resize(avatar.world.size() + nodes, Mat4(1));
    avatar.cloth = motion::make_cloth_motion(nodes);
  }
  advance(museum, avatar, 0);
  const auto ground = static_cast<float>(avatar.height);
  avatar.ankle_rest = place_of(museum, avatar, BodyPart::LeftAnkle).y - ground;
  avatar.toe_rest = place_of(museum, avatar, BodyPart::LeftToe).y - ground;
  return avatar;
}

float build_of(const Avatar& avatar) noexcept {
  return scene::looks[avatar.look % scene::looks.size()].height;
}

bool has_finished(const Avatar& avatar) noexcept {
  return !avatar.next && avatar.plan->is_whole && avatar.seconds >= avatar.plan->seconds();
}

Placement place_ahead(const Avatar& avatar, double seconds) noexcept {
  const plan::Plan* plan = avatar.plan.get();
  double at = avatar.seconds + seconds;
  if (avatar.next && at >= change_of(avatar)) {
    at -= change_of(avatar);
    plan = avatar.next.get();
  }
  const motion::Walk& walk = plan->walk;
  if (walk.body.empty()) return avatar.body;
  const double last = static_cast<double>(walk.body.size() - 1);
  const double frame = std::clamp(at * walk.frame_rate, 0.0, last);
  const auto before = static_cast<std::size_t>(frame);
  return interpolated(walk.body[before], walk.body[std::min(before + 1, walk.body.size() - 1)],
                      frame - static_cast<double>(before));
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
  land(museum, avatar);
  follow(avatar);
  ride(museum, avatar);
  if (has_finished(avatar)) {
    if (avatar.idle_weight < 1) avatar.standing = 0;
    avatar.idle_weight = 1;
  } else {
    avatar.idle_weight = std::max(0.0, avatar.idle_weight - seconds / leave_idle_seconds);
  }
  if (avatar.breathes) avatar.standing += seconds;
  pose(museum, avatar, seconds);
}

void draw(const Museum& museum, const Avatar& avatar, scene::DrawList& list) noexcept {
  const std::size_t joints = avatar.world.size();
  if (joints == 0 || avatar.palette.empty()) return;
  const std::size_t first = list.palette.size();
  list.palette.insert(list.palette.end(), avatar.palette.begin(), avatar.palette.end());
  list.joint.resize(list.palette.size());
  for (std::size_t j = 0; j < joints; ++j) list.joint[first + j] = Vec3(avatar.world[j][3]);
  for (std::size_t n = joints; n < avatar.palette.size(); ++n)
    list.joint[first + n] = avatar.cloth.place[n - joints];

  scene::AvatarDraw it;
  it.first_matrix = static_cast<std::uint32_t>(first);
  it.look = avatar.look;
  it.centre = Vec3(avatar.world[0][3]);
  const auto height = static_cast<float>(avatar.height) - avatar.ground.body;
  constexpr std::array feet{std::pair{BodyPart::LeftAnkle, BodyPart::LeftToe},
                            std::pair{BodyPart::RightAnkle, BodyPart::RightToe}};
  for (std::size_t side = 0; side < feet.size(); ++side) {
    const Vec3 ankle = place_of(museum, avatar, feet[side].first);
    const Vec3 toe = place_of(museum, avatar, feet[side].second);
    const float ground = height + avatar.ground.foot[side];
    it.feet[side] = {(ankle.x + toe.x) / 2, ground, (ankle.z + toe.z) / 2};
    it.foot_height[side] =
        std::max(0.0F, std::min(ankle.y - avatar.ankle_rest, toe.y - avatar.toe_rest) - ground);
  }
  list.avatars.push_back(it);
}

}  // namespace docent::guide
