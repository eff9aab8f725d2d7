#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <span>

#include "content/floor/sight.h"
#include "runtime/path/index/predicates.h"
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
    return v != a && v != b && path::orientation(a, b, v) == 0 && dot(v - a, b - a) > 0 &&
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

RC_GTEST_PROP(SightMap, KnowsInEveryCellWhatItsPointsSee, ()) {
  const auto plan = random_hall();
  RC_PRE(plan.has_value());
  const path::WallGrid walls(*plan, 0);
  const SightMap map = floor::make_sight_map(*plan);
  for (int k = 0; k < 20; ++k) {
    const Vec2 point = random_point();
    if (!is_inside(*plan, point)) continue;

    const auto cell = map.cell_at(point);

    RC_ASSERT(cell.has_value());
    const auto listed =
        std::span(map.cell_corner)
            .subspan(map.cell_first[*cell], map.cell_first[*cell + 1] - map.cell_first[*cell]);
    for (std::uint32_t i = 0; i < map.corner.size(); ++i) {
      const Vec2 corner = plan->vertex[map.corner[i]];
      if (walls.segment_clear(point, corner) && !passes_a_corner(*plan, point, corner))
        RC_ASSERT(holds(listed, i));
    }
  }
}

TEST(SightMap, SeesTheFourCornersOfABoxFromRoundItsSides) {
  const SightMap map = floor::make_sight_map(mended(hall_with_a_box()));

  ASSERT_EQ(map.corner.size(), 4U);
  for (std::uint32_t i = 0; i < 4; ++i) EXPECT_EQ(seen_by(map, i).size(), 2U) << "its neighbours";
}

}  // namespace
}  // namespace docent::test
