#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "content/floor/sight.h"
#include "runtime/model/geometry/orientation.h"
#include "runtime/path/index/wall_grid.h"
#include "tests/runtime/path/floors.h"

namespace docent::test {
namespace {

bool holds(std::span<const std::uint32_t> list, std::uint32_t value) {
  return std::ranges::binary_search(list, value);
}
std::span<const std::uint32_t> seen_by(const SightMap& map, std::size_t corner) {
  return std::span(map.pair_other)
      .subspan(map.pair_first[corner], map.pair_first[corner + 1] - map.pair_first[corner]);
}

/// Is a corner of the plan on the open segment? Whoever goes that way passes it.
bool passes_a_corner(const FloorPlan& plan, Vec2 a, Vec2 b) {
  return std::ranges::any_of(plan.vertex, [&](Vec2 v) {
    return v != a && v != b && orientation(a, b, v) == 0 && dot(v - a, b - a) > 0 &&
           dot(v - b, a - b) > 0;
  });
}

RC_GTEST_PROP(SightMap, HoldsThePairsOfCornersThatSeeEachOther, ()) {
  const auto plan = random_hall();
  RC_PRE(plan.has_value());
  const path::WallGrid walls(*plan, 0);

  const SightMap map = floor::make_sight_map(*plan);

  for (std::uint32_t i = 0; i < map.corner.size(); ++i)
    for (std::uint32_t j = 0; j < map.corner.size(); ++j) {
      if (i == j) continue;
      const Vec2 a = plan->vertex[map.corner[i]], b = plan->vertex[map.corner[j]];
      const bool clear = walls.segment_clear(a, b);
      if (holds(seen_by(map, i), j)) RC_ASSERT(clear);
      if (clear && !passes_a_corner(*plan, a, b)) RC_ASSERT(holds(seen_by(map, i), j));
    }
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
  const SightMap map = floor::make_sight_map(*plan);
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
  const SightMap map = floor::make_sight_map(plan);
  for (int k = 0; k < 20; ++k) {
    const Vec2 point = random_point();
    if (is_inside(plan, point)) check_cell_of(point, map, plan, walls);
  }
}

TEST(SightMap, SeesTheFourCornersOfABoxFromRoundItsSides) {
  const SightMap map = floor::make_sight_map(mended(hall_with_a_box()));

  ASSERT_EQ(map.corner.size(), 4U);
  for (std::uint32_t i = 0; i < 4; ++i) EXPECT_EQ(seen_by(map, i).size(), 2U) << "its neighbours";
}

}  // namespace
}  // namespace docent::test
