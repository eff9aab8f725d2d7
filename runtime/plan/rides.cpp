#include "runtime/plan/rides.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "runtime/motion/climb.h"
#include "runtime/plan/stretch.h"

namespace docent::plan {
namespace {

constexpr double least_flight = 0.6;  // metres from stop to stop on the plan that are walked
constexpr double least_pace = 0.35;   // share of the ordinary speed on stairs

/// Whoever comes out looks away from the connection.
Placement coming_out(const ConnectionStop& stop) noexcept {
  return {stop.placement.position,
          std::remainder(stop.placement.heading + std::numbers::pi, 2 * std::numbers::pi)};
}

bool is_walked(const Connection& connection, Vec2 from, Vec2 to) noexcept {
  const bool on_foot =
      connection.kind == ConnectionKind::Stairs || connection.kind == ConnectionKind::Ramp;
  return on_foot && glm::distance(from, to) > least_flight;
}

/// A plan that does nothing but stand as the walk before did at a frame, moved by `shift`.
Plan standing_as(const motion::Walk& walk, std::uint32_t frame, Vec2 shift) {
  Plan plan;
  const std::size_t f = std::min<std::size_t>(frame, walk.root.size() - 1);
  plan.walk.frame_rate = walk.frame_rate;
  plan.walk.joint_count = walk.joint_count;
  plan.walk.root = {walk.root[f] + Vec3(to_world(shift))};
  const auto joints = static_cast<std::ptrdiff_t>(walk.joint_count);
  const auto first = walk.rotation.begin() + joints * static_cast<std::ptrdiff_t>(f);
  plan.walk.rotation.assign(first, first + joints);
  plan.walk.plants = {walk.plants[f]};
  plan.walk.body = {{walk.body[f].position + shift, walk.body[f].heading}};
  plan.walk.along = {0};
  plan.walk.gait = {motion::Gait::Idle};
  plan.walk.source = {walk.source[f]};
  return plan;
}

}  // namespace

bool Rides::is_taken(const Ride& ride, std::uint32_t body) const noexcept {
  const auto [low, high] = std::minmax(ride.from, ride.to);
  return std::ranges::any_of(taken_, [&](const Taken& other) {
    return other.body != body && other.connection == ride.connection && other.low < high &&
           low < other.high;
  });
}

/// Up or down the stairs; or, where the body is carried, a turn to where it comes out. Carried
/// bodies have their place at the far stop from the beginning; how far they are is told by the
/// plan's share of time (guide/avatar.h).
motion::Walk Rides::walk_of(const WalkOrder& order, const Placement& from) const {
  const Connection& connection = museum_.connections[order.ride->connection];
  const Placement to = coming_out(connection.stops[order.ride->to]);
  const bool walks = is_walked(connection, from.position, to.position);
  const Vec2 shift = walks ? Vec2{} : to.position - from.position;
  WalkOrder own = order;
  Plan stand;
  if (order.previous != nullptr && !order.previous->walk.root.empty()) {
    stand = standing_as(order.previous->walk, order.previous_frame, shift);
    own.previous = &stand;
    own.previous_frame = 0;
  }
  const Placement start{from.position + shift, from.heading};
  if (walks && connection.kind == ConnectionKind::Stairs)
    if (std::optional<motion::Walk> stairs = take_stairs(own, start, to)) return std::move(*stairs);
  if (!walks) return walk_along(walking_, own, start, {}, to.heading);
  const double ordinary = walking_ != nullptr ? walking_->speed : 1.0;
  const double length = glm::distance(from.position, to.position);
  own.pace = std::clamp(length / (ordinary * std::max(order.ride->seconds, 1e-3)), least_pace, 1.0);
  const std::array path{from.position, to.position};
  return walk_along(walking_, own, start, path, to.heading);
}

/// Step by step, over the treads that are drawn of the flight.
std::optional<motion::Walk> Rides::take_stairs(const WalkOrder& order, const Placement& from,
                                               const Placement& to) const {
  if (walking_ == nullptr) return {};
  const Connection& connection = museum_.connections[order.ride->connection];
  const ConnectionStop& stop = connection.stops[order.ride->from];
  const FloorPlan& plan = museum_.floors[stop.floor].plan;
  const double rise =
      museum_.floors[connection.stops[order.ride->to].floor].plan.height - plan.height;
  if (rise == 0) return {};
  const Vec2 here = stop.placement.position, there = to.position;
  const std::optional<Hole> hole = hole_between(plan, here, there);
  motion::Ascent ascent{from.position, there, {}};
  ascent.treads = hole ? treads_within(hole->outline, from.position, there, rise)
                       : treads_between(from.position, there, rise);
  motion::WalkRequest request;
  request.start = from;
  request.final_heading = to.heading;
  if (order.previous != nullptr) {
    request.previous = &order.previous->walk;
    request.previous_frame = order.previous_frame;
  }
  Result<motion::Walk> walk = motion::climb(*walking_, ascent, request);
  if (!walk) return {};
  return std::move(*walk);
}

std::unique_ptr<Plan> Rides::plan(const WalkOrder& order, Traffic& from, Traffic& to) {
  auto plan = std::make_unique<Plan>();
  plan->order = order;
  plan->status = path::RouteStatus::Ok;
  const double now = seconds_of(order);
  const Ride& ride = *order.ride;
  std::erase_if(taken_,
                [&](const Taken& one) { return one.until <= now || one.body == order.avatar; });
  const Placement out = coming_out(museum_.connections[ride.connection].stops[ride.to]);
  plan->holds = is_taken(ride, order.avatar);
  if (!plan->holds) plan->holds = !to.keep_place(order, out.position, *plan);
  if (plan->holds) return plan;
  plan->walk = walk_of(order, takes_over_at(order));
  const bool walks =
      is_walked(museum_.connections[ride.connection], takes_over_at(order).position, out.position);
  if (!walks) plan->rests_until = ride.seconds;
  plan->end = out;
  if (order.previous != nullptr) plan->metres_after = order.previous->metres_after - ride.metres;
  plan->seconds_to_goal = plan->seconds();
  from.leave(order.avatar, now + leaving_seconds);
  const auto [low, high] = std::minmax(ride.from, ride.to);
  taken_.push_back({ride.connection, low, high, order.avatar, now + plan->seconds()});
  return plan;
}

}  // namespace docent::plan
