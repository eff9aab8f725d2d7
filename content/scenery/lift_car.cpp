#include "content/scenery/lift_car.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "content/scenery/furniture.h"
#include "runtime/model/geometry/polygon.h"

namespace docent::scenery {
namespace {

// Metres.
constexpr double farthest_wall = 1.2;
constexpr double half_door = 0.55;
constexpr double half_car = 0.8;
constexpr double jamb = 0.42;
constexpr double car_depth = 1.2;
constexpr double leaf = 0.2;  // of each leaf, that is seen
constexpr double leaf_thickness = 0.06;
constexpr double room_round_car = 0.05;

/// The wall that somebody looks at: `at` on it, and the way along and through it.
struct SeenWall {
  std::uint32_t wall = 0;
  Vec2 at{}, along{}, through{};
};

/// The nearest wall that is straight ahead and as wide as the door needs.
std::optional<SeenWall> wall_before(const Placement& stop, const FloorPlan& plan) {
  const Vec2 ahead{std::cos(stop.heading), std::sin(stop.heading)};
  std::optional<SeenWall> seen;
  double nearest = farthest_wall;
  for (std::uint32_t w = 0; w < plan.next.size(); ++w) {
    const Vec2 a = wall_start(plan, w);
    const Vec2 side = wall_end(plan, w) - a;
    const double length = std::hypot(side.x, side.y);
    const Vec2 through = -left_of(side / length);
    if (dot(through, ahead) < 0.95) continue;  // askew, or seen from behind
    const double distance = dot(a - stop.position, through);
    const double reach = dot(stop.position - a, side / length);
    if (distance < 0 || distance > nearest || reach < half_door || reach > length - half_door)
      continue;
    nearest = distance;
    seen = SeenWall{w, stop.position + through * distance, side / length, through};
  }
  return seen;
}

/// Does a segment meet the box [-x, x] by [low, high]?
bool meets_box(Vec2 a, Vec2 b, double x, double low, double high) {
  double from = 0;
  double to = 1;
  const Vec2 way = b - a;
  const auto clip = [&](double start, double step, double least, double most) {
    if (std::abs(step) < 1e-12) return start >= least && start <= most;
    const double first = (least - start) / step;
    const double last = (most - start) / step;
    from = std::max(from, std::min(first, last));
    to = std::min(to, std::max(first, last));
    return from <= to;
  };
  return clip(a.x, way.x, -x, x) && clip(a.y, way.y, low, high);
}

bool is_free_behind(const SeenWall& seen, const FloorPlan& plan) {
  const auto local = [&](Vec2 p) {
    return Vec2{dot(p - seen.at, seen.along), dot(p - seen.at, seen.through)};
  };
  for (std::uint32_t w = 0; w < plan.next.size(); ++w)
    if (w != seen.wall &&
        meets_box(local(wall_start(plan, w)), local(wall_end(plan, w)), half_car + room_round_car,
                  room_round_car, jamb + car_depth + room_round_car))
      return false;
  bool inside = false;
  const Vec2 middle = seen.at + seen.through * (jamb + car_depth / 2);
  for (const Ring& ring : plan.ring)
    inside ^= contains(std::span(plan.vertex).subspan(ring.first, ring.count), middle);
  return !inside;
}

void insert_after(std::uint32_t vertex, std::span<const Vec2> points, FloorPlan& plan) {
  plan.vertex.insert(plan.vertex.begin() + vertex + 1, points.begin(), points.end());
  const auto added = static_cast<std::uint32_t>(points.size());
  for (Ring& ring : plan.ring) {
    if (ring.first > vertex)
      ring.first += added;
    else if (vertex < ring.first + ring.count)
      ring.count += added;
  }
  plan.next.resize(plan.vertex.size());
  for (const Ring& ring : plan.ring)
    for (std::uint32_t i = 0; i < ring.count; ++i)
      plan.next[ring.first + i] = ring.first + (i + 1) % ring.count;
}

}  // namespace

std::vector<Outline> add_lift_car(const Placement& stop, FloorPlan& plan) {
  const std::optional<SeenWall> seen = wall_before(stop, plan);
  if (!seen || !is_free_behind(*seen, plan)) return {};
  const auto at = [&](double x, double y) {
    return seen->at + seen->along * x + seen->through * y;
  };
  const std::array alcove{at(-half_door, 0),
                          at(-half_door, jamb),
                          at(-half_car, jamb),
                          at(-half_car, jamb + car_depth),
                          at(half_car, jamb + car_depth),
                          at(half_car, jamb),
                          at(half_door, jamb),
                          at(half_door, 0)};
  insert_after(seen->wall, alcove, plan);
  std::vector<Outline> leaves;
  const double low = (jamb - leaf_thickness) / 2;
  const double high = (jamb + leaf_thickness) / 2;
  for (const double edge : {-half_door, half_door - leaf}) {
    Outline outline{at(edge, low), at(edge + leaf, low), at(edge + leaf, high), at(edge, high)};
    if (signed_area(outline) < 0) std::ranges::reverse(outline);
    leaves.push_back(std::move(outline));
  }
  return leaves;
}

void build_lift_door(const std::vector<Outline>& leaves, MeshBuilder& mesh) {
  constexpr std::array rows{0.0, 0.3, 0.9, cut_height};
  mesh.use(Surface::Frame);
  for (const Outline& outline : leaves) {
    mesh.sides(outline, rows);
    mesh.lid(outline, cut_height);
  }
}

}  // namespace docent::scenery
