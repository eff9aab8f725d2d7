#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "content/content_error.h"
#include "content/floor/medial_axis.h"
#include "content/floor/mend.h"
#include "content/floor/sight.h"
#include "content/floor/voronoi.h"
#include "runtime/model/geometry/polyline.h"
#include "runtime/model/geometry/segment.h"
#include "runtime/path/route.h"
#include "runtime/path/shortest/make_hub_labels.h"
#include "runtime/path/shortest/make_tangent_graph.h"
#include "tests/fuzz/awkward_hall.h"

using namespace docent;

namespace {

constexpr double exact = 1e-6;  ///< Metres: what the points of a way may be off.

/// Lengths that ought to be equal may differ by rounding alone.
double slack(double length) {
  return 1e-9 * (1 + length);
}

std::string written(const path::RouteQuery& query) {
  return fmt::format("{}{}{} way from [{}, {}] to [{}, {}], radius {}, offset {}, hand {}",
                     info_of(query.kind).name, query.widest ? " widest" : "",
                     query.smooth ? " smooth" : "", query.from.x, query.from.y, query.to.x,
                     query.to.y, query.radius, query.offset, static_cast<int>(query.hand));
}

[[noreturn]] void refute(const path::RouteQuery& query, const std::string& what) {
  fmt::print(stderr, "the {}: {}\n", written(query), what);
  std::abort();
}

/// A floor as the content compiler makes it, with the shortest ways of these radii.
Floor floor_of(const FloorPlan& plan, const std::vector<double>& radii) {
  Floor floor;
  floor.plan = plan;
  floor.diagram = floor::voronoi_diagram(plan);
  floor.sight = floor::make_sight_map(plan, floor.diagram);
  floor.roadmap = floor::medial_axis(plan, floor.diagram);
  for (const double radius : radii) {
    floor.tangent_graphs.push_back(path::make_tangent_graph(plan, floor.sight, radius));
    floor.hub_labels.push_back(path::make_hub_labels(plan, floor.tangent_graphs.back()));
  }
  return floor;
}

/// The same floor with the first of its radii alone.
Floor only_for_points(Floor floor) {
  floor.tangent_graphs.resize(1);
  floor.hub_labels.resize(1);
  return floor;
}

std::optional<FloorPlan> mended(const import::ImportedPlan& drawn) {
  try {
    std::vector<Diagnostic> mendings;
    return floor::mend(drawn, mendings);
  } catch (const content::ContentError&) {
    return std::nullopt;  // The obstacles filled the hall.
  }
}

/// Any point of the hall, or one close to a corner: there ways bend, and touch.
Vec2 point_of(test::Bytes& bytes, const FloorPlan& plan, double radius) {
  const unsigned where = bytes.byte();
  const Vec2 free{bytes.between(0, test::hall_size.x), bytes.between(0, test::hall_size.y)};
  if (where < 128) return free;
  const Vec2 corner = plan.vertex[(where - 128) % plan.vertex.size()];
  const double distance = radius + std::pow(10.0, -static_cast<double>(bytes.below(6)));
  return corner + distance * glm::normalize(free - test::hall_size / 2.0 + Vec2{1e-9, 0});
}

/// Does a segment cross a wall from one side to the other? Touching is not crossing.
bool crosses(Vec2 p, Vec2 q, Vec2 a, Vec2 b) {
  constexpr double clearly = 1e-7;  // metres
  const double along = glm::distance(p, q), wall = glm::distance(a, b);
  if (along < clearly || wall < clearly) return false;
  const auto apart = [](double one, double other) {
    return std::min(one, other) < -clearly && std::max(one, other) > clearly;
  };
  return apart(cross(q - p, a - p) / along, cross(q - p, b - p) / along) &&
         apart(cross(b - a, p - a) / wall, cross(b - a, q - a) / wall);
}

double distance_to_walls(const FloorPlan& plan, Vec2 point) {
  double nearest = HUGE_VAL;
  for (std::uint32_t wall = 0; wall < plan.next.size(); ++wall)
    nearest =
        std::min(nearest, distance_to_segment(point, wall_start(plan, wall), wall_end(plan, wall)));
  return nearest;
}

/// What is true of one way, whatever its kind.
void check_way(const FloorPlan& plan, const path::RouteQuery& query, const path::Way& way) {
  if (way.points.size() < 2 || way.points.front() != query.from || way.points.back() != query.to)
    refute(query, "does not go from where to where it was asked");
  if (way.clearance_min < query.radius - exact)
    refute(query, fmt::format("says that it comes {} m near to a wall", way.clearance_min));
  for (const Vec2 point : way.points)
    if (distance_to_walls(plan, point) < way.clearance_min - exact)
      refute(query,
             fmt::format("is {} m from a wall at [{}, {}], and promised {}",
                         distance_to_walls(plan, point), point.x, point.y, way.clearance_min));
  for (std::size_t i = 1; i < way.points.size(); ++i)
    for (std::uint32_t wall = 0; wall < plan.next.size(); ++wall)
      if (crosses(way.points[i - 1], way.points[i], wall_start(plan, wall), wall_end(plan, wall)))
        refute(query, fmt::format("crosses a wall after [{}, {}]", way.points[i - 1].x,
                                  way.points[i - 1].y));
  // A way of radius 0 has no arcs; else arcs are flattened to a millimetre.
  const bool is_flat = query.kind == RouteKind::Shortest && query.radius == 0;
  const double drawn = polyline_length(way.points);
  if (std::abs(drawn - way.length) > (is_flat ? slack(drawn) : 0.01 * drawn + 0.01))
    refute(query, fmt::format("says that it is {} m long, and its points {}", way.length, drawn));
}

path::RouteStatus turned(path::RouteStatus status) {
  if (status == path::RouteStatus::StartBlocked) return path::RouteStatus::GoalBlocked;
  if (status == path::RouteStatus::GoalBlocked) return path::RouteStatus::StartBlocked;
  return status;
}

/// A floor, asked with and without the shortest ways of one radius made beforehand.
struct Asked {
  Asked(const FloorPlan& plan, double radius)
      : named(floor_of(plan, {0, radius})),
        unnamed(only_for_points(named)),
        with(path::make_floor_map(named)),
        without(path::make_floor_map(unnamed)) {}

