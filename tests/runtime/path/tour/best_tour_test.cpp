#include "runtime/path/tour/best_tour.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

#include "runtime/path/tour/tour_order.h"
#include "tests/runtime/path/tour/made_tours.h"

namespace docent::test::best_tour_test {
namespace {

using path::BestTour;
using path::TourCosts;
using path::TourStop;

std::vector<TourStop> some_stops(std::size_t places, std::mt19937& random) {
  std::vector<TourStop> stops(places);
  for (TourStop& stop : stops)
    stop = {static_cast<double>(random() % 5), static_cast<double>(random() % 90)};
  return stops;
}

double seconds_of(const TourCosts& costs, std::span<const TourStop> stops,
                  std::span<const std::uint32_t> order) {
  double seconds = path::cost_of(costs, order);
  for (const std::uint32_t place : order) seconds += stops[place].looking_seconds;
  return seconds;
}

/// The greatest weight of all tours that there is time for, each of them tried.
double greatest_weight(const TourCosts& costs, std::span<const TourStop> stops, double limit) {
  std::vector<std::uint32_t> order(costs.places - 1);
  std::iota(order.begin(), order.end(), 1U);
  double greatest = 0;
  do {
    for (std::size_t n = 1; n <= order.size(); ++n) {
      const std::span some = std::span(order).first(n);
      if (seconds_of(costs, stops, some) > limit) break;
      double weight = 0;
      for (const std::uint32_t place : some) weight += stops[place].weight;
      greatest = std::max(greatest, weight);
    }
  } while (std::ranges::next_permutation(order).found);
  return greatest;
}

RC_GTEST_PROP(BestTour, OutweighsEveryTourThatThereIsTimeFor, ()) {
  std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
  const std::size_t places = 1 + random() % 7;
  // What weighs nothing is no short cut where costs are those of ways.
  const bool are_ways = random() % 2 == 0;
  const TourCosts costs = are_ways ? costs_of_ways(places, random) : some_costs(places, random);
  std::vector<TourStop> stops = some_stops(places, random);
  if (!are_ways)
    for (TourStop& stop : stops) ++stop.weight;
  const auto limit = static_cast<double>(random() % 600);

  const BestTour found = path::best_tour_within(costs, stops, limit);

  RC_ASSERT(found.optimal);
  RC_ASSERT(std::abs(found.weight - greatest_weight(costs, stops, limit)) < 1e-9);
  RC_ASSERT(std::abs(found.most_weight - found.weight) < 1e-9);
}

RC_GTEST_PROP(BestTour, IsNeverLateAndAddsUp, ()) {
  std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
  const std::size_t places = 2 + random() % 50;
  const TourCosts costs = costs_of_ways(places, random);
  const std::vector<TourStop> stops = some_stops(places, random);
  const auto limit = static_cast<double>(random() % 2400);

  const BestTour found = path::best_tour_within(costs, stops, limit, 100);

  double weight = 0;
  for (const std::uint32_t place : found.order) weight += stops[place].weight;
  RC_ASSERT(std::abs(weight - found.weight) < 1e-6);
  RC_ASSERT(std::abs(seconds_of(costs, stops, found.order) - found.seconds) < 1e-6);
  RC_ASSERT(found.seconds <= limit);
  RC_ASSERT(found.order.empty() == (found.weight == 0));
  RC_ASSERT(found.weight <= found.most_weight + 1e-6);
  if (found.optimal) RC_ASSERT(found.most_weight <= found.weight + 1e-6);
}

TEST(BestTour, TakesTheWeightyExhibitThatIsFarRatherThanTwoThatAreNear) {
  TourCosts costs = path::no_ways_between(4);
  for (std::size_t a = 0; a < 4; ++a)
    for (std::size_t b = 1; b < 4; ++b) costs.cost[a * 4 + b] = a == 3 || b == 3 ? 100 : 10;
  const std::vector<TourStop> stops{{}, {1, 20}, {1, 20}, {5, 20}};

  EXPECT_EQ(path::best_tour_within(costs, stops, 125).order, (std::vector<std::uint32_t>{3}));
  EXPECT_EQ(path::best_tour_within(costs, stops, 119).weight, 2);
  EXPECT_TRUE(path::best_tour_within(costs, stops, 29).order.empty());
}

}  // namespace
}  // namespace docent::test::best_tour_test
