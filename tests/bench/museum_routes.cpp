#include "tests/bench/museum_routes.h"

#include <memory>
#include <random>

#include "runtime/path/route.h"

namespace docent::bench {

std::vector<MuseumRoutes> museum_routes(const Museum& museum, std::size_t count) {
  constexpr double shortest_way = 4;  // metres
  std::vector<MuseumRoutes> routes{{"shortest", {}}, {"skeleton", {}}, {"offset", {}}};
  std::vector<std::shared_ptr<const path::FloorMap>> maps;
  for (const Floor& floor : museum.floors) maps.push_back(path::make_floor_map(floor));
  std::mt19937 random(17);
  const auto exhibits = static_cast<std::uint32_t>(museum.exhibits.size());
  for (std::size_t tries = 0; routes.front().path.size() < count && tries < 100 * count; ++tries) {
    const Exhibit& from = museum.exhibits[random() % exhibits];
    const Exhibit& to = museum.exhibits[random() % exhibits];
    if (from.floor != to.floor) continue;
    std::vector<std::vector<Vec2>> ways;
    for (const RouteKind kind : {RouteKind::Shortest, RouteKind::Skeleton, RouteKind::Offset}) {
      const path::Way way = path::route(*maps[from.floor], {.kind = kind,
                                                            .from = from.viewing_point.position,
                                                            .to = to.viewing_point.position,
                                                            .radius = museum.body_radius});
      if (way.status == path::RouteStatus::Ok && way.length >= shortest_way)
        ways.push_back(way.points);
    }
    if (ways.size() != routes.size()) continue;
    for (std::size_t k = 0; k < ways.size(); ++k) routes[k].path.push_back(std::move(ways[k]));
  }
  return routes;
}

std::vector<Vec2> stairs_path(double step, std::size_t corners) {
  std::vector<Vec2> path{{0, 0}};
  for (std::size_t k = 0; k <= corners; ++k)
    path.push_back(path.back() + step * (k % 2 == 0 ? Vec2{1, 0} : Vec2{0, 1}));
  return path;
}

std::vector<Vec2> hairpin_path() {
  return {{0, 0}, {4, 0}, {1.2, 2.8}};
}

}  // namespace docent::bench
