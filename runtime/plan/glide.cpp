#include <algorithm>
#include <cmath>
#include <numbers>

#include "runtime/plan/plan.h"

namespace docent::plan {
namespace {

constexpr double glide_speed = 1.3;   ///< Metres a second, a comfortable walk.
constexpr double turn_speed = 2.1;    ///< Radians a second.
constexpr double acceleration = 1.3;  ///< Metres a second squared.

double turn_between(double from, double to) noexcept {
  return std::remainder(to - from, 2 * std::numbers::pi);
}

void add_frame(motion::Walk& walk, const Placement& body, double along, motion::Gait gait) {
  walk.root.push_back(to_world(body.position, 0.95));
  walk.plants.push_back({true, true});
  walk.body.push_back(body);
  walk.along.push_back(static_cast<float>(along));
  walk.gait.push_back(gait);
  walk.source.push_back({});
}

void turn(motion::Walk& walk, Placement& body, double heading, double along) {
  const double angle = turn_between(body.heading, heading);
  const double from = body.heading;
  const int frames = static_cast<int>(std::ceil(std::abs(angle) / turn_speed * glide_rate));
  for (int i = 1; i <= frames; ++i) {
    body.heading = from + angle * i / frames;
    add_frame(walk, body, along, motion::Gait::Turn);
  }
}

}  // namespace

motion::Walk glide(const Placement& start, std::span<const Vec2> path,
                   std::optional<double> final_heading) {
  motion::Walk walk;
  walk.frame_rate = glide_rate;
  Placement body = start;
  add_frame(walk, body, 0, motion::Gait::Idle);

  double length = 0;
  for (std::size_t i = 1; i < path.size(); ++i) length += glm::length(path[i] - path[i - 1]);
  double along = 0, speed = 0, passed = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Vec2 step = path[i] - path[i - 1];
    const double piece = glm::length(step);
    if (piece < 1e-9) continue;
    const double heading = std::atan2(step.y, step.x);
    // A sharp corner is turned on the spot; an arc's small corners are turned while moving.
    if (std::abs(turn_between(body.heading, heading)) > 0.5) {
      turn(walk, body, heading, along);
      speed = 0;
    }
    while (along < passed + piece) {
      const double braking = std::sqrt(2 * acceleration * std::max(length - along, 1e-4));
      speed = std::min({speed + acceleration / glide_rate, glide_speed, braking});
      along = std::min(along + speed / glide_rate, passed + piece);
      body.position = path[i - 1] + step * ((along - passed) / piece);
      body.heading += 0.2 * turn_between(body.heading, heading);
      add_frame(walk, body, along, motion::Gait::Walk);
    }
    passed += piece;
  }
  if (final_heading) turn(walk, body, *final_heading, along);
  add_frame(walk, body, along, motion::Gait::Idle);
  return walk;
}

}  // namespace docent::plan
