#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "runtime/model/geometry/polyline.h"
#include "runtime/motion/path_track.h"
#include "runtime/plan/plan.h"
#include "runtime/plan/stretch.h"

namespace docent::plan {
namespace {

/// Makes the walk along a plan's way: all of it, or the first stretch of a long one.
void walk_way(const MotionGraph& motion, const motion::WalkGraph* walking, const Placement& from,
              std::span<const Vec2> points, Plan& plan) {
  const double length = polyline_length(points);
  if (walking != nullptr && plan.order.goal && length > stretch_length + least_rest) {
    const std::vector<Vec2> beginning = first_part(points, stretch_length);
    plan.walk = walk_along(walking, plan.order, from, beginning, {});
    if (const auto frame = find_handover_frame(motion, plan.walk)) {
      plan.is_whole = false;
      plan.handover_frame = *frame;
      const double pace = plan.walk.frame_rate * static_cast<double>(plan.walk.along[*frame]) /
                          static_cast<double>(*frame);
      plan.seconds_to_goal = length / pace;
      return;
    }
  }
  std::optional<double> final_heading;
  if (plan.order.goal) final_heading = plan.order.goal->heading;
  plan.walk = walk_along(walking, plan.order, from, points, final_heading);
  plan.seconds_to_goal = plan.seconds();
}

/// The next stretch of the way of the plan before.
std::unique_ptr<Plan> go_on(const MotionGraph& motion, const motion::WalkGraph* walking,
                            const WalkOrder& order) {
  const Plan& before = *order.previous;
  auto plan = std::make_unique<Plan>();
  plan->order = order;
  plan->status = before.status;
  plan->length = before.length;
  plan->points = before.points;
  plan->reach = before.reach;
  const std::vector<Vec2> rest = way_ahead(before, order.previous_frame);
  walk_way(motion, walking, last_place(before.walk, order.previous_frame, order.start), rest,
           *plan);
  const auto done = static_cast<float>(std::max(0.0, plan->reach.back() - polyline_length(rest)));
  for (float& along : plan->walk.along) along += done;
  return plan;
}

}  // namespace

void Nearby::add(std::uint32_t other, double when) noexcept {
  std::size_t at = count;
  while (at > 0 && seconds[at - 1] > when) --at;
  if (at == most) return;
  count = std::min<std::uint32_t>(count + 1, most);
  for (std::size_t i = count - 1; i > at; --i) {
    agent[i] = agent[i - 1];
    seconds[i] = seconds[i - 1];
  }
  agent[at] = other;
  seconds[at] = static_cast<float>(when);
}

Vec2 point_along(const Plan& plan, double metres) noexcept {
  if (plan.points.empty()) return {};
  const auto after = std::ranges::upper_bound(plan.reach, metres);
  if (after == plan.reach.begin()) return plan.points.front();
  if (after == plan.reach.end()) return plan.points.back();
  const auto i = static_cast<std::size_t>(after - plan.reach.begin());
  const double t = (metres - plan.reach[i - 1]) / (plan.reach[i] - plan.reach[i - 1]);
  return glm::mix(plan.points[i - 1], plan.points[i], t);
}

std::unique_ptr<Plan> make_plan(const Museum& museum, const motion::WalkGraph* walking,
                                const path::FloorMap& map, const WalkOrder& order) {
  if (order.continues && order.previous != nullptr && !order.previous->reach.empty())
    return go_on(museum.motion, walking, order);
  auto plan = std::make_unique<Plan>();
  plan->order = order;
  const Placement from = order.previous != nullptr
                             ? last_place(order.previous->walk, order.previous_frame, order.start)
                             : order.start;
  std::vector<Vec2> points;
  if (order.goal) {
    path::Way way = find_way(museum, map, order, from.position);
    plan->status = way.status;
    if (way.status != path::RouteStatus::Ok) return plan;
    plan->length = way.length;
    points = std::move(way.points);
    if (points.size() < 2) points = {from.position, order.goal->position};
  }
  plan->status = path::RouteStatus::Ok;
  walk_way(museum.motion, walking, from, points, *plan);
  keep_way(points, *plan);
  plan->is_new_way = true;
  return plan;
}

std::unique_ptr<Plan> make_standing(const Museum& museum, const Placement& place) {
  const Result<motion::WalkGraph> walking = motion::make_walk_graph(museum.motion);
  return make_standing(walking ? &*walking : nullptr, place);
}

std::unique_ptr<Plan> make_standing(const motion::WalkGraph* walking, const Placement& place) {
  auto plan = std::make_unique<Plan>();
  plan->order.start = place;
  plan->status = path::RouteStatus::Ok;
  // A walk begins standing: its first frame is the pose.
  const std::array path{place.position,
                        place.position + Vec2{std::cos(place.heading), std::sin(place.heading)}};
  plan->walk = walk_along(walking, plan->order, place, path, {});
  motion::Walk& walk = plan->walk;
  walk.root.resize(1);
  walk.rotation.resize(walk.joint_count);
  walk.plants.resize(1);
  walk.body.assign(1, place);
  walk.along.assign(1, 0);
  walk.gait.assign(1, motion::Gait::Idle);
  walk.source.resize(1);
  return plan;
}

}  // namespace docent::plan
