#include "runtime/path/tour/tour_order.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "runtime/path/tour/improve_order.h"
#include "tests/runtime/path/tour/made_tours.h"

namespace docent::test::tour_order_test {
namespace {

using path::TourCosts;
using path::TourEnds;
using path::TourOrder;

/// The least of all orders, each of them tried.
double least_of_all_orders(const TourCosts& costs, const TourEnds& ends) {
  std::vector<std::uint32_t> order(costs.places - 1);
  std::iota(order.begin(), order.end(), 1U);
  double least = infinity;
  do {
    if (ends.first && order.front() != *ends.first) continue;
    if (ends.last && order.back() != *ends.last) continue;
    least = std::min(least, path::cost_of(costs, order));
  } while (std::ranges::next_permutation(order).found);
  return order.empty() ? 0 : least;
}

/// Fixed ends, of as many places: none, one or both.
TourEnds some_ends(std::size_t places, std::mt19937& random) {
  TourEnds ends;
  if (places < 3) return ends;
  const auto some = [&] { return 1 + static_cast<std::uint32_t>(random() % (places - 1)); };
  if (random() % 2 == 0) ends.first = some();
  if (random() % 2 == 0) ends.last = some();
  if (ends.first == ends.last) ends.last.reset();
  return ends;
}

void expect_keeps(const TourOrder& found, const TourCosts& costs, const TourEnds& ends) {
  std::vector<std::uint32_t> all = found.order;
  std::ranges::sort(all);
  std::vector<std::uint32_t> wanted(costs.places - 1);
  std::iota(wanted.begin(), wanted.end(), 1U);
  RC_ASSERT(all == wanted);
  if (ends.first) RC_ASSERT(found.order.front() == *ends.first);
  if (ends.last) RC_ASSERT(found.order.back() == *ends.last);
  RC_ASSERT(std::abs(path::cost_of(costs, found.order) - found.cost) < 1e-6);
}

RC_GTEST_PROP(ShortestOrder, IsTheLeastOfAllOrders, ()) {
  std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
  const TourCosts costs = some_costs(1 + random() % 8, random);
  const TourEnds ends = some_ends(costs.places, random);

  const TourOrder found = path::shortest_order(costs, ends);

  const double least = least_of_all_orders(costs, ends);
  RC_ASSERT(found.optimal);
  RC_ASSERT((found.cost == infinity) == (least == infinity));
  if (least == infinity) return;
  RC_ASSERT(std::abs(found.cost - least) < 1e-9);
  expect_keeps(found, costs, ends);
}

RC_GTEST_PROP(ImproveOrder, IsWithinTwoPercentOfTheLeast, ()) {
  std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
  const TourCosts costs = costs_of_ways(2 + random() % 12, random);
  const TourEnds ends = some_ends(costs.places, random);

  const TourOrder found = path::improve_order(costs, ends);

  const TourOrder exact = path::exact_order(costs, ends);
  RC_ASSERT(!found.optimal);
  RC_ASSERT((found.cost == infinity) == (exact.cost == infinity));
  if (exact.cost == infinity) return;
  RC_ASSERT(found.cost > exact.cost - 1e-6);
  RC_ASSERT(found.cost < exact.cost * 1.02 + 1e-6);
  expect_keeps(found, costs, ends);
}

TEST(ImproveOrder, FindsTheLeastOrderOfFourteenPlacesNearlyAlways) {
  std::mt19937 random(3);  // NOLINT: the same every time
  int exact = 0;
  constexpr int tries = 40;
  for (int i = 0; i < tries; ++i) {
    const TourCosts costs = costs_of_ways(15, random);
    const double least = path::exact_order(costs, {}).cost;
    if (path::improve_order(costs, {}).cost < least + 1e-6) ++exact;
  }

  EXPECT_GE(exact, tries - 1);
}

TEST(ImproveOrder, GoesDownEscalatorsThatNobodyCanGoUp) {
  constexpr std::size_t floors = 5, each = 6;
  std::mt19937 random(4);  // NOLINT: the same every time
  TourCosts costs = path::no_ways_between(1 + floors * each);
  const auto floor_of = [&](std::size_t place) { return place == 0 ? 0 : (place * 7) % floors; };
  for (std::size_t a = 0; a < costs.places; ++a)
    for (std::size_t b = 0; b < costs.places; ++b)
      if (floor_of(a) <= floor_of(b))
        costs.cost[a * costs.places + b] = 5 + static_cast<double>(random() % 50);

  const TourOrder found = path::improve_order(costs, {});

  ASSERT_EQ(found.order.size(), floors * each);
  for (std::size_t i = 1; i < found.order.size(); ++i)
    EXPECT_LE(floor_of(found.order[i - 1]), floor_of(found.order[i]));
}

TEST(ShortestOrder, OfNothingCostsNothing) {
  EXPECT_EQ(path::shortest_order(path::no_ways_between(1), {}).cost, 0);
}

TEST(ShortestOrder, IsTheSameEveryTime) {
  std::mt19937 random(5);  // NOLINT: the same every time
  const TourCosts costs = costs_of_ways(61, random);

  EXPECT_EQ(path::shortest_order(costs, {}).order, path::shortest_order(costs, {}).order);
}

}  // namespace
}  // namespace docent::test::tour_order_test
