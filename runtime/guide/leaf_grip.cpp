#include "runtime/guide/leaf_grip.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "runtime/scene/leaf_mesh.h"

namespace docent::guide {
namespace {

constexpr double palm_above = 0.01;  ///< Metres between a palm's middle and the bar.

/// Where the thumb of a hand is, palm down, whose arm comes from there.
Vec2 inwards(Side side, Vec2 from) noexcept {
  return (side == Side::Right ? 1.0 : -1.0) * Vec2{from.y, -from.x};
}

}  // namespace

motion::Grip pushing_grip(const HungLeaf& leaf, double angle, const Grasp& grasp,
                          double floor_height) noexcept {
  constexpr double bar_away = scene::bar_surface + palm_above;
  const Vec2 towards = direction_of(leaf, angle);
  const Vec2 back = direction_of(leaf, angle - std::numbers::pi / 2);
  return {.place = to_world(leaf.hinge + grasp.along * towards + bar_away * back,
                            floor_height + scene::bar_height),
          .fingers = glm::normalize(to_world(-0.8 * back, 0.55)),
          .thumb = to_world(inwards(grasp.side, back))};
}

motion::Grip drawing_grip(const HungLeaf& leaf, const Opening& opening, const Grasp& grasp,
                          double floor_height, Vec2 from) noexcept {
  constexpr double bar_away = scene::bar_surface;
  constexpr double above = scene::bar_thickness / 2 + palm_above;
  const double angle = opening.slides ? 0 : opening.amount;
  const double slid = opening.slides ? opening.amount : 0;
  const Vec2 towards = direction_of(leaf, angle);
  const Vec2 front = direction_of(leaf, angle + std::numbers::pi / 2);
  const Vec2 place = leaf.hinge - slid * leaf.along + grasp.along * towards + bar_away * front;
  const Vec2 back = from == place ? front : glm::normalize(from - place);
  return {.place = to_world(place, floor_height + scene::bar_height + above),
          .fingers = glm::normalize(to_world(-0.7 * back, -0.6)),
          .thumb = to_world(inwards(grasp.side, back))};
}

motion::Grip parting_grip(const HungLeaf& leaf, const Opening& opening, const Grasp& grasp,
                          double floor_height, Vec2 from, double share) noexcept {
  constexpr double back = 0.4;                       // a share of the way to the body
  constexpr double past_end = 0.08, nearest = 0.42;  // metres; of a hand to the body's middle
  constexpr float up = 0.04F;                        // metres
  const auto eased = [](double s) { return s * s * (3 - 2 * s); };
  motion::Grip grip = drawing_grip(leaf, opening, grasp, floor_height, from);
  const Vec2 to_body = from - to_floor(grip.place);
  const double out =
      std::min(leaf.width + past_end - grasp.along, std::max(0.0, glm::length(to_body) - nearest));
  const Vec2 away = opening.slides ? back * to_body : out * direction_of(leaf, opening.amount);
  grip.place += to_world(eased(share) * away) +
                Vec3{0, up * static_cast<float>(eased(std::min(4 * share, 1.0))), 0};
  return grip;
}

}  // namespace docent::guide
