#include "runtime/path/offset/offset_curve.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "runtime/path/index/wall_grid.h"
#include "tests/runtime/path/floors.h"

namespace docent::test::offset_curve_test {
namespace {

using std::numbers::pi;

path::OffsetCurve curve_at(const Floor& floor, double distance) {
  return path::offset_curve(path::MedialAxisMap(floor), distance);
}

TEST(OffsetCurve, RoundsTheCornersOfABoxAndKeepsThoseOfTheHall) {
  const Floor floor = floor_of(hall_with_a_box());

  const path::OffsetCurve curve = curve_at(floor, 1);

  EXPECT_EQ(curve.components, 1U);
  EXPECT_EQ(curve.holes, 1U);
  EXPECT_NEAR(curve.area, 10 * 6 - (4 + 4 * 2 + pi), 1e-9);
  EXPECT_NEAR(curve.perimeter, 2 * (10 + 6) + 4 * 2 + 2 * pi, 1e-9);
}

TEST(OffsetCurve, FallsApartWhereADoorIsTooNarrow) {
  const Floor floor = floor_of(two_rooms(1));

  EXPECT_EQ(curve_at(floor, 0.4).components, 1U);
  EXPECT_EQ(curve_at(floor, 0.6).components, 2U);
  EXPECT_EQ(curve_at(floor, 3).rings.size(), 0U);
}

TEST(OffsetCurve, IsTheWallsAtDistanceZero) {
  const Floor floor = floor_of(hall_with_a_box());

  const path::OffsetCurve curve = curve_at(floor, 0);

  EXPECT_NEAR(curve.area, 12 * 8 - 4, 1e-9);
  EXPECT_NEAR(curve.perimeter, 40 + 8, 1e-9);
}

RC_GTEST_PROP(OffsetCurve, LosesItsPerimeterInAreaAsTheDistanceGrows, ()) {
  const auto plan = random_hall();
  RC_PRE(plan.has_value());
  const Floor floor = floor_of(*plan);
  const path::MedialAxisMap map(floor);
  const double low = *rc::gen::inRange(1, 60) / 100.0, high = low + 0.5;

  // The coarea formula: the area between two distances is the integral of the lengths between.
  constexpr int steps = 400;
  double swept = 0;
  for (int i = 0; i < steps; ++i)
    swept += path::offset_curve(map, low + (i + 0.5) * (high - low) / steps).perimeter *
             (high - low) / steps;

  const double lost = path::offset_curve(map, low).area - path::offset_curve(map, high).area;
  RC_ASSERT(std::abs(swept - lost) < 2e-3 * (1 + lost));
}

/// How many rings there are of either sense, by Euler's formula on the Voronoi diagram: an oracle
/// that follows no curve.
struct RingCount {
  std::uint32_t components = 0, holes = 0;
  bool has_narrow_passage = false;  ///< A passage of just twice the distance, longer than a point.
};

RingCount count_by_euler(const Floor& floor, double distance) {
  const VoronoiDiagram& voronoi = floor.diagram;
  const double above = distance + path::touching, below = distance - path::touching;
  std::vector<std::uint32_t> part(voronoi.vertex.size());
  std::iota(part.begin(), part.end(), 0U);
  const auto part_of = [&](std::uint32_t v) {
    while (part[v] != v) v = part[v];
    return v;
  };
  const auto is_above = [&](std::uint32_t v) { return voronoi.clearance[v] > above; };
  const auto lowest_of = [&](std::uint32_t e) {
    const path::EdgeCurve curve(floor.plan, voronoi, voronoi.edge[e]);
    return curve.clearance_between(curve.begin(), curve.end());
  };
  RingCount count;
  for (std::uint32_t v = 0; v < part.size(); ++v) count.components += is_above(v) ? 1U : 0U;
  // What reaches the distance only, joined into pinches; and each edge that rises from one.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> arms;  // vertex in the pinch, vertex above
  std::vector<std::pair<std::uint32_t, std::uint32_t>> touching_edges;
  for (std::uint32_t e = 0; e < voronoi.edge.size(); ++e) {
    const auto [from, to] = std::pair(voronoi.edge[e].from, voronoi.edge[e].to);
    const double lowest = lowest_of(e);
    if (lowest < below) continue;
    if (is_above(from) && is_above(to)) {
      if (lowest <= above) {
        touching_edges.emplace_back(from, to);
      } else if (part_of(from) == part_of(to)) {
        ++count.holes;
      } else {
        part[part_of(from)] = part_of(to);
        --count.components;
      }
    } else if (is_above(from) || is_above(to)) {
      arms.emplace_back(is_above(from) ? to : from, is_above(from) ? from : to);
    } else {
      if (glm::distance(voronoi.vertex[from], voronoi.vertex[to]) > 1e-7)
        count.has_narrow_passage = true;
      part[part_of(from)] = part_of(to);
    }
  }
  // A part of the floor that meets itself in a pinch goes round a hole there.
  for (const auto& [a, b] : touching_edges) count.holes += part_of(a) == part_of(b) ? 1U : 0U;
  std::set<std::pair<std::uint32_t, std::uint32_t>> met;
  for (const auto& [pinch, vertex] : arms)
    if (!met.emplace(part_of(pinch), part_of(vertex)).second) ++count.holes;
  return count;
}

bool rings_are_areas(const path::OffsetCurve& curve) {
  return std::ranges::all_of(curve.rings, [](const path::OffsetRing& ring) {
    std::set<std::pair<double, double>> points;
    for (const Vec2 p : ring.points) points.emplace(p.x, p.y);
    return points.size() >= 3 && ring.area != 0 && ring.length > 0;
  });
}

/// Does a ring or a piece of one appear or vanish between two distances?
bool changes_between(const path::MedialAxisMap& map, double low, double high) {
  const auto is_between = [&](double clearance) { return clearance >= low && clearance <= high; };
  for (std::uint32_t e = 0; e < map.diagram().edge.size(); ++e)
    if (is_between(map.clearances(e).low) || is_between(map.clearances(e).high)) return true;
  return false;
}

/// Those obstacles that stand free in the hall and of each other, so that nothing is mended.
std::vector<Obstacle> standing_apart(const std::vector<Obstacle>& obstacles) {
  std::vector<Obstacle> kept;
  const auto reaches = [](const Obstacle& a, const Obstacle& b) {
    return std::hypot(std::get<0>(a) - std::get<0>(b), std::get<1>(a) - std::get<1>(b)) <=
           std::get<2>(a) + std::get<2>(b);
  };
  for (const Obstacle& obstacle : obstacles) {
    const auto [x, y, radius, corners, angle] = obstacle;
    if (x <= radius || y <= radius || x >= 1200 - radius || y >= 800 - radius) continue;
    if (std::ranges::none_of(kept, [&](const Obstacle& o) { return reaches(o, obstacle); }))
      kept.push_back(obstacle);
  }
  return kept;
}

/// A vertex on a wall of a plan, moved out of it.
Points with_bulge(const Points& ring, std::size_t wall, double along, double bulge) {
  const Vec2 a = ring[wall], b = ring[(wall + 1) % ring.size()];
  Points changed = ring;
  changed.insert(changed.begin() + static_cast<std::ptrdiff_t>(wall) + 1,
                 glm::mix(a, b, along) + bulge * glm::normalize(left_of(b - a)));
  return changed;
}

Points turned(Points ring, double angle) {
  for (Vec2& p : ring)
    p = {p.x * std::cos(angle) - p.y * std::sin(angle),
         p.x * std::sin(angle) + p.y * std::cos(angle)};
  return ring;
}

TEST(OffsetCurve, OfACaseWithAVertexThatHardlyJutsOutOfItsSideIsThatOfTheCase) {
  const Points hall = rectangle({0, 0}, {6, 4}), box = rectangle({2, 1.5}, {3, 2.5});
  const path::OffsetCurve straight = curve_at(floor_of(drawn(hall, {box})), 0.25);
  for (const double bulge : {1e-10, 1e-9, 3e-8, 1e-7, 3e-7, 1e-6})
    for (const double side : {1.0, -1.0})
      for (const double angle : {0.0, 0.3, 1.1}) {
        const Floor floor = floor_of(
            drawn(turned(hall, angle), {turned(with_bulge(box, 0, 0.5, side * bulge), angle)}));

        const path::OffsetCurve curve = curve_at(floor, 0.25);

        EXPECT_EQ(curve.components, 1U) << bulge << ' ' << side << ' ' << angle;
        EXPECT_EQ(curve.holes, 1U) << bulge << ' ' << side << ' ' << angle;
        EXPECT_TRUE(rings_are_areas(curve));
        EXPECT_NEAR(curve.area, straight.area, bulge + 1e-9);
        EXPECT_NEAR(curve.perimeter, straight.perimeter, 2 * bulge + 1e-9);
      }
}

TEST(OffsetCurve, TouchesItselfInADoorOfTwiceTheDistanceAndGoesRoundWhatItLeads) {
  // A screen reaches from the box to the wall of the hall, but for a door of half a metre.
  const Points hall{{0, 0}, {12, 0}, {12, 8}, {6, 8}, {6, 6.5}, {5.9, 8}, {0, 8}};
  const Points box{{5, 3}, {7, 3}, {7, 5}, {6, 6}, {5, 5}};
  for (const double angle : {0.0, 0.3, 0.7, 2.2}) {
    const Floor floor = floor_of(drawn(turned(hall, angle), {turned(box, angle)}));
    for (const double off : {-0.9e-9, 0.0, 0.9e-9})
      EXPECT_EQ(curve_at(floor, 0.25 + off).holes, 1U) << angle << ' ' << off;
    EXPECT_EQ(curve_at(floor, 0.25 - 1e-8).holes, 1U);
    EXPECT_EQ(curve_at(floor, 0.25 + 1e-8).holes, 0U);
    EXPECT_EQ(curve_at(floor, 0.25 + 1e-8).components, 1U);
    EXPECT_NEAR(curve_at(floor, 0.25).area, curve_at(floor, 0.25 - 1e-8).area, 1e-6);
  }
}

RC_GTEST_PROP(OffsetCurve, CaresForNoVertexThatHardlyLeavesItsWall, ()) {
  const double bulge = std::pow(10.0, -*rc::gen::inRange(50, 101) / 10.0);
  const double angle = *rc::gen::inRange(0, 6283) / 1000.0;
  std::vector<Points> straight_rings{rectangle({0, 0}, {12, 8})}, rings;
  for (const Obstacle& obstacle : standing_apart(*any_obstacles()))
    straight_rings.push_back(corners_of(obstacle));
  for (const Points& ring : straight_rings) {
    Points bulged = ring;
    // From the last wall to the first, so that the numbers of those to come do not change.
    for (std::size_t wall = ring.size(); wall-- > 0;)
      if (*rc::gen::inRange(0, 2) == 0)
        bulged = with_bulge(bulged, wall, *rc::gen::inRange(3, 98) / 100.0,
                            *rc::gen::element(-1.0, 1.0) * bulge);
    rings.push_back(turned(bulged, angle));
  }
  const auto hall_of = [](const std::vector<Points>& all) {
    return floor_of(drawn(all.front(), std::vector<Points>(all.begin() + 1, all.end())));
  };
  const Floor straight = hall_of(straight_rings), bulged = hall_of(rings);
  const path::MedialAxisMap map(bulged), straight_map(straight);
  for (int i = 0; i < 20; ++i) {
    const double distance = *rc::gen::inRange(1, 200) / 100.0;
    const path::OffsetCurve curve = path::offset_curve(map, distance);
    const RingCount rings_there = count_by_euler(bulged, distance);
    RC_ASSERT(rings_are_areas(curve));
    if (!rings_there.has_narrow_passage) {
      RC_ASSERT(curve.components == rings_there.components);
      RC_ASSERT(curve.holes == rings_there.holes);
    }
    // No wall has moved by more than a bulge. So the area lies between those a little nearer and a
    // little farther; and where nothing appears or vanishes between these, so do the rings.
    const double near = 2 * bulge + 1e-8;
    const path::OffsetCurve less = path::offset_curve(straight_map, distance - near);
    const path::OffsetCurve more = path::offset_curve(straight_map, distance + near);
    RC_ASSERT(curve.area <= less.area + 1e-9);
    RC_ASSERT(curve.area >= more.area - 1e-9);
    if (changes_between(straight_map, distance - near, distance + near)) continue;
    RC_ASSERT(curve.components == less.components);
    RC_ASSERT(curve.holes == less.holes);
    RC_ASSERT(std::abs(curve.perimeter - less.perimeter) <=
              std::abs(more.perimeter - less.perimeter) + 1e-6 + 1e3 * bulge);
  }
}

RC_GTEST_PROP(OffsetCurve, HasTheRingsThatEulersFormulaCountsWhereWallsVanishAndFloorsTouch, ()) {
  const auto plan = random_hall();
  RC_PRE(plan.has_value());
  const Floor floor = floor_of(*plan);
  const path::MedialAxisMap map(floor);
  const auto& voronoi = floor.diagram;
  for (int i = 0; i < 40; ++i) {
    // A place where something appears or vanishes, and distances about it.
    const auto e =
        *rc::gen::inRange<std::uint32_t>(0, static_cast<std::uint32_t>(voronoi.edge.size()));
    const auto& curve_of_edge = map.clearances(e);
    const double place = *rc::gen::element(curve_of_edge.low, curve_of_edge.high);
    const double off = *rc::gen::element(0.0, 1e-13, 5e-10, 1.5e-9, 3e-9, 1e-8, 1e-7, 1e-6);
    const double distance = place + *rc::gen::element(-1.0, 1.0) * off;
    if (!(distance > 1e-3)) continue;
    const RingCount expected = count_by_euler(floor, distance);
    if (expected.has_narrow_passage) continue;

    const path::OffsetCurve curve = path::offset_curve(map, distance);

    RC_ASSERT(curve.components == expected.components);
    RC_ASSERT(curve.holes == expected.holes);
    RC_ASSERT(rings_are_areas(curve));
  }
}

}  // namespace
}  // namespace docent::test::offset_curve_test
