#pragma once

#include <memory>
#include <random>
#include <vector>

#include "platform/sqlite/content_reader.h"
#include "runtime/directions/directions.h"
#include "runtime/path/building/building_map.h"
#include "runtime/path/floor_map.h"
#include "tests/support/sample_database.h"
#include "tests/support/shipped_languages.h"

namespace docent::test {

/// The sample museum in every language that docent ships, and whatever is asked of it at random,
/// the same in every run.
struct SampleHouse {
  Museum museum = in_all_shipped_languages(sqlite::load_museum(sample_database()).value());
  std::vector<std::shared_ptr<const path::FloorMap>> maps = [this] {
    std::vector<std::shared_ptr<const path::FloorMap>> made;
    for (const Floor& floor : museum.floors) made.push_back(path::make_floor_map(floor));
    return made;
  }();
  path::BuildingMap building{museum, maps};
  directions::Doorways doorways = directions::find_doorways(museum, maps);
};

inline SampleHouse& sample_house() {
  static SampleHouse house;
  return house;
}

struct SomeWay {
  Placement start;
  directions::Goal goal;
  path::BuildingWay way;
};

/// From anywhere, looking anywhere, to any exhibit or place.
inline SomeWay some_way(std::mt19937& random) {
  SampleHouse& house = sample_house();
  const Museum& museum = house.museum;
  const auto any = [&](std::size_t count) { return static_cast<std::uint32_t>(random() % count); };
  const auto share = [&] { return static_cast<double>(random() % 100000) / 100000; };
  while (true) {
    SomeWay some;
    path::BuildingQuery query;
    query.way.radius = museum.body_radius;
    query.from_floor = any(museum.floors.size());
    some.start = {{-1 + 42 * share(), -6 + 39 * share()}, 6.28 * share()};
    query.way.from = some.start.position;
    query.permissions.step_free = any(3) == 0;
    if (any(3) > 0) {
      const std::uint32_t i = any(museum.exhibits.size());
      const Exhibit& exhibit = museum.exhibits[i];
      query.to_floor = exhibit.floor;
      query.way.to = exhibit.viewing_point.position;
      some.goal = {.floor = exhibit.floor, .position = exhibit.placement.position, .exhibit = i};
    } else {
      const std::uint32_t i = any(museum.places.size());
      const Place& place = museum.places[i];
      query.to_floor = place.floor;
      query.way.to = place.standing;
      some.goal = {.floor = place.floor, .position = place.position, .place = i};
    }
    some.way = house.building.route(query);
    if (some.way.status == path::BuildingStatus::Ok) return some;
  }
}

}  // namespace docent::test
