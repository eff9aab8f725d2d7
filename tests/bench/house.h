#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "runtime/model/museum.h"
#include "runtime/path/floor_map.h"
#include "tests/bench/bench_floor.h"
#include "tests/bench/generated_floors.h"

namespace docent::bench {

inline constexpr double body = 0.25;

/// Floors of generated museums, one above the other, joined by stairs, lifts and an escalator each
/// way, which stand at random places.
struct House {
  Museum museum;
  std::vector<std::shared_ptr<const path::FloorMap>> maps;
  std::vector<std::vector<Query>> on_floor;  ///< Questions on each floor alone.

  House(std::size_t floors, std::size_t walls, std::mt19937_64& random) {
    const std::vector<double> radii{0, body};
    const auto compiled = compile(to_polymap(generated_museum(walls, Turn::Slanting)), radii);
    museum.floors.assign(floors, compiled->floor);
    for (std::size_t i = 0; i < floors; ++i) {
      museum.floors[i].plan.ordinal = static_cast<std::int32_t>(i);
      maps.push_back(path::make_floor_map(museum.floors[i]));
      on_floor.push_back(random_queries(*maps[i], museum.floors[i].plan, body, 500, random));
    }
    using enum ConnectionKind;
    for (const ConnectionKind kind : {Stairs, Stairs, Lift, Lift, Escalator, Escalator}) join(kind);
  }

  void join(ConnectionKind kind) {
    const std::size_t count = museum.connections.size();
    const bool is_lift = kind == ConnectionKind::Lift;
    Connection connection;
    connection.id = std::to_string(count);
    connection.kind = kind;
    connection.step_free = is_lift;
    connection.wait_seconds = is_lift ? 25 : 0;
    connection.seconds_per_floor = is_lift ? 3 : 16;
    connection.metres_per_floor = is_lift ? 0 : 8;
    if (kind == ConnectionKind::Escalator)
      connection.direction = count % 2 == 0 ? ConnectionDirection::Up : ConnectionDirection::Down;
    for (std::uint32_t floor = 0; floor < museum.floors.size(); ++floor)
      connection.stops.push_back({floor, {on_floor[floor][count].from, 0}});
    museum.connections.push_back(std::move(connection));
  }
};

}  // namespace docent::bench
