#include "runtime/path/touching.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <ostream>
#include <vector>

#include "runtime/path/floor_map.h"
#include "tests/runtime/path/floors.h"

namespace docent::test::touching_test {
namespace {

using path::RouteQuery;
using path::RouteStatus;

/// A plan of two rooms, to the left and right of x = 4, with a passage of a width between them.
using Door = Points (*)(double width);

Points between_corners(double width) {
  return {{0, 0}, {3.9, 0}, {4, 2 - width / 2}, {4.1, 0}, {8, 0},
          {8, 4}, {4.1, 4}, {4, 2 + width / 2}, {3.9, 4}, {0, 4}};
}
Points between_slanting_corners(double width) {
  const Vec2 half = width / 2 * Vec2{0.6, 0.8};
  return {{0, 0}, {3.3, 0}, Vec2{4, 2} - half, {3.6, 0}, {8, 0},
          {8, 4}, {4.5, 4}, Vec2{4, 2} + half, {4.1, 4}, {0, 4}};
}
Points between_corner_and_wall(double width) {
  return {{0, 0}, {8, 0}, {8, 4}, {4.1, 4}, {4, width}, {3.9, 4}, {0, 4}};
}
Points between_parallel_walls(double width) {
  const double low = 2 - width / 2, high = 2 + width / 2;
  return {{0, 0}, {3, 0}, {3, low},  {5, low},  {5, 0}, {8, 0},
          {8, 4}, {5, 4}, {5, high}, {3, high}, {3, 4}, {0, 4}};
}
constexpr std::array<Door, 4> doors{between_corners, between_slanting_corners,
                                    between_corner_and_wall, between_parallel_walls};

Vec2 turned(Vec2 p, double angle) {
  return {p.x * std::cos(angle) - p.y * std::sin(angle),
          p.x * std::sin(angle) + p.y * std::cos(angle)};
}
import::ImportedPlan turned_plan(Points ring, double angle) {
  for (Vec2& p : ring) p = turned(p, angle);
  return drawn(ring);
}

/// The way of each kind: the shortest, along the axis, the widest, along walls and close to them.
std::array<path::Way, 5> ways_of(const path::FloorMap& map, Vec2 from, Vec2 to, double radius) {
  RouteQuery query{.from = from, .to = to, .radius = radius, .offset = 1};
  std::array<path::Way, 5> ways;
  ways[0] = route(map, query);
  query.kind = RouteKind::Skeleton;
  ways[1] = route(map, query);
  query.widest = true;
  ways[2] = route(map, query);
  query.kind = RouteKind::Offset;
  ways[3] = route(map, query);
  query.offset = radius;
  ways[4] = route(map, query);
  return ways;
}

using Statuses = std::array<RouteStatus, 5>;
Statuses statuses_of(const path::FloorMap& map, Vec2 from, Vec2 to, double radius) {
  const auto ways = ways_of(map, from, to, radius);
  Statuses statuses{};
  std::ranges::transform(ways, statuses.begin(), &path::Way::status);
  return statuses;
}
Statuses all(RouteStatus status) {
  Statuses statuses{};
  statuses.fill(status);
  return statuses;
}

TEST(Touching, LetsADiscThroughADoorThatIsNarrowerByUpToTwiceThatForEveryKindOfRoute) {
  for (const Door door : doors)
    for (const double angle : {0.0, 0.3, 1.9})
      for (const double radius : {0.25, 0.4, 1e-3})
        for (const double narrower :
             {-1e-8, 0.0, 0.5e-9, 1e-9, 1.5e-9, 1.9e-9, 2.1e-9, 3e-9, 1e-8, 1e-7}) {
          const import::ImportedPlan plan = turned_plan(door(2 * radius - narrower), angle);
          const Floor named = floor_of(plan, {0, radius}), unnamed = floor_of(plan);
          for (const Floor* floor : {&named, &unnamed}) {
            const path::FloorMap map(*floor);
            for (const auto& [from, to] :
                 {std::pair(Vec2{1, 2}, Vec2{7, 2}), std::pair(Vec2{1.5, 3.2}, Vec2{6, 0.7})}) {
              const RouteStatus expected = narrower < 2e-9 ? RouteStatus::Ok : RouteStatus::NoRoute;
              EXPECT_EQ(statuses_of(map, turned(from, angle), turned(to, angle), radius),
                        all(expected))
                  << "door " << std::ranges::find(doors, door) - doors.begin() << ", turned by "
                  << angle << ", radius " << radius << ", narrower by " << narrower
                  << (floor == &named ? ", named" : ", not named");
            }
          }
        }
}

TEST(Touching, IsNoWayForAPointThatHasAnyDoor) {
  for (const Door door : doors)
    for (const double angle : {0.0, 0.3, 1.9})
      for (const double width : {0.01, 0.0011}) {
        const Floor floor = floor_of(turned_plan(door(width), angle));
        const path::FloorMap map(floor);
        EXPECT_EQ(statuses_of(map, turned({1, 2}, angle), turned({7, 2.5}, angle), 0),
                  all(RouteStatus::Ok));
      }
}

TEST(Touching, BlocksAnEndForEveryKindOfRouteOrForNone) {
  for (const double angle : {0.0, 0.3, 1.9})
    for (const double radius : {0.0, 1e-3, 0.25})
      for (const double nearer : {-1e-9, 0.0, 1e-13, 0.5e-9, 0.9e-9, 1.1e-9, 2e-9, 1e-8}) {
        const import::ImportedPlan plan = turned_plan(between_parallel_walls(1), angle);
        const Floor named = floor_of(plan, {0, radius}), unnamed = floor_of(plan);
        for (const Floor* floor : {&named, &unnamed}) {
          const path::FloorMap map(*floor);
          const double away = radius - nearer;
          // Beside a wall, in a corner of the room, and beside a corner that juts out.
          for (const Vec2 end : {Vec2{1.7, away}, Vec2{away, away}, Vec2{3 - away, 0.4},
                                 Vec2{3, 1.5} + away * Vec2{-0.8, 0.6}})
            for (const Vec2 other : {Vec2{1, 2.2}, Vec2{7, 3}}) {
              // From behind, a corner is farther than the walls that meet there, or nearer.
              const bool is_free = map.has_room(turned(end, angle), radius);
              if (end == Vec2{1.7, away}) {
                EXPECT_EQ(is_free, nearer < 1e-9);
              }
              const auto message = [&] {
                return testing::Message()
                       << "turned by " << angle << ", radius " << radius << ", nearer by " << nearer
                       << ", at " << end.x << ' ' << end.y << " to " << other.x;
              };
              EXPECT_EQ(statuses_of(map, turned(end, angle), turned(other, angle), radius),
                        all(is_free ? RouteStatus::Ok : RouteStatus::StartBlocked))
                  << message();
              EXPECT_EQ(statuses_of(map, turned(other, angle), turned(end, angle), radius),
                        all(is_free ? RouteStatus::Ok : RouteStatus::GoalBlocked))
                  << message();
            }
        }
      }
}

/// The length of the shortest way of a point; infinite where there is none.
double length_of(const path::FloorMap& map, Vec2 from, Vec2 to) {
  const path::Way way = route(map, {.from = from, .to = to, .radius = 0});
  return way.status == RouteStatus::Ok ? way.length : HUGE_VAL;
}

/// An end at x = 0 lies behind the left wall by what that stands off. Found by the fuzz target
/// `route`: what lies beyond the floor was seen from there.
TEST(Touching, FromBehindIsAsShortAsFromJustInside) {
  for (const double off : {1.4e-17, 1e-13, 3e-10, 9e-10}) {
    const Points cut{{off, 0.7}, {0.4, 0.4}, {0.7, 0}, {12, 0}, {12, 8}, {0, 8}};
    const Points boxed{{off, 0}, {12, 0}, {12, 8}, {off, 8}, {off, 5}, {1, 5}, {1, 3}, {off, 3}};
    for (const bool is_named : {true, false}) {
      const auto floor_of_ring = [&](const Points& ring) {
        return is_named ? floor_of(drawn(ring))
                        : floor_of(drawn(ring), std::initializer_list<double>{});
      };
      const Floor corner = floor_of_ring(cut), box = floor_of_ring(boxed);
      const path::FloorMap at_corner(corner), at_box(box);
      const auto expect_way = [](const path::FloorMap& map, Vec2 from, Vec2 to, double length) {
        EXPECT_NEAR(length_of(map, from, to), length, 1e-8);
        EXPECT_NEAR(length_of(map, to, from), length, 1e-8);
      };
      expect_way(at_corner, {0, 3.9}, {6, 4}, std::hypot(6, 0.1));
      expect_way(at_corner, {0, 3.9}, {0, 7}, 3.1);
      expect_way(at_box, {0, 6}, {6, 6}, 6);
      expect_way(at_box, {0, 6}, {0, 2}, 2 + 2 * std::numbers::sqrt2);
      EXPECT_EQ(statuses_of(at_corner, {0, 3.9}, {0, 0}, 0), all(RouteStatus::GoalBlocked));
      EXPECT_EQ(statuses_of(at_corner, {0, 0}, {0, 3.9}, 0), all(RouteStatus::StartBlocked));
    }
  }
}

TEST(Touching, LeadsAlongTheWallsOfADoorOfTwiceTheDistanceAsOfANarrowerOne) {
  for (const Door door : doors)
    for (const double angle : {0.0, 0.3, 1.9})
      for (const double distance : {0.25, 0.4}) {
        const auto length_along_walls = [&](double wider) {
          const Floor floor = floor_of(turned_plan(door(2 * distance + wider), angle));
          const path::FloorMap map(floor);
          return route(map, {.kind = RouteKind::Offset,
                             .from = turned({1, 2.2}, angle),
                             .to = turned({7, 1.7}, angle),
                             .radius = 0,
                             .offset = distance})
              .length;
        };
        const double narrower = length_along_walls(-1e-7), wider = length_along_walls(1e-7);
        for (const double by : {-1e-8, -1e-9, 0.0, 0.5e-9, 1e-9, 1.9e-9, 2.1e-9, 3e-9, 1e-8})
          EXPECT_NEAR(length_along_walls(by), by < 2e-9 ? narrower : wider, 1e-4)
              << "door " << std::ranges::find(doors, door) - doors.begin() << ", turned by "
              << angle << ", distance " << distance << ", wider by " << by;
      }
}

/// Is each way one that fits, and none shorter than the shortest?
bool fit(const std::array<path::Way, 5>& ways, double radius) {
  return std::ranges::all_of(ways, [&](const path::Way& way) {
    return way.length >= ways[0].length - 1e-8 && way.length < 1e3 &&
           way.clearance_min >= path::least_clearance(radius) - path::rounding;
  });
}

RC_GTEST_PROP(Touching, IsOneForAllKindsInEveryNarrowPlace, ()) {
  const auto plan = random_hall();
  RC_PRE(plan.has_value());
  const Floor unnamed = floor_of(*plan);
  const auto& voronoi = unnamed.diagram;
  const path::FloorMap unnamed_map(unnamed);
  for (int i = 0; i < 8; ++i) {
    // A disc to which some place is too narrow, or not.
    const auto e =
        *rc::gen::inRange<std::uint32_t>(0, static_cast<std::uint32_t>(voronoi.edge.size()));
    const double narrower =
        *rc::gen::element(-1e-8, -1e-10, 0.0, 0.5e-9, 1e-9, 1.5e-9, 1.9e-9, 2.1e-9, 3e-9, 1e-8);
    const double radius = unnamed_map.medial_axis().clearances(e).low + narrower / 2;
    if (!(radius > 1e-3)) continue;
    const Floor named = floor_of(*plan, {0, radius});
    const path::FloorMap named_map(named);
    const auto any_place = [&] {
      if (*rc::gen::inRange(0, 2) == 0) return random_point();
      return voronoi.vertex[*rc::gen::inRange<std::size_t>(0, voronoi.vertex.size())];
    };
    for (int k = 0; k < 8; ++k) {
      const Vec2 from = any_place(), to = any_place();
      for (const path::FloorMap* map : {&unnamed_map, &named_map}) {
        const auto ways = ways_of(*map, from, to, radius);
        for (const path::Way& way : ways) RC_ASSERT(way.status == ways[1].status);
        RC_ASSERT(ways[1].status != RouteStatus::Ok || fit(ways, radius));
      }
      RC_ASSERT(statuses_of(named_map, from, to, radius) ==
                statuses_of(unnamed_map, from, to, radius));
    }
  }
}

}  // namespace
}  // namespace docent::test::touching_test
