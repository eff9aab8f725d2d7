#pragma once

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "runtime/path/tour/tour_costs.h"

namespace docent::test {

/// Costs without any sense, some of them infinite.
inline path::TourCosts some_costs(std::size_t places, std::mt19937& random) {
  path::TourCosts costs = path::no_ways_between(places);
  for (double& cost : costs.cost)
    if (random() % 5 != 0) cost = static_cast<double>(random() % 1000) / 10;
  return costs;
}

/// Costs as of ways: places on floors one above the other, some of which can only be gone up to,
/// where no way is shortened by another.
inline path::TourCosts costs_of_ways(std::size_t places, std::mt19937& random) {
  struct Place {
    double x, y;
    std::size_t floor;
  };
  const auto metres = [&] { return static_cast<double>(random() % 10'000) / 100; };
  const std::size_t floors = 1 + random() % 4;
  std::vector<Place> at;
  for (std::size_t i = 0; i < places; ++i)
    at.push_back({metres(), metres(), i == 0 ? 0 : random() % floors});
  const bool has_way_down = random() % 4 != 0;
  const double up = 10 + metres() / 2, down = has_way_down ? 10 + metres() / 2 : infinity;
  const double stairs_x = metres(), stairs_y = metres();
  path::TourCosts costs = path::no_ways_between(places);
  for (std::size_t a = 0; a < places; ++a)
    for (std::size_t b = 0; b < places; ++b) {
      const Place &p = at[a], &q = at[b];
      double& cost = costs.cost[a * places + b];
      if (p.floor == q.floor) {
        cost = std::hypot(p.x - q.x, p.y - q.y);
        continue;
      }
      const auto rise = static_cast<double>(q.floor) - static_cast<double>(p.floor);
      cost = std::hypot(p.x - stairs_x, p.y - stairs_y) +
             std::hypot(q.x - stairs_x, q.y - stairs_y) + (rise > 0 ? rise * up : -rise * down);
    }
  return costs;
}

}  // namespace docent::test
