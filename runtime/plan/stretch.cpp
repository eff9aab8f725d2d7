#include "runtime/plan/stretch.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "runtime/model/geometry/polyline.h"
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

/// The place near a point where a disc has room: straight away from the wall that is too near, and
/// again where that leads near another. None where that is far, or beyond a wall.
std::optional<Vec2> place_with_room(const path::FloorMap& map, Vec2 point, double radius) {
  constexpr double farthest = 0.1;  // metres; less than what keeps a body from any wall
  constexpr double margin = 1e-6;   // so that rounding does not decide
  Vec2 place = point;
  for (int pushes = 0; pushes < 8; ++pushes) {
    if (map.has_room(place, radius)) return place;
    const path::WallGrid::Nearest wall = map.walls().nearest_wall(place);
    const FloorPlan& plan = map.plan();
    const Vec2 touched =
        glm::mix(plan.vertex[wall.wall], plan.vertex[plan.next[wall.wall]], wall.t);
    if (wall.distance < farthest) return {};
    place = touched + (radius + margin) / wall.distance * (place - touched);
    if (glm::distance(place, point) > farthest) return {};
  }
  return {};
}

/// The way for a radius, though its ends are a little nearer to a wall: it begins and ends with a
/// short piece from there to where there is room, or goes straight on where that is as clear.
path::Way way_with_room(const path::FloorMap& map, path::RouteQuery query) {
  const auto from = place_with_room(map, query.from, query.radius);
  const auto to = place_with_room(map, query.to, query.radius);
  if (!from || !to) return {.status = path::RouteStatus::StartBlocked};
  const Vec2 begin = std::exchange(query.from, *from), end = std::exchange(query.to, *to);
  path::Way way = path::route(map, query);
  if (way.status != path::RouteStatus::Ok) return way;
  const auto is_clear = [&](Vec2 tight, Vec2 other) {
    return map.walls().capsule_clear(tight, other, map.clearance_at(tight));
  };
  if (begin != *from) {
    const bool is_direct = way.points.size() > 1 && is_clear(begin, way.points[1]);
    if (is_direct)
      way.points.front() = begin;
    else
      way.points.insert(way.points.begin(), begin);
  }
  if (end != *to) {
    const bool is_direct = way.points.size() > 1 && is_clear(end, *(way.points.end() - 2));
    if (is_direct)
      way.points.back() = end;
    else
      way.points.push_back(end);
  }
  if (begin != *from || end != *to) way.length = polyline_length(way.points);
  return way;
}

}  // namespace

Placement last_place(const motion::Walk& walk, std::uint32_t frame,
                     const Placement& otherwise) noexcept {
  if (walk.body.empty()) return otherwise;
  return walk.body[std::min<std::size_t>(frame, walk.body.size() - 1)];
}

Placement takes_over_at(const WalkOrder& order) noexcept {
  return order.previous != nullptr
             ? last_place(order.previous->walk, order.previous_frame, order.start)
             : order.start;
}

std::vector<Vec2> way_ahead(const Plan& plan, std::uint32_t frame) {
  if (plan.walk.along.empty() || plan.points.empty()) return {};
  const double along = plan.walk.along[std::min<std::size_t>(frame, plan.walk.along.size() - 1)];
  std::vector<Vec2> ahead{last_place(plan.walk, frame, {}).position};
  for (std::size_t i = 0; i < plan.points.size(); ++i)
    if (plan.reach[i] > along + 0.02) ahead.push_back(plan.points[i]);
  return ahead;
}

path::Way find_way(const Museum& museum, const path::FloorMap& map, RouteKind kind, Vec2 from,
                   Vec2 to) {
  path::RouteQuery query{
      .kind = kind, .from = from, .to = to, .smooth = true, .tell_clearance = false};
  constexpr double spare = Museum::walking_room;
  query.radius = museum.body_radius + spare;
  path::Way way = way_with_room(map, query);
  for (const double more : {0.0, -spare / 2, -2 * spare, -5 * spare}) {
    if (way.status == path::RouteStatus::Ok) break;
    query.radius = std::max(0.0, museum.body_radius + more);
    way = path::route(map, query);
    if (way.status != path::RouteStatus::StartBlocked) break;
  }
  return way;
}

motion::Walk walk_along(const motion::WalkGraph* walking, const WalkOrder& order,
                        const Placement& from, std::span<const Vec2> points,
                        std::optional<double> final_heading,
                        std::span<const motion::CarefulPlace> careful) {
  motion::WalkRequest request;
  request.path = points;
  request.start = from;
  request.final_heading = final_heading;
  request.pace = order.pace;
  request.careful = careful;
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
