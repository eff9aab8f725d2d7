#include "runtime/guide/step_aside.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "runtime/scene/camera.h"

namespace docent::guide {
namespace {

constexpr std::array sidewards{0.95, 0.8, 0.68};      ///< Metres from the line of sight...
constexpr std::array onwards{0.3, 0.1, -0.15, -0.4};  ///< ... and along it.
constexpr double gap = 0.12;                          ///< Metres between a body and what it shows.
constexpr double most_half = 1.15;  ///< Radians that it turns from what it shows at most.
constexpr double room = 0.05;       ///< Metres more than its radius.
constexpr double other_side = 1e3;  ///< More than any other cost.

double wrapped(double angle) noexcept {
  return std::remainder(angle, 2 * std::numbers::pi);
}

double direction_of(Vec2 line) noexcept {
  return std::atan2(line.y, line.x);
}

double direction_of_exhibit(const interface::Goal& goal) noexcept {
  const Vec2 line = goal.position - goal.standing.position;
  return glm::length(line) > 0.05 ? direction_of(line) : goal.standing.heading;
}

Vec2 way_to_exhibit(const interface::Goal& goal) noexcept {
  const double towards = direction_of_exhibit(goal);
  return {std::cos(towards), std::sin(towards)};
}

bool is_on_the_right(const interface::Goal& goal, Vec2 guide) noexcept {
  return cross(way_to_exhibit(goal), guide - goal.standing.position) < -0.2;
}

/// Half way between what is shown and the visitor, by way of where one stands to look.
double half_turned(double shows, double visitor, double inwards) noexcept {
  constexpr double either_way = 1.2;
  double half = wrapped(visitor - shows) / 2;
  if (std::abs(half) > either_way) half = std::copysign(half, wrapped(inwards - shows));
  return wrapped(shows + std::clamp(half, -most_half, most_half));
}

}  // namespace

double arrival_yaw(const interface::Goal& goal, Vec2 guide) noexcept {
  const double turn = is_on_the_right(goal, guide) ? -scene::arrival_turn : scene::arrival_turn;
  return direction_of_exhibit(goal) + turn;
}

Vec2 about_aside(const interface::Goal& goal, Vec2 guide) noexcept {
  const Vec2 on = way_to_exhibit(goal);
  const double across = is_on_the_right(goal, guide) ? -sidewards[1] : sidewards[1];
  return goal.standing.position + onwards[1] * on + across * left_of(on);
}

std::optional<Placement> place_aside(const path::FloorMap& map, const interface::Goal& goal,
                                     const ExhibitShape& shape, const Placement& body,
                                     std::optional<double> yaw, double radius,
                                     std::optional<Side> side) noexcept {
  const Vec2 stands = goal.standing.position;
  const Vec2 on = way_to_exhibit(goal);
  std::optional<Placement> best;
  double least = 1e9;
  for (const Side beside : both_sides)
    for (const double across : sidewards)
      for (const double along : onwards) {
        const Vec2 at =
            stands + along * on + static_cast<double>(sign_of(beside)) * across * left_of(on);
        if (!map.has_room(at, radius + room) || distance_to(shape, at) < radius + gap ||
            !map.walls().capsule_clear(body.position, at, radius))
          continue;
        const Vec2 walk = at - body.position;
        const double heading = glm::length(walk) > 0.1 ? direction_of(walk) : body.heading;
        const double faces = half_turned(direction_of(to_floor(shape.middle) - at),
                                         yaw.value_or(arrival_yaw(goal, at)) + std::numbers::pi,
                                         direction_of(stands - at));
        const double cost = glm::length(walk) + 0.6 * std::abs(wrapped(heading - body.heading)) +
                            0.4 * std::abs(wrapped(faces - heading)) +
                            0.5 * std::abs(across - 0.8) +
                            (side.value_or(beside) == beside ? 0 : other_side);
        if (cost >= least) continue;
        least = cost;
        best = Placement{at, faces};
      }
  return best;
}

}  // namespace docent::guide
