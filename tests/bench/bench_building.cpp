// What does a way through a building cost, beside the way along one of its floors, and beside a
// search that looks at all stops of both floors?

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <random>
#include <vector>

#include "runtime/model/none.h"
#include "runtime/path/building/building_map.h"
#include "tests/bench/bench_floor.h"
#include "tests/bench/house.h"
#include "tests/bench/measure.h"

namespace docent::bench {
namespace {

std::vector<path::BuildingQuery> questions(const House& house, std::size_t count,
                                           std::mt19937_64& random) {
  std::vector<path::BuildingQuery> queries;
  const std::size_t floors = house.maps.size();
  while (queries.size() < count) {
    const std::size_t from = random() % floors, to = random() % floors;
    if (from == to) continue;
    const Query& a = house.on_floor[from][random() % house.on_floor[from].size()];
    const Query& b = house.on_floor[to][random() % house.on_floor[to].size()];
    path::BuildingQuery query{.way = {.from = a.from, .to = b.to, .radius = body}};
    query.way.tell_clearance = false;
    query.from_floor = static_cast<std::uint32_t>(from);
    query.to_floor = static_cast<std::uint32_t>(to);
    queries.push_back(query);
  }
  return queries;
}

/// The same answers, by ways from both ends to all stops of their floors.
double cost_by_all_stops(const House& house, const path::BuildingMap& building,
                         const path::BuildingQuery& query) {
  double best = infinity;
  for (const Connection& out : house.museum.connections)
    for (const ConnectionStop& stop : out.stops) {
      if (stop.floor != query.from_floor) continue;
      path::RouteQuery way = query.way;
      way.to = stop.placement.position;
      best = std::min(best, path::route(building.floor(stop.floor), way).length);
    }
  for (const Connection& in : house.museum.connections)
    for (const ConnectionStop& stop : in.stops) {
      if (stop.floor != query.to_floor) continue;
      path::RouteQuery way = query.way;
      way.from = stop.placement.position;
      best = std::min(best, path::route(building.floor(stop.floor), way).length);
    }
  return best;
}

template <class Ask>
std::vector<double> microseconds(std::span<const path::BuildingQuery> queries, Ask ask) {
  std::vector<double> times;
  volatile double sink = 0;
  for (const path::BuildingQuery& query : queries) {
    const double begin = now();
    sink = sink + ask(query);
    times.push_back((now() - begin) * 1e6);
  }
  return times;
}

void report(const char* what, std::span<const double> times) {
  fmt::print("{:<52} {:>8.1f} {:>8.1f} {:>8.1f}\n", what, median(times), quantile(times, 0.9),
             quantile(times, 0.99));
}

void run(std::size_t floors, std::size_t walls, std::size_t count) {
  std::mt19937_64 random(1);
  House house(floors, walls, random);
  fmt::print("{} floors of {} vertices, 6 connections of {} stops\n", floors,
             house.museum.floors[0].plan.vertex.size(), floors);
  fmt::print("{:<52} {:>8} {:>8} {:>8}\n", "microseconds", "median", "90 %", "99 %");
  const auto building = std::make_unique<path::BuildingMap>(house.museum, house.maps);
  auto queries = questions(house, count, random);
  const auto ask = [&](const path::BuildingQuery& query) { return building->route(query).length; };
  microseconds(std::span(queries).first(1), ask);  // finds the ways between stops
  report("along one floor", microseconds(queries, [&](const path::BuildingQuery& query) {
           path::RouteQuery way = query.way;
           return path::route(building->floor(query.from_floor), way).length;
         }));
  report("through the building", microseconds(queries, ask));
  report("to all stops of both floors", microseconds(queries, [&](const path::BuildingQuery& q) {
           return cost_by_all_stops(house, *building, q);
         }));
  for (path::BuildingQuery& query : queries) query.permissions.step_free = true;
  report("by lifts alone, the first time", microseconds(std::span(queries).first(1), ask));
  report("by lifts alone", microseconds(queries, ask));

  for (path::BuildingQuery& query : queries) query.permissions.step_free = false;
  house.museum.connections[2].closed = true;
  const path::BuildingMap closed(house.museum, house.maps);
  const auto ask_closed = [&](const path::BuildingQuery& q) { return closed.route(q).length; };
  microseconds(std::span(queries).first(1), ask_closed);
  report("with a closed lift", microseconds(queries, ask_closed));
}

}  // namespace
}  // namespace docent::bench

int main(int argc, char** argv) {
  std::size_t floors = 4, walls = 1000, count = 5000;
  CLI::App app("Times ways through buildings");
  app.add_option("--floors", floors, "how many")->check(CLI::Range(2, 50));
  app.add_option("--walls", walls, "of each floor");
  app.add_option("--queries", count, "how many");
  CLI11_PARSE(app, argc, argv);
  docent::bench::run(floors, walls, count);
}