  [[nodiscard]] path::Way ask(const path::RouteQuery& query) const {
    path::Way way = path::route(*with, query);
    if (way.status == path::RouteStatus::Ok) check_way(named.plan, query, way);
    return way;
  }

  Floor named, unnamed;
  std::shared_ptr<const path::FloorMap> with, without;
};

/// There is as long as back, with the wall on the other hand. Where both ends are blocked, the one
/// that is asked for first is told.
void check_back(const Asked& floor, const path::RouteQuery& query, const path::Way& there) {
  path::RouteQuery asked = query;
  std::swap(asked.from, asked.to);
  if (query.hand == path::Hand::Left) asked.hand = path::Hand::Right;
  if (query.hand == path::Hand::Right) asked.hand = path::Hand::Left;
  const path::Way back = floor.ask(asked);
  const bool both_blocked = there.status == path::RouteStatus::StartBlocked &&
                            back.status == path::RouteStatus::StartBlocked;
  if (!both_blocked && turned(back.status) != there.status)
    refute(query, fmt::format("has status {}, and {} on the way back",
                              static_cast<int>(there.status), static_cast<int>(back.status)));
  if (there.status == path::RouteStatus::Ok &&
      std::abs(there.length - back.length) > slack(there.length))
    refute(query, fmt::format("is {} m long, and {} m back", there.length, back.length));
}

/// The ways of every kind that answer the same question.
std::vector<path::RouteQuery> questions(Vec2 from, Vec2 to, double radius, double distance,
                                        path::Hand hand) {
  const path::RouteQuery shortest{.from = from, .to = to, .radius = radius};
  path::RouteQuery skeleton = shortest;
  skeleton.kind = RouteKind::Skeleton;
  path::RouteQuery smooth = skeleton;
  smooth.smooth = true;
  path::RouteQuery widest = skeleton;
  widest.widest = true;
  path::RouteQuery offset = shortest;
  offset.kind = RouteKind::Offset;
  offset.offset = distance;
  offset.hand = hand;
  return {shortest, skeleton, widest, offset, smooth};
}

/// A radius that nobody named is answered in the same way.
void check_without_labels(const Asked& floor, const path::RouteQuery& query,
                          const path::Way& with) {
  const path::Way without = path::route(*floor.without, query);
  if (without.status != with.status)
    refute(query, fmt::format("has status {}, and {} without labels", static_cast<int>(with.status),
                              static_cast<int>(without.status)));
  if (with.status != path::RouteStatus::Ok) return;
  check_way(floor.unnamed.plan, query, without);
  if (std::abs(without.length - with.length) > slack(with.length))
    refute(query,
           fmt::format("is {} m long, and {} m without labels", with.length, without.length));
}

/// Asks for the shortest way first, then for the others. The shortest way's length; infinite where
/// there is none.
double check_all_kinds(const Asked& floor, const std::vector<path::RouteQuery>& asked) {
  const path::Way shortest = floor.ask(asked.front());
  check_back(floor, asked.front(), shortest);
  check_without_labels(floor, asked.front(), shortest);
  const bool found = shortest.status == path::RouteStatus::Ok;
  for (const path::RouteQuery& query : std::span(asked).subspan(1)) {
    const path::Way way = floor.ask(query);
    if (way.status != shortest.status)
      refute(query, fmt::format("has status {}, and the shortest {}", static_cast<int>(way.status),
                                static_cast<int>(shortest.status)));
    if (found && !query.smooth && way.length < shortest.length - slack(shortest.length))
      refute(query, fmt::format("is {} m long, shorter than the shortest of {} m", way.length,
                                shortest.length));
    if (!query.smooth) check_back(floor, query, way);
  }
  return found ? shortest.length : HUGE_VAL;
}

}  // namespace

