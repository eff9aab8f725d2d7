#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <vector>

#include "runtime/path/index/box_tree.h"
#include "runtime/path/index/interval_tree.h"

namespace docent::test::search_trees_test {
namespace {

double any_number() {
  return *rc::gen::inRange(-50, 51) / 10.0;
}

RC_GTEST_PROP(BoxTree, MeetsEverythingNearestFirst, ()) {
  std::vector<path::Box> boxes(*rc::gen::inRange<std::size_t>(0, 60));
  for (path::Box& box : boxes) {
    const Vec2 a{any_number(), any_number()}, b{any_number(), any_number()};
    box = {glm::min(a, b), glm::max(a, b)};
  }
  const Vec2 point{any_number(), any_number()};
  const auto distance = [&](std::uint32_t i) { return path::squared_distance(boxes[i], point); };

  std::vector<std::uint32_t> met;
  path::BoxTree(boxes).meet_nearest_first(point, distance, [&](std::uint32_t i) {
    met.push_back(i);
    return true;
  });

  RC_ASSERT(met.size() == boxes.size());
  RC_ASSERT(
      std::ranges::is_sorted(met, {}, [&](std::uint32_t i) { return std::pair(distance(i), i); }));
}

RC_GTEST_PROP(IntervalTree, MeetsEachIntervalThatContainsANumberOnce, ()) {
  std::vector<path::Interval> intervals(*rc::gen::inRange<std::size_t>(0, 60));
  for (path::Interval& interval : intervals) interval = {any_number(), any_number()};
  const double x = any_number();

  std::vector<std::uint32_t> met, expected;
  path::IntervalTree(intervals).visit_containing(x, [&](std::uint32_t i) { met.push_back(i); });

  for (std::uint32_t i = 0; i < intervals.size(); ++i)
    if (intervals[i].low <= x && x < intervals[i].high) expected.push_back(i);
  std::ranges::sort(met);
  RC_ASSERT(met == expected);
}

}  // namespace
}  // namespace docent::test::search_trees_test
