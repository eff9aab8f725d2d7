#include "runtime/path/shortest/landmarks.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/runtime/path/floors.h"

namespace docent::test::landmarks_test {
namespace {

RC_GTEST_PROP(Landmarks, NeverSayMoreThanTheShortestWay, ()) {
  const auto plan = random_hall();
  RC_PRE(plan.has_value());
  const Floor floor = floor_of(*plan);
  const std::size_t corners = floor.sight.corner.size();
  RC_PRE(corners > 1U);
  const path::Landmarks landmarks(floor.plan, floor.sight);
  const auto from = *rc::gen::inRange<std::uint32_t>(0, static_cast<std::uint32_t>(corners));
  const Vec2 goal = random_point();
  RC_PRE(is_inside(*plan, goal));

  path::LandmarkBound bound(landmarks, 0);
  double shortest = std::numeric_limits<double>::infinity();
  std::vector<Vec2> position;
  for (const std::uint32_t vertex : floor.sight.corner) position.push_back(plan->vertex[vertex]);
  const std::vector<double> way = brute_force_lengths(*plan, position[from], position);
  for (std::uint32_t last = 0; last < corners; ++last) {
    const double rest = glm::distance(position[last], goal);
    bound.add(last, rest);
    shortest = std::min(shortest, way[last] + rest);
  }

  if (std::isfinite(shortest)) RC_ASSERT(bound.from(from) <= shortest + 1e-9);
}

TEST(Landmarks, KnowThatWhatIsNearThroughAWallIsFarOnFoot) {
  // Two corridors side by side, joined at their far end; a case stands in each.
  const Floor floor =
      floor_of(drawn({{0, 0}, {20, 0}, {20, 4}, {2, 4}, {2, 6}, {20, 6}, {20, 10}, {0, 10}},
                     {rectangle({18, 1}, {19, 2}), rectangle({18, 8}, {19, 9})}));
  const auto corner_at = [&](Vec2 place) {
    std::uint32_t c = 0;
    while (glm::distance(floor.plan.vertex[floor.sight.corner.at(c)], place) > 1e-3) ++c;
    return c;
  };
  const path::Landmarks landmarks(floor.plan, floor.sight);

  path::LandmarkBound bound(landmarks, 0);
  bound.add(corner_at({18, 8}), 0);

  EXPECT_GT(bound.from(corner_at({18, 2})), 25);  // 6 m through the wall.
}

}  // namespace
}  // namespace docent::test::landmarks_test
