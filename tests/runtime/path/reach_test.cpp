#include "runtime/path/reach.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/runtime/path/floors.h"

namespace docent::test::reach_test {
namespace {

TEST(Reach, ListsWhatIsNearOnFootFirst) {
  // Straight through the wall it is 2.2 m, on foot through the door more than the way to the
  // corner.
  const Floor floor = floor_of(two_rooms(1));
  const auto map = path::make_floor_map(floor);
  const std::vector<Vec2> places{{5.2, 0.5}, {0.5, 0.5}, {4.1, 0.5}};  // the last is in the wall

  const auto reached = path::places_in_reach(*map, {3, 0.5}, places, 0.25);

  ASSERT_EQ(reached.size(), 2U);
  EXPECT_EQ(reached[0].place, 1U);
  EXPECT_NEAR(reached[0].length, 2.5, 1e-9);
  EXPECT_EQ(reached[1].place, 0U);
  EXPECT_GT(reached[1].length, 2.5);
  EXPECT_EQ(path::nearest_place(*map, {3, 0.5}, places, 0.25)->place, 1U);
}

TEST(Reach, EndsWhereTheTimeIsUp) {
  const Floor floor = floor_of(hall_with_a_box());
  const auto map = path::make_floor_map(floor);
  const std::vector<Vec2> places{{2, 1}, {9, 1}, {11, 1}};

  EXPECT_EQ(path::places_in_reach(*map, {1, 1}, places, 0.25, 8).size(), 2U);
  EXPECT_EQ(path::places_in_reach(*map, {1, 1}, places, 0.25, 7.9).size(), 1U);
  EXPECT_FALSE(path::nearest_place(*map, {1, 1}, places, 0.25, 0.9).has_value());
  EXPECT_TRUE(path::places_in_reach(*map, {6, 4}, places, 0.25).empty()) << "from inside the box";
}

RC_GTEST_PROP(Reach, IsWhatAVisibilityGraphSays, ()) {
  const auto plan = random_hall();
  RC_PRE(plan.has_value());
  const Floor floor = floor_of(*plan);
  const auto map = path::make_floor_map(floor);
  const Vec2 from = random_point();
  RC_PRE(is_inside(*plan, from));
  std::vector<Vec2> places(4);
  for (Vec2& place : places) place = random_point();
  const double limit = *rc::gen::inRange(1, 12);

  const auto reached = path::places_in_reach(*map, from, places, 0, limit);

  std::vector<path::Reached> expected;
  const std::vector<double> lengths = brute_force_lengths(*plan, from, places);
  for (std::uint32_t i = 0; i < places.size(); ++i)
    if (is_inside(*plan, places[i]) && lengths[i] <= limit) expected.push_back({i, lengths[i]});
  std::ranges::sort(expected, {}, &path::Reached::length);
  RC_ASSERT(reached.size() == expected.size());
  for (std::size_t i = 0; i < reached.size(); ++i)
    RC_ASSERT(std::abs(reached[i].length - expected[i].length) < 1e-6);
  const auto nearest = path::nearest_place(*map, from, places, 0, limit);
  RC_ASSERT(nearest.has_value() == !reached.empty());
  if (nearest) RC_ASSERT(nearest->place == reached[0].place);
}

}  // namespace
}  // namespace docent::test::reach_test
