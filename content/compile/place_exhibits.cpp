#include "content/compile/place_exhibits.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "runtime/model/geometry/segment.h"
#include "runtime/path/floor_map.h"

namespace docent::compile {

namespace {

constexpr double nearest_view = 0.8, best_view = 1.4, farthest_view = 2.0;
constexpr double margin = 0.05;              // kept beyond the body's radius
constexpr double deepest_case = 5.0;         // metres from an object to the front of its case
constexpr double deepest_wall_mount = 0.15;  // a position may lie a little inside its wall
constexpr double past_edge = 0.03;           // what is free of a footprint is free beside it
constexpr double step = 0.05;

Vec2 direction_of(double heading) {
  return {std::cos(heading), std::sin(heading)};
}

/// How far the free floor is from the object in a direction: to the edge of the floor that it
/// takes, to the front of its case, or just off its wall. Empty where it looks into a wall.
std::optional<double> distance_to_floor(const PlacingFloor& floor, const WantedPlace& wanted,
                                        Vec2 direction) {
  const double begin = wanted.takes ? floor::distance_to_edge(*wanted.takes, direction) : 0;
  const double limit = begin + (wanted.place == ExhibitPlace::InCase ? deepest_case
                                : wanted.takes                       ? past_edge
                                                                     : deepest_wall_mount);
  for (double t = begin; t <= limit; t += 0.01)
    if (const Vec2 p = wanted.position + t * direction;
        path::is_inside(floor.map, p) && path::clearance_at(floor.map, p) > 1e-3)
      return t;
  return {};
}

/// A point from which a visitor might look.
struct Candidate {
  Vec2 position{};
  double cost = 0;  ///< Metres and the like away from the ideal: straight in front, 1.4 m away.
};

/// All points from which the object can be seen with room to stand, the best first.
std::vector<Candidate> viewing_candidates(const PlacingFloor& floor, const WantedPlace& wanted) {
  std::vector<Candidate> candidates;
  constexpr int most_turns = 12;  // of 5 degrees to either side
  for (int turn = -most_turns; turn <= most_turns; ++turn) {
    const double angle = turn * std::numbers::pi / 36;
    const Vec2 direction = direction_of(wanted.heading + angle);
    const auto front = distance_to_floor(floor, wanted, direction);
    if (!front) continue;
    const Vec2 seen = wanted.position + (*front + 0.005) * direction;
    const double first = std::max(nearest_view, *front + floor.body_radius + margin);
    const double last = std::max(farthest_view, first + farthest_view - nearest_view);
    const double best = std::max(best_view, first + best_view - nearest_view);
    for (double t = first; t <= last + 1e-9; t += step) {
      const Vec2 p = wanted.position + t * direction;
      if (!path::is_inside(floor.map, p))
        break;  // beyond a wall nothing is in front of it any more
      if (path::clearance_at(floor.map, p) < floor.body_radius + margin) continue;
      if (!path::can_see(floor.map, p, seen)) break;
      candidates.push_back({p, std::abs(t - best) + 1.5 * std::abs(angle)});
    }
  }
  std::ranges::stable_sort(candidates, {}, &Candidate::cost);
  return candidates;
}

bool is_reachable(const PlacingFloor& floor, Vec2 point) {
  return !floor.entrance || can_walk(floor.map, *floor.entrance, point, floor.body_radius);
}

PlaceProblem outside(const PlacingFloor& floor, Vec2 position) {
  PlaceProblem problem{.kind = PlaceProblem::Kind::Outside,
                       .label = fmt::format("{:.2f} m outside the floor of '{}'",
                                            path::clearance_at(floor.map, position), floor.name),
                       .hint = {}};
  if (const auto free = nearest_free_point(floor.map, position, 0))
    problem.hint = fmt::format("the nearest free point is {}", point_text(*free));
  return problem;
}

PlaceProblem unreachable(const PlacingFloor& floor, Vec2 view) {
  return {.kind = PlaceProblem::Kind::Unreachable,
          .label = "no visitor can get here",
          .hint = fmt::format("every way from the kiosk to {} is narrower than {:.2f} m",
                              point_text(view), 2 * floor.body_radius)};
}

Placement looking_at(Vec2 object, Vec2 view, double object_heading) {
  const Vec2 to_object = object - view;
  const bool apart = dot(to_object, to_object) > 1e-12;
  return {view, apart ? std::atan2(to_object.y, to_object.x) : object_heading + std::numbers::pi};
}

void take_given_view(const PlacingFloor& floor, const WantedPlace& wanted, PlacedExhibit& placed) {
  const Vec2 view = *wanted.view;
  placed.view = looking_at(wanted.position, view, wanted.heading);
  placed.problem = why_nobody_stands(floor.map, view, floor.body_radius);
  if (!placed.problem && !is_reachable(floor, view)) placed.problem = unreachable(floor, view);
}

void find_view(const PlacingFloor& floor, const WantedPlace& wanted, PlacedExhibit& placed) {
  const std::vector<Candidate> candidates = viewing_candidates(floor, wanted);
  const auto reached = std::ranges::find_if(
      candidates, [&](const Candidate& c) { return is_reachable(floor, c.position); });
  const auto chosen = reached != candidates.end() ? reached : candidates.begin();
  if (chosen != candidates.end())
    placed.view = looking_at(wanted.position, chosen->position, wanted.heading);
  if (reached != candidates.end()) return;
  if (!candidates.empty())
    placed.problem = unreachable(floor, placed.view.position);
  else
    placed.problem = {.kind = PlaceProblem::Kind::NoView,
                      .label = "nobody can stand in front of it",
                      .hint = fmt::format("turn 'facing' towards free floor, or give 'view': there "
                                          "is no room {:.1f} to {:.1f} m in front of it",
                                          nearest_view, farthest_view)};
}

Vec2 to_centimetres(Vec2 p) {
  return {std::round(p.x * 100) / 100, std::round(p.y * 100) / 100};
}

Vec2 inward_normal(const FloorPlan& plan, std::uint32_t wall) {
  return glm::normalize(left_of(wall_end(plan, wall) - wall_start(plan, wall)));
}

/// Tries the places nearest to `point` that are just clear of a wall, of a wall and the next one,
/// or of the corner between them.
void consider_beside_walls(const FloorPlan& plan, Vec2 point, double clearance,
                           const auto& consider) {
  for (std::uint32_t wall = 0; wall < plan.vertex.size(); ++wall) {
    const Vec2 a = wall_start(plan, wall);
    const Vec2 corner = wall_end(plan, wall);
    const double share = nearest_on_segment(point, a, corner).t;
    const Vec2 normal = inward_normal(plan, wall);
    consider(glm::mix(a, corner, share) + clearance * normal);
    const Vec2 next_normal = inward_normal(plan, plan.next[wall]);
    // x with x . normal = x . next_normal = clearance, unless the walls fold back on each other.
    const double fold = 1 + dot(normal, next_normal);
    if (fold > 0.01) consider(corner + clearance / fold * (normal + next_normal));
    if (const double distance = glm::distance(point, corner); distance > 0)
      consider(corner + clearance / distance * (point - corner));
  }
}

}  // namespace

std::string point_text(Vec2 point) {
  return fmt::format("[{:.2f}, {:.2f}]", point.x, point.y);
}

std::optional<PlaceProblem> why_nobody_stands(const path::FloorMap& map, Vec2 point,
                                              double body_radius) {
  const double clearance = path::clearance_at(map, point);
  const bool inside = path::is_inside(map, point);
  if (inside && clearance >= body_radius) return {};
  PlaceProblem problem{
      .kind = PlaceProblem::Kind::ViewBlocked,
      .label = fmt::format("{:.2f} m {}", clearance, inside ? "from a wall" : "outside the floor"),
      .hint = {}};
  if (const auto free = nearest_free_point(map, point, body_radius + margin))
    problem.hint =
        fmt::format("the nearest point with room for a visitor is {}", point_text(*free));
  return problem;
}

bool can_walk(const path::FloorMap& map, Vec2 from, Vec2 to, double body_radius) {
  const path::RouteQuery query{
      .kind = RouteKind::Shortest, .from = from, .to = to, .radius = body_radius};
  return path::route(map, query).status == path::RouteStatus::Ok;
}

std::optional<Vec2> nearest_free_point(const path::FloorMap& map, Vec2 point, double clearance) {
  std::optional<Vec2> nearest;
  const auto consider = [&](Vec2 candidate) {
    const Vec2 p = to_centimetres(candidate);
    if (nearest && glm::distance(p, point) >= glm::distance(*nearest, point)) return;
    if (path::is_inside(map, p) && path::clearance_at(map, p) >= clearance) nearest = p;
  };
  consider(point);
  consider_beside_walls(map.plan(), point, clearance, consider);
  consider_beside_walls(map.plan(), point, clearance + 0.01, consider);  // room for rounding
  // Narrow places are bounded by walls that do not meet: circles about the point find those.
  constexpr int directions = 72;
  constexpr double farthest = 20;
  for (double radius = 0; radius <= (nearest ? glm::distance(*nearest, point) : farthest);
       radius += 0.02 + radius / 100)
    for (int i = 0; i < directions; ++i)
      consider(point + radius * direction_of(i * 2 * std::numbers::pi / directions));
  return nearest;
}

PlacedExhibit place_exhibit(const PlacingFloor& floor, const WantedPlace& wanted) {
  PlacedExhibit placed;
  if (!wanted.place) {
    placed.problem = outside(floor, wanted.position);
    return placed;
  }
  placed.place = *wanted.place;
  if (wanted.view)
    take_given_view(floor, wanted, placed);
  else
    find_view(floor, wanted, placed);
  return placed;
}

}  // namespace docent::compile
