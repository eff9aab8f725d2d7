#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "content/content_error.h"
#include "content/floor/sight.h"
#include "content/floor/voronoi.h"
#include "runtime/model/geometry/orientation.h"
#include "runtime/path/index/wall_grid.h"
#include "runtime/path/shortest/make_tangent_graph.h"
#include "tests/runtime/path/floors.h"

namespace docent::test::sight_map_test {
namespace {

bool holds(std::span<const std::uint32_t> list, std::uint32_t value) {
  return std::ranges::binary_search(list, value);
}
std::span<const std::uint32_t> seen_by(const SightMap& map, std::size_t corner) {
  return std::span(map.pair_other)
      .subspan(map.pair_first[corner], map.pair_first[corner + 1] - map.pair_first[corner]);
}

SightMap sight_of(const FloorPlan& plan) {
  return floor::make_sight_map(plan, floor::voronoi_diagram(plan));
}

/// Is a corner of the plan on the open segment? Whoever goes that way passes it.
bool passes_a_corner(const FloorPlan& plan, Vec2 a, Vec2 b) {
  return std::ranges::any_of(plan.vertex, [&](Vec2 v) {
    return v != a && v != b && orientation(a, b, v) == 0 && dot(v - a, b - a) > 0 &&
           dot(v - b, a - b) > 0;
  });
}

/// The pairs of corners between which a straight line is free, and no others.
SightMap all_pairs(const SightMap& made, const FloorPlan& plan, const path::WallGrid& walls) {
  SightMap all;
  all.corner = made.corner;
  for (std::uint32_t i = 0; i < all.corner.size(); ++i) {
    for (std::uint32_t j = 0; j < all.corner.size(); ++j) {
      const Vec2 a = plan.vertex[all.corner[i]], b = plan.vertex[all.corner[j]];
      if (i != j && walls.segment_clear(a, b) && !passes_a_corner(plan, a, b))
        all.pair_other.push_back(j);
    }
    all.pair_first.push_back(static_cast<std::uint32_t>(all.pair_other.size()));
  }
  return all;
}

RC_GTEST_PROP(SightMap, HoldsOnlyPairsOfCornersThatSeeEachOther, ()) {
  const auto plan = random_hall();
  RC_PRE(plan.has_value());
  const path::WallGrid walls(*plan, 0);

  const SightMap map = sight_of(*plan);

  for (std::uint32_t i = 0; i < map.corner.size(); ++i)
    for (const std::uint32_t j : seen_by(map, i))
      RC_ASSERT(walls.segment_clear(plan->vertex[map.corner[i]], plan->vertex[map.corner[j]]));
}

/// How a disc may go straight: from where to where.
std::vector<std::array<double, 4>> straight_ways(const TangentGraph& graph) {
  std::vector<std::array<double, 4>> ways;
  for (const Tangent& tangent : graph.tangent)
    ways.push_back({tangent.leave.x, tangent.leave.y, tangent.leave_angle, tangent.arrive_angle});
  std::ranges::sort(ways);
  return ways;
}

RC_GTEST_PROP(SightMap, HoldsThePairsThatADiscOfAnySizeGoesStraightBetween, ()) {
  const auto plan = random_hall();
  RC_PRE(plan.has_value());
  const SightMap map = sight_of(*plan);
  const SightMap all = all_pairs(map, *plan, path::WallGrid(*plan, 0));

  for (const double radius :
       {0.0, *rc::gen::inRange(1, 400) * 0.005, *rc::gen::inRange(1, 50) * 0.1})
    RC_ASSERT(std::ranges::includes(straight_ways(path::make_tangent_graph(*plan, map, radius)),
                                    straight_ways(path::make_tangent_graph(*plan, all, radius))));
}

/// Lists the cell of a point all corners that the point sees?
void check_cell_of(Vec2 point, const SightMap& map, const FloorPlan& plan,
                   const path::WallGrid& walls) {
  const auto cell = map.cell_at(point);
  RC_ASSERT(cell.has_value());
  const auto listed =
      std::span(map.cell_corner)
          .subspan(map.cell_first[*cell], map.cell_first[*cell + 1] - map.cell_first[*cell]);
  for (std::uint32_t i = 0; i < map.corner.size(); ++i) {
    const Vec2 corner = plan.vertex[map.corner[i]];
    if (walls.segment_clear(point, corner) && !passes_a_corner(plan, point, corner))
      RC_ASSERT(holds(listed, i));
  }
}

RC_GTEST_PROP(SightMap, KnowsInEveryCellWhatItsPointsSee, ()) {
  const auto plan = random_hall();
  RC_PRE(plan.has_value());
  const path::WallGrid walls(*plan, 0);
  const SightMap map = sight_of(*plan);
  for (int k = 0; k < 20; ++k) {
    const Vec2 point = random_point();
    if (is_inside(*plan, point)) check_cell_of(point, map, *plan, walls);
  }
}

/// A hall of 12 by 8 m about a round pillar that is drawn finely and not quite smoothly, in a ring
/// of such walls.
FloorPlan hall_about_a_pillar(std::size_t corners, double roughness) {
  const auto circle = [&](double radius) {
    std::vector<Vec2> ring;
    for (std::size_t i = 0; i < corners; ++i) {
      const double angle =
          2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(corners);
      const double off = *rc::gen::inRange(-1000, 1001) * roughness / 1000;
      ring.push_back({6 + (radius + off) * std::cos(angle), 4 + (radius + off) * std::sin(angle)});
    }
    return ring;
  };
  return mended(drawn(circle(3.8), {circle(1.5)}));
}

RC_GTEST_PROP(SightMap, KnowsWhatIsSeenAlongFineCurves, ()) {
  const double roughness = *rc::gen::elementOf(std::vector<double>{0, 0.001, 0.02});
  const FloorPlan plan = hall_about_a_pillar(*rc::gen::inRange<std::size_t>(50, 600), roughness);
  const path::WallGrid walls(plan, 0);
  const SightMap map = sight_of(plan);
  for (int k = 0; k < 20; ++k) {
    const Vec2 point = random_point();
    if (is_inside(plan, point)) check_cell_of(point, map, plan, walls);
  }
}

/// A round hall of 10 m with teeth of 3 m that point to its middle.
FloorPlan hall_with_teeth(std::size_t teeth) {
  std::vector<Vec2> ring;
  for (std::size_t i = 0; i < 2 * teeth; ++i) {
    const double angle = std::numbers::pi * static_cast<double>(i) / static_cast<double>(teeth);
    const double radius = i % 2 == 0 ? 10 : 7;
    ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return mended(drawn(ring, {}));
}

TEST(SightMap, OfACurveThatIsNotQuiteSmoothHoldsFewOfThePairsThatSeeEachOther) {
  // Every tip sees every other, but a disc that bends at a tip of a wall passes along that wall.
  std::vector<Vec2> ring;
  constexpr std::size_t corners = 400;
  for (std::size_t i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / corners;
    const double radius = i % 2 == 0 ? 10 : 9.995;
    ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }

  const SightMap map = sight_of(mended(drawn(ring, {})));

  EXPECT_EQ(map.corner.size(), corners / 2);
  EXPECT_LT(map.pair_other.size(), map.corner.size() * map.corner.size() / 20);
}

TEST(SightMap, IsRefusedBeforeItIsMadeWhereCornersSeeEachOtherAlongMillionsOfLines) {
  EXPECT_NO_THROW(sight_of(hall_with_teeth(200)));
  try {
    sight_of(hall_with_teeth(4000));
    FAIL() << "sixteen million ways from tip to tip";
  } catch (const content::ContentError& error) {
    EXPECT_EQ(error.code, "too-many-lines");
  }
}

TEST(SightMap, SeesTheFourCornersOfABoxFromRoundItsSides) {
  const SightMap map = sight_of(mended(hall_with_a_box()));

  ASSERT_EQ(map.corner.size(), 4U);
  for (std::uint32_t i = 0; i < 4; ++i) EXPECT_EQ(seen_by(map, i).size(), 2U) << "its neighbours";
}

}  // namespace
}  // namespace docent::test::sight_map_test