/// Whatever stands in a hall, ways of every kind keep what they promise: their ends, their
/// distance to walls, their length; there is as long as back, none is shorter than the shortest,
/// and the shortest gains nothing by a detour.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  test::Bytes bytes({data, size});
  const double radius = 0.005 * bytes.byte() + 0.01;
  const double distance = 0.01 * (1 + bytes.below(200));
  const auto hand = static_cast<path::Hand>(bytes.below(3));
  const bool of_a_point = bytes.below(2) == 0;
  const std::optional<FloorPlan> plan = mended(test::AwkwardHall(bytes).draw());
  if (!plan || bytes.at_end()) return 0;
  const Asked floor(*plan, radius);
  const double asked_radius = of_a_point ? 0 : radius;
  const std::array<Vec2, 3> point{point_of(bytes, *plan, asked_radius),
                                  point_of(bytes, *plan, asked_radius),
                                  point_of(bytes, *plan, asked_radius)};
  std::array<double, 3> length{};  // Of the way from point i to the next.
  for (std::size_t i = 0; i < 3; ++i)
    length[i] = check_all_kinds(
        floor, questions(point[i], point[(i + 1) % 3], asked_radius, distance, hand));
  for (std::size_t i = 0; i < 3; ++i) {
    const double detour = length[(i + 1) % 3] + length[(i + 2) % 3];
    if (length[i] > detour + slack(detour))
      refute({.from = point[i], .to = point[(i + 1) % 3], .radius = asked_radius},
             fmt::format("is {} m long, and {} m by way of [{}, {}]", length[i], detour,
                         point[(i + 2) % 3].x, point[(i + 2) % 3].y));
  }
  return 0;
}
