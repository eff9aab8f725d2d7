#include "runtime/path/shortest/free_arcs.h"
#include "runtime/model/geometry/segment.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace docent::path {
namespace {

/// Directions, as angles in (-pi, pi], in which the circle of `radius` about `centre` may come to
/// or leave the places nearer than `reach` to the wall a b: where it meets the two circles about
/// the wall's ends and the two lines beside it.
void add_crossings(Vec2 centre, double radius, Vec2 a, Vec2 b, double reach,
                   std::vector<Vec2>& directions) {
  for (const Vec2 end : {a, b}) {
    const Vec2 to = end - centre;
    const double distance = std::sqrt(dot(to, to));
    if (distance == 0 || distance > radius + reach || distance < std::abs(radius - reach)) continue;
    const double along =
        (radius * radius - reach * reach + distance * distance) / (2 * distance * radius);
    const double across = std::sqrt(std::max(0.0, 1 - along * along));
    const Vec2 unit = to / distance;
    for (const double side : {-1.0, 1.0})
      directions.push_back(along * unit + side * across * left_of(unit));
  }
  const Vec2 wall = b - a;
  const double length = std::sqrt(dot(wall, wall));
  if (length == 0) return;
  const Vec2 unit = wall / length;
  const double height = cross(unit, centre - a);  // of the circle's centre above the wall
  for (const double line : {-reach, reach}) {
    const double sine = (line - height) / radius;
    if (std::abs(sine) > 1) continue;
    const double cosine = std::sqrt(1 - sine * sine);
    for (const double side : {-1.0, 1.0})
      directions.push_back(side * cosine * unit + sine * left_of(unit));
  }
}

}  // namespace

std::vector<ArcInterval> free_arcs(const FloorPlan& plan, const WallGrid& walls,
                                   const ReflexCorner& corner, std::uint32_t before,
                                   double radius) {
  if (radius == 0) return {{0, corner.extent}};
  const double rolling = rolling_radius(radius, walls.slack());
  const double reach = least_clearance(radius) - walls.slack();
  std::vector<std::uint32_t> near = walls.walls_about(corner.position, 2 * radius - walls.radius());
  // A point that lies ahead of neither end of the arc lies ahead of no place on it, so the disc is
  // nowhere nearer to it than the corner is.
  const Vec2 end = corner.direction_at(corner.extent);
  const auto is_behind = [&](Vec2 point) {
    const Vec2 from_corner = point - corner.position;
    return dot(corner.begin, from_corner) <= 0 && dot(end, from_corner) <= 0;
  };
  std::erase_if(near, [&](std::uint32_t wall) {
    return wall == corner.vertex || wall == before ||
           (is_behind(wall_start(plan, wall)) && is_behind(wall_end(plan, wall)));
  });
  if (near.empty()) return {{0, corner.extent}};
  std::vector<double> cuts{0, corner.extent};
  std::vector<Vec2> directions;
  for (const std::uint32_t wall : near)
    add_crossings(corner.position, rolling, wall_start(plan, wall), wall_end(plan, wall), reach,
                  directions);
  for (const Vec2 direction : directions) {
    const double angle = corner.angle_of(direction);
    if (angle > 0 && angle < corner.extent) cuts.push_back(angle);
  }
  std::ranges::sort(cuts);

  std::vector<ArcInterval> free;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const Vec2 middle = corner.point_at((cuts[i] + cuts[i + 1]) / 2, rolling);
    const bool blocked = std::ranges::any_of(near, [&](std::uint32_t wall) {
      return nearest_on_segment(middle, wall_start(plan, wall), wall_end(plan, wall))
                 .distance_squared < reach * reach;
    });
    if (blocked) continue;
    if (!free.empty() && free.back().end == cuts[i])
      free.back().end = cuts[i + 1];
    else
      free.push_back({cuts[i], cuts[i + 1]});
  }
  return free;
}

void cut_arcs(const ReflexCorner& corner, double rolling, double reach, Vec2 a, Vec2 b,
              std::vector<ArcInterval>& free) {
  const double farthest = rolling + reach;
  if (nearest_on_segment(corner.position, a, b).distance_squared >= farthest * farthest) return;
  std::vector<Vec2> directions;
  add_crossings(corner.position, rolling, a, b, reach, directions);
  std::vector<double> cuts;
  for (const Vec2 direction : directions) cuts.push_back(corner.angle_of(direction));
  std::ranges::sort(cuts);
  std::vector<ArcInterval> left;
  const auto add = [&](double begin, double end) {
    const Vec2 middle = corner.point_at((begin + end) / 2, rolling);
    if (nearest_on_segment(middle, a, b).distance_squared < reach * reach) return;
    if (!left.empty() && left.back().end == begin)
      left.back().end = end;
    else
      left.push_back({begin, end});
  };
  for (const ArcInterval& arc : free) {
    double begin = arc.begin;
    for (const double cut : cuts)
      if (cut > begin && cut < arc.end) {
        add(begin, cut);
        begin = cut;
      }
    add(begin, arc.end);
  }
  free = std::move(left);
}

}  // namespace docent::path
