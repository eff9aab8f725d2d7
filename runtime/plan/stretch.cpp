#include "runtime/plan/stretch.h"

#include <algorithm>
#include <cmath>

#include "runtime/model/geometry/segment.h"
#include "runtime/motion/path_track.h"

namespace docent::plan {
namespace {

/// A way is flattened to a millimetre; the ribbon and the camera need no more than this.
constexpr double ribbon_tolerance = 0.002;
constexpr std::size_t most_ribbon_points = 2048;

constexpr double least_stretch = 2;    // metres before another may take over
constexpr double blend_seconds = 0.3;  // in which a transition is surely over

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

}  // namespace

Placement last_place(const motion::Walk& walk, std::uint32_t frame,
                     const Placement& otherwise) noexcept {
  if (walk.body.empty()) return otherwise;
  return walk.body[std::min<std::size_t>(frame, walk.body.size() - 1)];
}

std::vector<Vec2> way_ahead(const Plan& plan, std::uint32_t frame) {
  if (plan.walk.along.empty() || plan.points.empty()) return {};
  const double along = plan.walk.along[std::min<std::size_t>(frame, plan.walk.along.size() - 1)];
  std::vector<Vec2> ahead{last_place(plan.walk, frame, {}).position};
  for (std::size_t i = 0; i < plan.points.size(); ++i)
    if (plan.reach[i] > along + 0.02) ahead.push_back(plan.points[i]);
  return ahead;
}

path::Way find_way(const Museum& museum, const path::FloorMap& map, const WalkOrder& order,
                   Vec2 from) {
  path::RouteQuery query{.kind = order.kind,
                         .from = from,
                         .to = order.goal->position,
                         .smooth = true,
                         .tell_clearance = false};
  path::Way way;
  constexpr double spare = Museum::walking_room;
  for (const double more : {spare, 0.0, -spare / 2, -2 * spare, -5 * spare}) {
    query.radius = std::max(0.0, museum.body_radius + more);
    way = path::route(map, query);
    if (way.status == path::RouteStatus::Ok) break;
    if (way.status != path::RouteStatus::StartBlocked && more <= 0) break;
  }
  return way;
}

motion::Walk walk_along(const motion::WalkGraph* walking, const WalkOrder& order,
                        const Placement& from, std::span<const Vec2> points,
                        std::optional<double> final_heading) {
  motion::WalkRequest request;
  request.path = points;
  request.start = from;
  request.final_heading = final_heading;
  request.pace = order.pace;
  std::vector<Vec2> ahead;
  if (order.previous != nullptr && order.previous->walk.joint_count > 0) {
    ahead = way_ahead(*order.previous, order.previous_frame);
    request.previous = &order.previous->walk;
    request.previous_frame = order.previous_frame;
    request.old_path_ahead = ahead;
  }
  if (walking != nullptr)
    if (Result<motion::Walk> walk = motion::make_walk(*walking, request);
        walk && !walk->root.empty())
      return std::move(*walk);
  return glide(from, points, final_heading);
}

std::optional<std::uint32_t> find_handover_frame(const MotionGraph& motion,
                                                 const motion::Walk& walk) {
  const auto leads_to_stand = [&](std::size_t f) {
    return motion.clips[walk.source[f].clip].role == ClipRole::Stop;
  };
  const auto follows = [&](std::size_t f) {
    const ClipFrame now = walk.source[f], last = walk.source[f - 1];
    return now.clip == last.clip && now.frame >= last.frame && now.frame - last.frame < 8;
  };
  std::size_t end = walk.source.size();
  while (end > 0 && (leads_to_stand(end - 1) || walk.gait[end - 1] != motion::Gait::Walk)) --end;
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

void keep_way(std::span<const Vec2> points, Plan& plan) {
  plan.points = simplified(points);
  plan.reach.clear();
  for (std::size_t i = 0; i < plan.points.size(); ++i)
    plan.reach.push_back(
        i == 0 ? 0 : plan.reach.back() + glm::length(plan.points[i] - plan.points[i - 1]));
}

}  // namespace docent::plan
