#include "runtime/guide/closer_look.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace docent::guide {
namespace {

constexpr float far = 0.02F;            ///< Of the glass: a finger that moves less presses.
constexpr double nearly_whole = 1.08;   ///< Let go so near, the model is seen whole again.
constexpr double glide_seconds = 0.12;  ///< In which that is mostly done.
constexpr double least_apart = 0.2;     ///< Metres of floor between two fingers.

Vec2 up_of(double yaw) noexcept {
  return {std::cos(yaw), std::sin(yaw)};
}
Vec2 right_of(double yaw) noexcept {
  return {std::sin(yaw), -std::cos(yaw)};
}

/// What a point of the screen shows of the floor, from the target of the whole model's rig; none
/// above the horizon.
std::optional<Vec2> ground_at(const scene::CameraRig& rig, const scene::CameraRig& whole,
                              float aspect, scene::ScreenPoint at) noexcept {
  const auto point = scene::point_at_height(scene::view_of(rig, aspect), at, whole.target.y);
  if (!point) return {};
  const Vec2 off = to_floor(*point) - to_floor(whole.target);
  return Vec2{dot(off, right_of(whole.yaw)), dot(off, up_of(whole.yaw))};
}

const input::Finger& finger_of(std::span<const input::Finger> fingers, std::uint32_t id) noexcept {
  return *std::ranges::find_if(fingers, [&](const input::Finger& one) { return one.at.id == id; });
}

}  // namespace

WholeModel whole_model(std::span<const Vec2> outline, double height, double yaw,
                       const scene::Rect& free, float aspect) noexcept {
  WholeModel model{.rig = scene::overview_of(outline, height, yaw, free, aspect)};
  for (const Vec2 corner : outline) {
    const Vec2 off = corner - to_floor(model.rig.target);
    const Vec2 seen{dot(off, right_of(yaw)), dot(off, up_of(yaw))};
    model.least = glm::min(model.least, seen);
    model.most = glm::max(model.most, seen);
  }
  return model;
}

scene::CameraRig CloserLook::applied_to(scene::CameraRig rig) const noexcept {
  const Vec2 off = shift_.x * right_of(rig.yaw) + shift_.y * up_of(rig.yaw);
  const Vec3 moved = to_world(off, 0);
  rig.target.x += moved.x;
  rig.target.z += moved.z;
  rig.distance /= nearness_;
  return rig;
}

bool CloserLook::has_moved(std::uint32_t finger) const noexcept {
  return std::ranges::any_of(std::span(held_).first(held_count_), [&](const Held& one) {
    return one.finger == finger && one.has_moved;
  });
}

void CloserLook::end(bool at_once) noexcept {
  if (at_once) {
    nearness_ = 1;
    shift_ = {};
    held_count_ = 0;
    moves_ = false;
  }
  ends_ = true;
}

/// Fingers have come or gone: those that are there hold what is under them.
void CloserLook::hold(std::span<const input::Finger> fingers, const WholeModel& model,
                      float aspect) noexcept {
  const std::array<Held, 2> before = held_;
  const auto known = std::span(before).first(held_count_);
  held_count_ = 0;
  moves_ = false;
  for (const input::Finger& finger : fingers) {
    const auto ground =
        ground_at(applied_to(model.rig), model.rig, aspect, {finger.at.x, finger.at.y});
    if (!ground) continue;
    const auto was = std::ranges::find(known, finger.at.id, &Held::finger);
    held_[held_count_++] = {
        finger.at.id, *ground, {finger.at.x, finger.at.y}, was != known.end() && was->has_moved};
  }
}

/// Nothing leaps: what is under the fingers now is what they take along.
void CloserLook::begin_to_move(std::span<const input::Finger> fingers, const WholeModel& model,
                               float aspect) noexcept {
  if (held_count_ < 2 && nearness_ == 1) return;  // there is nowhere to go
  const bool has_come =
      std::ranges::any_of(std::span(held_).first(held_count_), [&](const Held& one) {
        const input::Contact& at = finger_of(fingers, one.finger).at;
        return std::abs(at.x - one.from.x) > far || std::abs(at.y - one.from.y) > far;
      });
  if (!has_come) return;
  hold(fingers, model, aspect);
  moves_ = held_count_ > 0;
  for (Held& one : std::span(held_).first(held_count_)) one.has_moved = true;
}

void CloserLook::follow(std::span<const input::Finger> fingers, const WholeModel& model,
                        float aspect) noexcept {
  std::array<Vec2, 2> seen{};
  const auto see = [&] {
    for (std::size_t i = 0; i < held_count_; ++i) {
      const input::Contact& at = finger_of(fingers, held_[i].finger).at;
      const auto ground = ground_at(applied_to(model.rig), model.rig, aspect, {at.x, at.y});
      if (!ground) return false;
      seen[i] = *ground;
    }
    return true;
  };
  if (!see()) return;
  if (held_count_ == 2) {
    const double held = glm::distance(held_[0].ground, held_[1].ground);
    const double now = glm::distance(seen[0], seen[1]);
    if (now > least_apart && held > least_apart)
      nearness_ = std::clamp(nearness_ * now / held, 1.0, nearest);
    if (!see()) return;
  }
  Vec2 off{};
  for (std::size_t i = 0; i < held_count_; ++i) off += held_[i].ground - seen[i];
  shift_ += off / static_cast<double>(held_count_);
  keep_within(model);
}

/// As much beyond the edges as is seen of them when the model is whole.
void CloserLook::keep_within(const WholeModel& model) noexcept {
  const double room = 1 - 1 / nearness_;
  shift_ = glm::clamp(shift_, room * model.least, room * model.most);
}

void CloserLook::step(std::span<const input::Finger> fingers, const WholeModel& model, float aspect,
                      float seconds) noexcept {
  fingers = fingers.first(std::min(fingers.size(), held_.size()));
  const auto is_held = [&](const input::Finger& finger) {
    return std::ranges::find(std::span(held_).first(held_count_), finger.at.id, &Held::finger) !=
           std::span(held_).first(held_count_).end();
  };
  if (fingers.empty()) {
    if (held_count_ > 0 && nearness_ < nearly_whole) ends_ = true;
    held_count_ = 0;
    moves_ = false;
  } else {
    ends_ = false;
    if (fingers.size() != held_count_ || !std::ranges::all_of(fingers, is_held))
      hold(fingers, model, aspect);
    if (held_count_ > 0 && !moves_) begin_to_move(fingers, model, aspect);
    if (moves_) follow(fingers, model, aspect);
  }
  if (!ends_) return;
  constexpr double whole = 1.002;
  const double left = std::exp(-static_cast<double>(seconds) / glide_seconds);
  nearness_ = 1 + (nearness_ - 1) * left;
  shift_ *= left;
  if (nearness_ < whole) nearness_ = 1;
  keep_within(model);
}

}  // namespace docent::guide
