#include "content/floor/medial_axis.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "content/content_error.h"
#include "content/floor/voronoi.h"
#include "runtime/model/geometry/bisector.h"
#include "tests/content/floor/plans.h"
#include "tests/content/floor/random_plan.h"
#include "tests/support/reference_data.h"

namespace docent::test::medial_axis_test {
namespace {

Roadmap roadmap_of(const FloorPlan& plan) {
  return floor::medial_axis(plan, floor::voronoi_diagram(plan));
}

double length_of(const Roadmap& roadmap) {
  return std::accumulate(roadmap.edges.begin(), roadmap.edges.end(), 0.0,
                         [](double sum, const RoadmapEdge& edge) { return sum + edge.length; });
}

std::ptrdiff_t count_dead_ends(const Roadmap& roadmap) {
  std::vector<int> degree(roadmap.position.size(), 0);
  for (const RoadmapEdge& edge : roadmap.edges) ++degree[edge.from], ++degree[edge.to];
  return std::ranges::count(degree, 1);
}

int count_parts(const Roadmap& roadmap) {
  std::vector<std::size_t> part(roadmap.position.size());
  std::iota(part.begin(), part.end(), std::size_t{0});
  const auto name = [&](std::size_t i) {
    while (part[i] != i) i = part[i];
    return i;
  };
  for (const RoadmapEdge& edge : roadmap.edges) part[name(edge.from)] = name(edge.to);
  int parts = 0;
  for (std::size_t i = 0; i < part.size(); ++i) parts += part[i] == i ? 1 : 0;
  return parts;
}

int count_rings(const FloorPlan& plan, bool counter_clockwise) {
  return static_cast<int>(std::ranges::count_if(plan.ring, [&](const Ring& ring) {
    const auto first = plan.vertex.begin() + ring.first;
    return (signed_area({first, first + ring.count}) > 0) == counter_clockwise;
  }));
}

/// A corridor of 20 by 2 m whose long walls wobble by a centimetre, as traced from a scan.
Points traced_corridor() {
  std::mt19937 random(7);
  const auto wobble = [&] { return 1e-6 * (static_cast<double>(random() % 20001) - 1e4); };
  Points points;
  for (int i = 0; i <= 200; ++i) points.push_back({0.1 * i, wobble()});
  for (int i = 200; i >= 0; --i) points.push_back({0.1 * i, 2 + wobble()});
  return points;
}

TEST(MedialAxis, OfACorridorRunsDownItsMiddleAndNotIntoItsCorners) {
  const Roadmap corridor = roadmap_of(mended(drawn(rectangle({0, 0}, {500, 0.6}))));
  ASSERT_EQ(corridor.edges.size(), 1U);
  EXPECT_NEAR(corridor.edges[0].length, 499.4, 1e-9);
  EXPECT_NEAR(corridor.edges[0].clearance, 0.3, 1e-12);
}

TEST(MedialAxis, OfASquareRoomIsItsCentre) {
  const Roadmap room = roadmap_of(mended(drawn(rectangle({0, 0}, {4, 4}))));
  EXPECT_TRUE(room.edges.empty());
  ASSERT_EQ(room.position.size(), 1U);
  EXPECT_EQ(room.position[0], Vec2(2, 2));
  EXPECT_DOUBLE_EQ(room.clearance[0], 2);
}

TEST(MedialAxis, SproutsNoBranchAtABumpThatNobodySees) {
  const auto hall = [](double bump) {
    return roadmap_of(mended(drawn({{0, 0}, {10, bump}, {20, 0}, {20, 12}, {0, 12}})));
  };
  const Roadmap plain = hall(0), reflex = hall(1e-6), convex = hall(-1e-6);
  for (const Roadmap& bumpy : {reflex, convex}) {
    EXPECT_EQ(count_dead_ends(bumpy), count_dead_ends(plain));
    EXPECT_NEAR(length_of(bumpy), length_of(plain), 1e-5);
  }
}

TEST(MedialAxis, LeavesOutTheTwigsOfATracedWall) {
  const FloorPlan corridor = mended(drawn(traced_corridor()));
  ASSERT_GT(corridor.vertex.size(), 300U);
  const Roadmap roadmap = roadmap_of(corridor);
  EXPECT_EQ(count_dead_ends(roadmap), 2);
  EXPECT_NEAR(length_of(roadmap), 18, 0.5);
}

TEST(MedialAxis, KeepsADeadEndThatAVisitorCouldWalkInto) {
  // A niche of 2 by 2 m off the middle of a hall.
  const Roadmap roadmap = roadmap_of(
      mended(drawn({{0, 0}, {20, 0}, {20, 6}, {11, 6}, {11, 8}, {9, 8}, {9, 6}, {0, 6}})));
  EXPECT_EQ(count_dead_ends(roadmap), 3);
}

TEST(MedialAxis, MeasuresParabolasAlongTheArc) {
  const FloorPlan room = mended(drawn({{0, 0}, {6, 0}, {6, 2}, {2, 2}, {2, 6}, {0, 6}}));
  const VoronoiDiagram diagram = floor::voronoi_diagram(room);
  int arcs = 0;
  for (const RoadmapEdge& edge : floor::medial_axis(room, diagram).edges) {
    const VoronoiEdge& curve = diagram.edge[edge.voronoi_edge];
    if (!curve.parabola) continue;
    const Parabola parabola = parabola_of(room, diagram, curve);
    const double from = parameter_at(parabola, diagram.vertex[curve.from]);
    const double to = parameter_at(parabola, diagram.vertex[curve.to]);
    double chords = 0;
    constexpr int pieces = 20000;
    for (int i = 0; i < pieces; ++i)
      chords += glm::distance(point_at(parabola, std::lerp(from, to, i / double(pieces))),
                              point_at(parabola, std::lerp(from, to, (i + 1) / double(pieces))));
    EXPECT_NEAR(edge.length, chords, 1e-8);
    ++arcs;
  }
  EXPECT_EQ(arcs, 2);
}

TEST(MedialAxis, FindsTheNarrowestPlaceBetweenTwoCorners) {
  // A doorway of 1 m in the middle of a hall: two thin walls, each with two reflex corners.
  const FloorPlan rooms = mended(drawn({{0, 0},
                                        {10, 0},
                                        {10, 4},
                                        {10.1, 4},
                                        {10.1, 0},
                                        {20, 0},
                                        {20, 9},
                                        {10.1, 9},
                                        {10.1, 5},
                                        {10, 5},
                                        {10, 9},
                                        {0, 9}}));
  double narrowest = 100;
  for (const RoadmapEdge& edge : roadmap_of(rooms).edges)
    narrowest = std::min(narrowest, edge.clearance);
  EXPECT_NEAR(narrowest, 0.5, 1e-12);
}

/// The medial axis can be shrunk from the floor without tearing, and pruning dead ends keeps that:
/// it has one part per part of the floor, and one way round per hole.
void expect_same_shape(const FloorPlan& plan) {
  const Roadmap roadmap = roadmap_of(plan);
  const int parts = count_parts(roadmap);
  EXPECT_EQ(parts, count_rings(plan, true));
  const auto cycles =
      static_cast<int>(roadmap.edges.size()) - static_cast<int>(roadmap.position.size()) + parts;
  EXPECT_EQ(cycles, count_rings(plan, false));
  for (const RoadmapEdge& edge : roadmap.edges) {
    EXPECT_NE(edge.from, edge.to);
    EXPECT_GT(edge.clearance, 0);
    EXPECT_LE(edge.clearance,
              std::min(roadmap.clearance[edge.from], roadmap.clearance[edge.to]) + 1e-12);
    EXPECT_GE(edge.length + 1e-9,
              glm::distance(roadmap.position[edge.from], roadmap.position[edge.to]));
  }
}

/// Does a wall come as near to a corner of another as rounding puts it (the mended plan holds
/// doubles)? No disc passes there, and whether the axis does is up to that rounding.
bool is_pinched(const FloorPlan& plan) {
  constexpr double touching = 1e-9;
  for (std::uint32_t wall = 0; wall < plan.vertex.size(); ++wall) {
    const Vec2 start = wall_start(plan, wall), along = wall_end(plan, wall) - start;
    for (std::uint32_t v = 0; v < plan.vertex.size(); ++v) {
      if (v == wall || v == plan.next[wall]) continue;
      const Vec2 to = plan.vertex[v] - start;
      const double at = std::clamp(glm::dot(to, along) / glm::dot(along, along), 0.0, 1.0);
      if (glm::distance(to, at * along) < touching) return true;
    }
  }
  return false;
}

RC_GTEST_PROP(MedialAxis, HasTheShapeOfAnyHall, ()) {
  FloorPlan plan;
  try {
    plan = mended(hall_with(*any_obstacles()));
  } catch (const content::ContentError&) {
    RC_DISCARD("the obstacles cover the hall");
  }
  RC_PRE(!is_pinched(plan));
  expect_same_shape(plan);
  RC_ASSERT(!testing::Test::HasFailure());
}

TEST(MedialAxis, HasTheShapeOfEveryReferencePlan) {
  NEEDS_REFERENCE_DATA("floorplans/reference/maps");
  for (const char* folder : {"floorplans/reference/maps", "floorplans/plans"})
    for (const auto& file : plan_files(folder)) {
      SCOPED_TRACE(file.filename().string());
      expect_same_shape(mended(read_polymap(file).plan));
    }
}

}  // namespace
}  // namespace docent::test::medial_axis_test
