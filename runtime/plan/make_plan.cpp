#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "runtime/motion/path_track.h"
#include "runtime/plan/plan.h"

namespace docent {
namespace {

/// A way is flattened to a millimetre; the ribbon and the camera need no more than this.
constexpr double ribbon_tolerance = 0.002;
constexpr std::size_t most_ribbon_points = 2048;

constexpr double stretch = 8;          // metres of a long way that are walked before the next
constexpr double least_rest = 4;       // metres that are worth a stretch of their own
constexpr double least_stretch = 2;    // metres before another may take over
constexpr double blend_seconds = 0.3;  // in which a transition is surely over

double distance_to_segment(Vec2 p, Vec2 a, Vec2 b) noexcept {
  const Vec2 d = b - a;
  const double square = dot(d, d);
  const double t = square > 0 ? std::clamp(dot(p - a, d) / square, 0.0, 1.0) : 0;
  return glm::length(p - (a + d * t));
}

/// Douglas and Peucker 1973: marks which points of [first, last] to keep.
void mark_kept(std::span<const Vec2> points, std::size_t first, std::size_t last, double tolerance,
               std::vector<bool>& keep) {
  std::vector<std::pair<std::size_t, std::size_t>> open{{first, last}};
  while (!open.empty()) {
    const auto [a, b] = open.back();
    open.pop_back();
    double worst = tolerance;
    std::size_t at = a;
    for (std::size_t i = a + 1; i < b; ++i)
      if (const double off = distance_to_segment(points[i], points[a], points[b]); off > worst) {
        worst = off;
        at = i;
      }
    if (at == a) continue;
    keep[at] = true;
    open.emplace_back(a, at);
    open.emplace_back(at, b);
  }
}

std::vector<Vec2> simplified(std::span<const Vec2> points) {
  if (points.size() < 3) return {points.begin(), points.end()};
  std::vector<Vec2> kept;
  for (double tolerance = ribbon_tolerance;; tolerance *= 2) {
    std::vector<bool> keep(points.size(), false);
    keep.front() = keep.back() = true;
    mark_kept(points, 0, points.size() - 1, tolerance, keep);
    kept.clear();
    for (std::size_t i = 0; i < points.size(); ++i)
      if (keep[i]) kept.push_back(points[i]);
    if (kept.size() <= most_ribbon_points) return kept;
  }
}

Placement last_place(const Walk& walk, std::uint32_t frame, const Placement& otherwise) noexcept {
  if (walk.body.empty()) return otherwise;
  return walk.body[std::min<std::size_t>(frame, walk.body.size() - 1)];
}

/// What is left of a plan's way at one of its frames.
std::vector<Vec2> way_ahead(const Plan& plan, std::uint32_t frame) {
  if (plan.walk.along.empty() || plan.points.empty()) return {};
  const double along = plan.walk.along[std::min<std::size_t>(frame, plan.walk.along.size() - 1)];
  std::vector<Vec2> ahead{last_place(plan.walk, frame, {}).position};
  for (std::size_t i = 0; i < plan.points.size(); ++i)
    if (plan.reach[i] > along + 0.02) ahead.push_back(plan.points[i]);
  return ahead;
}

/// The way from where the guide is, with room for walking. Where that is too much, or a body in
/// mid-step stands nearer to a wall than its circle may, a thinner one goes.
Way find_way(const Museum& museum, const FloorMap& map, const WalkOrder& order, Vec2 from) {
  RouteQuery query{.kind = order.kind,
                   .from = from,
                   .to = order.goal->position,
                   .smooth = true,
                   .tell_clearance = false};
  Way way;
  constexpr double spare = Museum::walking_room;
  for (const double more : {spare, 0.0, -spare / 2, -2 * spare, -5 * spare}) {
    query.radius = std::max(0.0, museum.body_radius + more);
    way = route(map, query);
    if (way.status == RouteStatus::Ok) break;
    if (way.status != RouteStatus::StartBlocked && more <= 0) break;
  }
  return way;
}

Walk walk_along(const WalkGraph* walking, const WalkOrder& order, const Placement& from,
                std::span<const Vec2> points, std::optional<double> final_heading) {
  WalkRequest request;
  request.path = points;
  request.start = from;
  request.final_heading = final_heading;
  std::vector<Vec2> ahead;
  if (order.before != nullptr && order.before->walk.joint_count > 0) {
    ahead = way_ahead(*order.before, order.before_frame);
    request.before = &order.before->walk;
    request.before_frame = order.before_frame;
    request.old_path_ahead = ahead;
  }
  if (walking != nullptr)
    if (Result<Walk> walk = make_walk(*walking, request); walk && !walk->root.empty())
      return std::move(*walk);
  return glide(from, points, final_heading);
}

/// Where a walk that ends on its way is best taken over: soon after its last transition before the
/// one that leads to the stand, when every other that the clip offers is still ahead. None where
/// that is too near to the beginning.
std::optional<std::uint32_t> frame_to_go_on(const MotionGraph& motion, const Walk& walk) {
  const auto leads_to_stand = [&](std::size_t f) {
    return motion.clips[walk.source[f].clip].role == ClipRole::Stop;
  };
  const auto follows = [&](std::size_t f) {
    const ClipFrame now = walk.source[f], last = walk.source[f - 1];
    return now.clip == last.clip && now.frame >= last.frame && now.frame - last.frame < 8;
  };
  std::size_t end = walk.source.size();
  while (end > 0 && (leads_to_stand(end - 1) || walk.gait[end - 1] != Gait::Walk)) --end;
  const auto blended = static_cast<std::size_t>(blend_seconds * walk.frame_rate);
  while (end > 0) {
    std::size_t first = end - 1;
    while (first > 0 && follows(first)) --first;
    const std::size_t frame = first + blended;
    if (static_cast<double>(walk.along[first]) < least_stretch) return {};
    if (frame + blended < end) return static_cast<std::uint32_t>(frame);
    end = first;
  }
  return {};
}

/// Makes the walk along a plan's way: all of it, or the first stretch of a long one.
void walk_way(const MotionGraph& motion, const WalkGraph* walking, const Placement& from,
              std::span<const Vec2> points, Plan& plan) {
  const double length = polyline_length(points);
  if (walking != nullptr && plan.order.goal && length > stretch + least_rest) {
    const std::vector<Vec2> beginning = first_part(points, stretch);
    plan.walk = walk_along(walking, plan.order, from, beginning, {});
    if (const auto frame = frame_to_go_on(motion, plan.walk)) {
      plan.is_whole = false;
      plan.go_on_frame = *frame;
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
std::unique_ptr<Plan> go_on(const MotionGraph& motion, const WalkGraph* walking,
                            const WalkOrder& order) {
  const Plan& before = *order.before;
  auto plan = std::make_unique<Plan>();
  plan->order = order;
  plan->status = before.status;
  plan->length = before.length;
  plan->points = before.points;
  plan->reach = before.reach;
  const std::vector<Vec2> rest = way_ahead(before, order.before_frame);
  walk_way(motion, walking, last_place(before.walk, order.before_frame, order.start), rest, *plan);
  const auto done = static_cast<float>(std::max(0.0, plan->reach.back() - polyline_length(rest)));
  for (float& along : plan->walk.along) along += done;
  return plan;
}

}  // namespace

Vec2 point_along(const Plan& plan, double metres) noexcept {
  if (plan.points.empty()) return {};
  const auto after = std::ranges::upper_bound(plan.reach, metres);
  if (after == plan.reach.begin()) return plan.points.front();
  if (after == plan.reach.end()) return plan.points.back();
  const auto i = static_cast<std::size_t>(after - plan.reach.begin());
  const double t = (metres - plan.reach[i - 1]) / (plan.reach[i] - plan.reach[i - 1]);
  return glm::mix(plan.points[i - 1], plan.points[i], t);
}

std::unique_ptr<Plan> make_plan(const Museum& museum, const WalkGraph* walking, const FloorMap& map,
                                const WalkOrder& order) {
  if (order.goes_on && order.before != nullptr && !order.before->reach.empty())
    return go_on(museum.motion, walking, order);
  auto plan = std::make_unique<Plan>();
  plan->order = order;
  const Placement from = order.before != nullptr
                             ? last_place(order.before->walk, order.before_frame, order.start)
                             : order.start;
  std::vector<Vec2> points;
  if (order.goal) {
    Way way = find_way(museum, map, order, from.position);
    plan->status = way.status;
    if (way.status != RouteStatus::Ok) return plan;
    plan->length = way.length;
    points = std::move(way.points);
    if (points.size() < 2) points = {from.position, order.goal->position};
  }
  plan->status = RouteStatus::Ok;
  walk_way(museum.motion, walking, from, points, *plan);
  plan->points = simplified(points);
  for (std::size_t i = 0; i < plan->points.size(); ++i)
    plan->reach.push_back(
        i == 0 ? 0 : plan->reach.back() + glm::length(plan->points[i] - plan->points[i - 1]));
  return plan;
}

std::unique_ptr<Plan> make_standing(const Museum& museum, const Placement& place) {
  auto plan = std::make_unique<Plan>();
  plan->order.start = place;
  plan->status = RouteStatus::Ok;
  // A walk begins standing: its first frame is the pose.
  const std::array path{place.position,
                        place.position + Vec2{std::cos(place.heading), std::sin(place.heading)}};
  const Result<WalkGraph> walking = make_walk_graph(museum.motion);
  plan->walk = walk_along(walking ? &*walking : nullptr, plan->order, place, path, {});
  Walk& walk = plan->walk;
  walk.root.resize(1);
  walk.rotation.resize(walk.joint_count);
  walk.plants.resize(1);
  walk.body.assign(1, place);
  walk.along.assign(1, 0);
  walk.gait.assign(1, Gait::Idle);
  walk.source.resize(1);
  return plan;
}

}  // namespace docent
