// Boost.Polygon's sweep-line Voronoi diagram (Fortune; predicates of its own, on integers) as an
// independent oracle for the vertices.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <boost/polygon/voronoi.hpp>
#include <cmath>

#include "content/content_error.h"
#include "content/floor/voronoi.h"
#include "tests/content/floor/plans.h"
#include "tests/content/floor/random_plan.h"
#include "tests/support/reference_data.h"

namespace docent::test::boost_voronoi_test {

struct IntegerPoint {
  int x = 0, y = 0;
};
struct IntegerWall {
  IntegerPoint a, b;
};

}  // namespace docent::test::boost_voronoi_test

namespace boost::polygon {

template <>
struct geometry_concept<docent::test::boost_voronoi_test::IntegerPoint> {
  using type = point_concept;
};
template <>
struct point_traits<docent::test::boost_voronoi_test::IntegerPoint> {
  using coordinate_type = int;
  static int get(const docent::test::boost_voronoi_test::IntegerPoint& point,
                 orientation_2d direction) {
    return direction == HORIZONTAL ? point.x : point.y;
  }
};
template <>
struct geometry_concept<docent::test::boost_voronoi_test::IntegerWall> {
  using type = segment_concept;
};
template <>
struct segment_traits<docent::test::boost_voronoi_test::IntegerWall> {
  using coordinate_type = int;
  using point_type = docent::test::boost_voronoi_test::IntegerPoint;
  static point_type get(const docent::test::boost_voronoi_test::IntegerWall& wall,
                        direction_1d end) {
    return end.to_int() != 0 ? wall.b : wall.a;
  }
};

}  // namespace boost::polygon

namespace docent::test::boost_voronoi_test {
namespace {

constexpr double per_metre = 1e4;  // Boost wants integers: the plans are on a grid of 0.1 mm.
constexpr double tolerance = 1e-6;

IntegerPoint on_grid(Vec2 p) {
  return {static_cast<int>(std::lround(p.x * per_metre)),
          static_cast<int>(std::lround(p.y * per_metre))};
}

bool west_of(Vec2 a, Vec2 b) {
  return a.x < b.x;
}

/// The vertices of Boost's diagram that are inside and off the walls, west to east.
Points oracle_vertices(const FloorPlan& plan) {
  std::vector<IntegerWall> walls;
  for (std::uint32_t i = 0; i < plan.vertex.size(); ++i)
    walls.push_back({on_grid(wall_start(plan, i)), on_grid(wall_end(plan, i))});
  boost::polygon::voronoi_diagram<double> diagram;
  boost::polygon::construct_voronoi(walls.begin(), walls.end(), &diagram);
  Points inside;
  for (const auto& vertex : diagram.vertices()) {
    const Vec2 p{vertex.x() / per_metre, vertex.y() / per_metre};
    if (is_inside(plan, p) && distance_to_nearest_wall(plan, p) > tolerance) inside.push_back(p);
  }
  std::ranges::sort(inside, west_of);
  return inside;
}

Points vertices_off_walls(const VoronoiDiagram& diagram) {
  Points vertices;
  for (std::size_t v = 0; v < diagram.vertex.size(); ++v)
    if (diagram.clearance[v] > tolerance) vertices.push_back(diagram.vertex[v]);
  std::ranges::sort(vertices, west_of);
  return vertices;
}

/// How many points have none of `others` within the tolerance.
std::size_t count_missing(const Points& points, const Points& others) {
  return static_cast<std::size_t>(std::ranges::count_if(points, [&](Vec2 p) {
    auto other = std::ranges::lower_bound(others, p - Vec2{tolerance, 0}, west_of);
    for (; other != others.end() && other->x < p.x + tolerance; ++other)
      if (glm::distance(*other, p) < tolerance) return false;
    return true;
  }));
}

void expect_same_vertices(const FloorPlan& plan) {
  const Points ours = vertices_off_walls(floor::voronoi_diagram(plan)),
               theirs = oracle_vertices(plan);
  EXPECT_EQ(count_missing(ours, theirs), 0U) << "of " << ours.size();
  EXPECT_EQ(count_missing(theirs, ours), 0U) << "of " << theirs.size();
}

bool is_on_grid(const FloorPlan& plan) {
  return std::ranges::all_of(plan.vertex, [](Vec2 v) {
    return glm::distance(v, Vec2(glm::round(v * per_metre)) / per_metre) < 1e-9;
  });
}

TEST(BoostVoronoi, AgreesOnTheVerticesOfEveryMetricPlan) {
  NEEDS_REFERENCE_DATA("floorplans/reference/maps");
  int compared = 0;
  for (const char* folder : {"floorplans/reference/maps", "floorplans/plans"})
    for (const auto& file : plan_files(folder)) {
      if (file.stem().string().starts_with("mai-")) continue;
      const FloorPlan plan = mended(read_polymap(file).plan);
      if (!is_on_grid(plan)) continue;
      SCOPED_TRACE(file.filename().string());
      expect_same_vertices(plan);
      ++compared;
    }
  EXPECT_GE(compared, 20);
}

RC_GTEST_PROP(BoostVoronoi, AgreesOnSquareCasesThatLineUp, ()) {
  const auto places = *rc::gen::container<std::vector<std::pair<int, int>>>(
      rc::gen::pair(rc::gen::inRange(1, 11), rc::gen::inRange(1, 7)));
  std::vector<Points> cases;
  for (const auto& [x, y] : places) cases.push_back(rectangle({x, y}, {x + 0.5, y + 0.5}));
  const FloorPlan plan = mended(drawn(rectangle({0, 0}, {12, 8}), cases));
  const Points ours = vertices_off_walls(floor::voronoi_diagram(plan)),
               theirs = oracle_vertices(plan);
  RC_ASSERT(count_missing(ours, theirs) == 0U);
  RC_ASSERT(count_missing(theirs, ours) == 0U);
}

}  // namespace
}  // namespace docent::test::boost_voronoi_test
