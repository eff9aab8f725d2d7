#include "content/floor/voronoi.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "content/content_error.h"
#include "tests/content/floor/diagram_check.h"
#include "tests/content/floor/plans.h"
#include "tests/content/floor/random_plan.h"
#include "tests/support/reference_data.h"
#include "tests/support/sanitized.h"

namespace docent::test::voronoi_test {
namespace {

Complaint check_diagram_of(const FloorPlan& plan) {
  return check(plan, floor::voronoi_diagram(plan));
}

TEST(Voronoi, GivesASquareRoomOneRegionPerWallMeetingInTheMiddle) {
  const FloorPlan room = mended(drawn(rectangle({0, 0}, {4, 4})));
  const VoronoiDiagram diagram = floor::voronoi_diagram(room);
  EXPECT_EQ(check(room, diagram), "");
  EXPECT_EQ(diagram.site.size(), 4U);
  ASSERT_EQ(diagram.vertex.size(), 5U);  // The four corners and one vertex of four sites.
  EXPECT_EQ(diagram.vertex[4], Vec2(2, 2));
  EXPECT_DOUBLE_EQ(diagram.clearance[4], 2);
  EXPECT_EQ(diagram.edge.size(), 4U);
}

TEST(Voronoi, GivesAReflexCornerARegionBoundedByAParabola) {
  // An L: the corner (2, 2) faces the walls on the far sides.
  const FloorPlan room = mended(drawn({{0, 0}, {6, 0}, {6, 2}, {2, 2}, {2, 6}, {0, 6}}));
  const VoronoiDiagram diagram = floor::voronoi_diagram(room);
  EXPECT_EQ(check(room, diagram), "");
  ASSERT_EQ(diagram.site.size(), 7U);
  EXPECT_EQ(diagram.site[6].kind, Site::Kind::Corner);
  EXPECT_EQ(room.vertex[diagram.site[6].index], Vec2(2, 2));
  EXPECT_EQ(std::ranges::count_if(diagram.edge, &VoronoiEdge::parabola), 2);
}

TEST(Voronoi, MergesTheVerticesOfARoundRoomIntoOne) {
  const FloorPlan room = mended(drawn(regular_polygon({3, 7}, 10, 64)));
  const VoronoiDiagram diagram = floor::voronoi_diagram(room);
  EXPECT_EQ(check(room, diagram), "");
  EXPECT_EQ(diagram.vertex.size(), 65U);
  EXPECT_EQ(diagram.edge.size(), 64U);
}

TEST(Voronoi, StaysExactFarFromTheOrigin) {
  const Vec2 origin{654321.25, 5765432.75};
  const FloorPlan room =
      mended(drawn(rectangle(origin, origin + Vec2{20, 12}),
                   {rectangle(origin + Vec2{5, 4}, origin + Vec2{8, 6}),
                    {origin + Vec2{12, 6}, origin + Vec2{13.125, 8}, origin + Vec2{14, 6.5}}}));
  // Doubles are 1e-9 apart there, so that is as near to equal as distances can be.
  EXPECT_EQ(check(room, floor::voronoi_diagram(room), 3e-9, 1e-8), "");
}

TEST(Voronoi, HoldsWhereTwoCasesTouchInACorner) {
  EXPECT_EQ(check_diagram_of(
                mended(drawn(rectangle({0, 0}, {20, 12}), {{{5, 4}, {5, 6}, {8, 6}, {8, 4}},
                                                           {{8, 6}, {8, 8}, {11, 8}, {11, 6}}}))),
            "");
}

TEST(Voronoi, HoldsWhereACornerTouchesAWallFromBehind) {
  // Two halls on either side of y = 4; the tip of the lower one touches the upper one's wall.
  import::ImportedPlan plan = drawn(rectangle({0, 4}, {10, 8}));
  plan.polygons.push_back(drawn({{2, 0}, {8, 0}, {5, 4}}).polygons[0]);
  const FloorPlan halls = mended(plan);
  EXPECT_EQ(halls.vertex.size(), 8U);
  EXPECT_EQ(check_diagram_of(halls), "");
}

TEST(Voronoi, HoldsAtNearlyStraightAndNearlyClosedCorners) {
  for (const double bump : {1e-6, -1e-6, 1e-12, -1e-12}) {
    const Points outer = {{0, 0}, {10, bump}, {20, 0}, {20, 12}, {0, 12}};
    EXPECT_EQ(check_diagram_of(mended(drawn(outer))), "") << bump;
  }
  EXPECT_EQ(check_diagram_of(mended(drawn({{0, 0}, {100, 0}, {100, 0.01}}))), "");
  EXPECT_EQ(
      check_diagram_of(mended(drawn(rectangle({0, 0}, {20, 12}), {{{5, 5}, {15, 5.01}, {15, 5}}}))),
      "");
}

TEST(Voronoi, HoldsWhereWallsLieOnOneLineAndCasesBetweenThem) {
  // Rounding bends the line by a hair to either side, or not at all.
  for (int i = 1; i < 100; ++i) {
    const Vec2 along{std::cos(0.01 * i), std::sin(0.01 * i)}, inwards = left_of(along);
    Points ring;
    for (const double at : {0.0, 2.3, 5.1, 7.7, 9.2}) {
      const Vec2 from = at * along, to = (at + 1.1) * along;
      ring.insert(ring.end(), {from, to, to + inwards, to + inwards + 0.3 * along});
      ring.push_back((at + 1.4) * along);
    }
    for (const double at : {12.0, 0.0}) ring.push_back(at * along + 5.0 * inwards);
    EXPECT_EQ(check_diagram_of(mended(drawn(ring))), "") << i;
  }
}

TEST(Voronoi, IsTheSameEveryTime) {
  const FloorPlan room = mended(hall_with({{300, 300, 80, 5, 15}, {800, 500, 120, 8, 30}}));
  const VoronoiDiagram first = floor::voronoi_diagram(room), second = floor::voronoi_diagram(room);
  EXPECT_EQ(first.vertex, second.vertex);
  EXPECT_EQ(first.region_edge, second.region_edge);
}

TEST(Voronoi, RefusesWallsThatCross) {
  FloorPlan bow_tie = mended(drawn(rectangle({0, 0}, {4, 4})));
  std::swap(bow_tie.vertex[0], bow_tie.vertex[1]);
  EXPECT_THROW(floor::voronoi_diagram(bow_tie), content::ContentError);
}

RC_GTEST_PROP(Voronoi, IsEquidistantEmptyAndTilesTheFloorOfAnyHall, ()) {
  const auto obstacles = *any_obstacles();
  FloorPlan plan;
  try {
    plan = mended(hall_with(obstacles));
  } catch (const content::ContentError&) {
    RC_DISCARD("the obstacles cover the hall");
  }
  const Complaint complaint = check_diagram_of(plan);
  if (!complaint.empty()) RC_FAIL(complaint);
}

TEST(Voronoi, IsEquidistantEmptyAndTilesTheFloorOfEveryReferencePlan) {
  NEEDS_REFERENCE_DATA("floorplans/reference/maps");
  for (const char* folder : {"floorplans/reference/maps", "floorplans/plans", "floorplans/nasty"})
    for (const auto& file : plan_files(folder)) {
      if (file.stem() == "d30-nan-coordinate" || file.stem() == "d26-far-from-origin") continue;
      SCOPED_TRACE(file.filename().string());
      const Polymap map = read_polymap(file);
      FloorPlan plan;
      try {
        plan = mended(map.plan);
      } catch (const content::ContentError&) {
        continue;  // Mend's own test says which of them that may be.
      }
      const std::size_t most = test::is_sanitized ? 400 : 3000;  // Brute force takes its time.
      if (plan.vertex.size() > most) continue;
      EXPECT_EQ(check_diagram_of(plan), "");
    }
}

/// How long does the diagram of a large museum take? 10,000 walls in less than two seconds, with
/// room for a slow machine; the figure itself is printed.
TEST(Voronoi, HasAFewEdgesAWallAlsoForTenThousandWalls) {
  std::vector<Points> cases;
  for (int i = 0; i < 50; ++i)
    for (int j = 0; j < 50; ++j)
      cases.push_back(regular_polygon({2 + 2 * i + 0.01 * j, 2 + 2 * j}, 0.6, 4, 7 * i + 3 * j));
  const FloorPlan plan = mended(drawn(rectangle({0, 0}, {104, 104}), cases));
  ASSERT_EQ(plan.vertex.size(), 10004U);

  const VoronoiDiagram diagram = floor::voronoi_diagram(plan);

  // A planar graph over walls and reflex corners: Euler allows three edges a site.
  EXPECT_EQ(diagram.site.size(), 10004U + 10000U);
  EXPECT_LT(diagram.edge.size(), 3 * diagram.site.size());
}

}  // namespace
}  // namespace docent::test::voronoi_test
