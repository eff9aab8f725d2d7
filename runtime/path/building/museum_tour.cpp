#include "runtime/path/building/museum_tour.h"

#include <algorithm>
#include <utility>

#include "runtime/path/tour/best_tour.h"
#include "runtime/path/tour/tour_order.h"

namespace docent::path {
namespace {

BuildingPlace viewing_place(const Exhibit& exhibit) {
  return {exhibit.floor, exhibit.viewing_point.position};
}

BuildingQuery query_of(const TourWish& wish) {
  return {.way = wish.way, .metric = Metric::Time, .permissions = wish.permissions};
}

BuildingWay way_between(const BuildingMap& building, const TourWish& wish,
                        const BuildingPlace& from, const BuildingPlace& to) {
  BuildingQuery query = query_of(wish);
  query.way.from = from.position;
  query.way.to = to.position;
  query.from_floor = from.floor;
  query.to_floor = to.floor;
  return building.route(query);
}

/// Between the start, place 0, and exhibits.
TourCosts costs_between(const Museum& museum, const BuildingMap& building,
                        std::span<const std::uint32_t> exhibits, const TourWish& wish) {
  std::vector<BuildingPlace> places{wish.from};
  for (const std::uint32_t exhibit : exhibits)
    places.push_back(viewing_place(museum.exhibits[exhibit]));
  return place_costs(building, query_of(wish), places);
}

std::optional<std::uint32_t> place_of(std::span<const std::uint32_t> exhibits,
                                      const std::optional<std::uint32_t>& exhibit) {
  if (!exhibit) return {};
  const auto found = std::ranges::find(exhibits, *exhibit);
  if (found == exhibits.end()) return {};
  return static_cast<std::uint32_t>(found - exhibits.begin()) + 1;
}

/// Why there is no way from the start to the first exhibit that has none.
MuseumTour without_way(const Museum& museum, const BuildingMap& building,
                       std::vector<std::uint32_t> unreached, const TourWish& wish) {
  MuseumTour none_found;
  none_found.why_not = BuildingStatus::NoRoute;
  if (!unreached.empty()) {
    const Exhibit& exhibit = museum.exhibits[unreached.front()];
    none_found.why_not = way_between(building, wish, wish.from, viewing_place(exhibit)).status;
  }
  none_found.unreached = std::move(unreached);
  return none_found;
}

/// Those to come to which takes least for what they weigh, where there are too many to choose from.
std::vector<std::uint32_t> choices(const Museum& museum, const BuildingMap& building,
                                   double seconds, const TourWish& wish) {
  std::vector<std::uint32_t> worthy;
  for (std::uint32_t i = 0; i < museum.exhibits.size(); ++i)
    if (museum.exhibits[i].weight > 0) worthy.push_back(i);
  if (worthy.size() <= most_choices) return worthy;
  std::vector<std::pair<double, std::uint32_t>> by_worth;
  for (const std::uint32_t i : worthy) {
    const Exhibit& exhibit = museum.exhibits[i];
    const BuildingWay way = way_between(building, wish, wish.from, viewing_place(exhibit));
    const double takes = way.seconds + exhibit.looking_seconds;
    if (way.status == BuildingStatus::Ok && takes <= seconds)
      by_worth.emplace_back(-exhibit.weight / std::max(takes, 1.0), i);
  }
  std::ranges::sort(by_worth);
  worthy.clear();
  for (const auto& [worth, i] : std::span(by_worth).first(std::min(most_choices, by_worth.size())))
    worthy.push_back(i);
  return worthy;
}

}  // namespace

MuseumTour tour_in_order(const Museum& museum, const BuildingMap& building,
                         std::span<const std::uint32_t> exhibits, const TourWish& wish) {
  MuseumTour tour;
  tour.exhibits.assign(exhibits.begin(), exhibits.end());
  BuildingPlace at = wish.from;
  for (const std::uint32_t i : exhibits) {
    const Exhibit& exhibit = museum.exhibits[i];
    const BuildingWay way = way_between(building, wish, at, viewing_place(exhibit));
    if (way.status != BuildingStatus::Ok) {
      MuseumTour no_tour;
      no_tour.why_not = way.status;
      no_tour.unreached = {i};
      return no_tour;
    }
    tour.length += way.length;
    tour.walk_seconds += way.seconds;
    tour.arrives.push_back(tour.seconds());
    tour.looking_seconds += exhibit.looking_seconds;
    tour.weight += exhibit.weight;
    at = viewing_place(exhibit);
  }
  return tour;
}

MuseumTour shortest_tour(const Museum& museum, const BuildingMap& building,
                         std::span<const std::uint32_t> exhibits, const ExhibitEnds& ends,
                         const TourWish& wish) {
  const TourCosts costs = costs_between(museum, building, exhibits, wish);
  std::vector<std::uint32_t> unreached;
  for (std::size_t i = 0; i < exhibits.size(); ++i)
    if (costs.at(0, i + 1) == infinity) unreached.push_back(exhibits[i]);
  if (!unreached.empty()) return without_way(museum, building, std::move(unreached), wish);
  const TourOrder found = shortest_order(
      costs, {.first = place_of(exhibits, ends.first), .last = place_of(exhibits, ends.last)});
  if (found.cost == infinity) return without_way(museum, building, {}, wish);
  std::vector<std::uint32_t> order;
  for (const std::uint32_t place : found.order) order.push_back(exhibits[place - 1]);
  MuseumTour tour = tour_in_order(museum, building, order, wish);
  tour.optimal = found.optimal;
  return tour;
}

MuseumTour best_tour(const Museum& museum, const BuildingMap& building, double seconds,
                     const TourWish& wish) {
  constexpr double to_spare = 1e-6;  // costs are summed up in another order than ways
  const std::vector<std::uint32_t> chosen = choices(museum, building, seconds, wish);
  const TourCosts costs = costs_between(museum, building, chosen, wish);
  std::vector<TourStop> stops(1);
  for (const std::uint32_t i : chosen)
    stops.push_back({museum.exhibits[i].weight, museum.exhibits[i].looking_seconds});
  const BestTour found = best_tour_within(costs, stops, seconds - to_spare);
  std::vector<std::uint32_t> order;
  for (const std::uint32_t place : found.order) order.push_back(chosen[place - 1]);
  MuseumTour tour = tour_in_order(museum, building, order, wish);
  tour.most_weight = found.most_weight;
  const auto worthy =
      std::ranges::count_if(museum.exhibits, [](const Exhibit& one) { return one.weight > 0; });
  tour.optimal = found.optimal && static_cast<std::size_t>(worthy) == chosen.size();
  return tour;
}

TourWish tour_from_kiosk(const Museum& museum) {
  TourWish wish;
  wish.from = {museum.kiosk_floor, museum.kiosk.position};
  wish.way.radius = museum.body_radius;
  return wish;
}

void set_walk(Tour& tour, const MuseumTour& walked) {
  tour.exhibits = walked.exhibits;
  tour.arrives = walked.arrives;
  tour.seconds = walked.seconds();
}

}  // namespace docent::path
