#include "runtime/plan/order_tours.h"

#include <memory>
#include <utility>
#include <vector>

#include "runtime/path/building/museum_tour.h"

namespace docent::plan {

void order_tours(Museum& museum) {
  if (museum.tours.empty()) return;
  std::vector<std::shared_ptr<const path::FloorMap>> maps;
  for (const Floor& floor : museum.floors) maps.push_back(path::make_floor_map(floor));
  const path::BuildingMap building(museum, std::move(maps));
  path::TourWish wish = path::tour_from_kiosk(museum);
  wish.permissions.closed_too = true;
  const auto walk = [&](const Tour& tour) {
    if (is_for_time(tour)) return path::best_tour(museum, building, 60 * tour.minutes, wish);
    return tour.fixed ? path::tour_in_order(museum, building, tour.exhibits, wish)
                      : path::shortest_tour(museum, building, tour.exhibits, {}, wish);
  };
  for (Tour& tour : museum.tours)
    if (const path::MuseumTour walked = walk(tour); !walked.why_not && !walked.exhibits.empty())
      path::set_walk(tour, walked);
}

}  // namespace docent::plan
