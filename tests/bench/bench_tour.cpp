// How good are tours that are not proved, and how long does it take to find one, its costs
// included?

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

#include "runtime/path/building/museum_tour.h"
#include "runtime/path/tour/best_tour.h"
#include "runtime/path/tour/improve_order.h"
#include "tests/bench/house.h"
#include "tests/bench/measure.h"
#include "tests/bench/tour_bound.h"
#include "tests/runtime/path/tour/made_tours.h"

namespace docent::bench {
namespace {

struct Gaps {
  std::vector<double> found, bound, milliseconds;
};

void report(std::size_t places, std::size_t kicks, Gaps& gaps) {
  const auto percent = [](const std::vector<double>& values) {
    const double mean =
        std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
    return fmt::format("{:>8.3f} {:>8.3f}", 100 * mean, 100 * std::ranges::max(values));
  };
  fmt::print("{:>6} {:>6}   {}   {}   {:>8.2f} {:>8.2f}\n", places, kicks, percent(gaps.found),
             percent(gaps.bound), median(gaps.milliseconds), quantile(gaps.milliseconds, 0.99));
}

/// Against ten times hundred as many kicks, and against the bound of Held and Karp (1970).
void measure_orders(std::size_t instances) {
  fmt::print(
      "orders on up to four floors; gap in percent, time in ms\n{:>6} {:>6}   {:>17}   {:>17}   "
      "{:>17}\n",
      "places", "kicks", "to the long run", "to a lower bound", "median, p99");
  for (const std::size_t places : {20U, 40U, 60U}) {
    std::mt19937 random(1);  // NOLINT: the same every time
    std::vector<path::TourCosts> costs;
    std::vector<double> best, bound;
    for (std::size_t i = 0; i < instances; ++i) {
      costs.push_back(test::costs_of_ways(places + 1, random));
      best.push_back(path::improve_order(costs.back(), {}, 40'000).cost);
      bound.push_back(lower_bound_of(costs.back(), best.back()));
    }
    for (const std::size_t kicks : {std::size_t{100}, path::ordinary_kicks}) {
      Gaps gaps;
      for (std::size_t i = 0; i < instances; ++i) {
        const double begin = now();
        const double cost = path::improve_order(costs[i], {}, kicks).cost;
        gaps.milliseconds.push_back((now() - begin) * 1e3);
        gaps.found.push_back(cost / best[i] - 1);
        gaps.bound.push_back(cost / bound[i] - 1);
      }
      report(places, kicks, gaps);
    }
  }
}

void measure_choices(std::size_t instances) {
  fmt::print("\nthe best in 30 minutes: share proved, how much more any could weigh, ms\n");
  for (const std::size_t places : {12U, 14U, 24U, 40U, 64U}) {
    std::mt19937 random(2);  // NOLINT: the same every time
    std::vector<double> gaps, milliseconds;
    std::size_t proved = 0;
    for (std::size_t i = 0; i < instances; ++i) {
      const path::TourCosts costs = test::costs_of_ways(places + 1, random);
      std::vector<path::TourStop> stops(places + 1);
      for (path::TourStop& stop : stops)
        stop = {1.0 + static_cast<double>(random() % 3), 30.0 + static_cast<double>(random() % 60)};
      const double begin = now();
      const path::BestTour found = path::best_tour_within(costs, stops, 1800);
      milliseconds.push_back((now() - begin) * 1e3);
      gaps.push_back(found.weight > 0 ? found.most_weight / found.weight - 1 : 0);
      if (found.optimal) ++proved;
    }
    fmt::print("{:>6} {:>5}/{} {:>8.2f} % {:>8.2f}\n", places, proved, instances,
               100 * median(gaps), median(milliseconds));
  }
}

/// With the costs, in a house.
void measure_in_a_house(std::size_t floors, std::size_t walls) {
  std::mt19937_64 random(1);  // NOLINT: the same every time
  House house(floors, walls, random);
  Museum& museum = house.museum;
  museum.kiosk.position = house.on_floor[0][50].from;
  for (std::size_t i = 0; i < 60; ++i) {
    const std::size_t floor = i % floors;
    Exhibit& exhibit = museum.exhibits.emplace_back();
    exhibit.floor = static_cast<std::uint32_t>(floor);
    exhibit.viewing_point.position = house.on_floor[floor][100 + i].from;
  }
  const path::BuildingMap building(museum, house.maps);
  path::TourWish wish = path::tour_from_kiosk(museum);
  wish.way.radius = body;
  fmt::print("\n{} floors of {} vertices: ms with all costs\n", floors,
             museum.floors[0].plan.vertex.size());
  for (const std::size_t count : {5U, 12U, 30U, 60U}) {
    std::vector<std::uint32_t> exhibits(count);
    std::iota(exhibits.begin(), exhibits.end(), 0U);
    std::vector<double> times;
    for (int round = 0; round < 11; ++round) {
      const double begin = now();
      const path::MuseumTour tour = path::shortest_tour(museum, building, exhibits, {}, wish);
      times.push_back((now() - begin) * 1e3);
      if (tour.why_not) fmt::print("no tour\n");
    }
    fmt::print("{:>6} {:>8.2f}\n", count, median(times));
  }
}

}  // namespace
}  // namespace docent::bench

int main(int argc, char** argv) {
  CLI::App app("the order of a tour, and the best tour in some minutes");
  std::size_t instances = 40, floors = 4, walls = 1000;
  app.add_option("--instances", instances);
  app.add_option("--floors", floors);
  app.add_option("--walls", walls);
  CLI11_PARSE(app, argc, argv);
  docent::bench::measure_orders(instances);
  docent::bench::measure_choices(instances);
  docent::bench::measure_in_a_house(floors, walls);
  return 0;
}
