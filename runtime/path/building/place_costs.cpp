#include "runtime/path/building/place_costs.h"

#include <algorithm>
#include <vector>

#include "runtime/path/route.h"

namespace docent::path {
namespace {

/// Offset ways keep the wall on one hand, so the way back is another.
bool is_as_long_as_back(const RouteQuery& kind) noexcept {
  return kind.kind != RouteKind::Offset || kind.hand == Hand::Shorter;
}

class Matrix {
 public:
  Matrix(const BuildingMap& building, const BuildingQuery& kind,
         std::span<const BuildingPlace> places)
      : building_(building),
        query_(kind.way),
        places_(places),
        stops_(building.stops()),
        costs_(building.stop_costs(kind, kind.metric.value_or(Metric::Time))),
        stop_count_(stops_.stop.size()),
        found_(no_ways_between(places.size())),
        leaving_(places.size() * stop_count_, infinity),
        arriving_(leaving_) {
    query_.tell_clearance = false;
  }

  TourCosts run() {
    for (std::size_t a = 0; a < places_.size(); ++a) {
      add_ways_along_the_floor(a);
      add_ways_to_stops(a);
    }
    for (std::size_t a = 0; a < places_.size(); ++a) add_ways_by_connections(a);
    return std::move(found_);
  }

 private:
  double along(std::uint32_t floor, Vec2 from, Vec2 to) {
    query_.from = from;
    query_.to = to;
    const Way way = route(building_.floor(floor), query_);
    return way.status == RouteStatus::Ok ? costs_->of_metres(way.length) : infinity;
  }
  double& cost(std::size_t from, std::size_t to) { return found_.cost[from * places_.size() + to]; }

  void add_ways_along_the_floor(std::size_t a) {
    cost(a, a) = 0;
    for (std::size_t b = 0; b < a; ++b) {
      const BuildingPlace &p = places_[a], &q = places_[b];
      if (p.floor != q.floor) continue;
      cost(a, b) = along(p.floor, p.position, q.position);
      cost(b, a) = is_as_long_as_back(query_) ? cost(a, b) : along(p.floor, q.position, p.position);
    }
  }

  void add_ways_to_stops(std::size_t a) {
    const BuildingPlace& place = places_[a];
    for (std::uint32_t s = stops_.first(place.floor); s < stops_.end(place.floor); ++s) {
      if (!costs_->is_permitted(stops_.stop[s].connection)) continue;
      const Vec2 stop = stops_.stop[s].position;
      double& leaving = leaving_[a * stop_count_ + s];
      leaving = along(place.floor, place.position, stop);
      arriving_[a * stop_count_ + s] =
          is_as_long_as_back(query_) ? leaving : along(place.floor, stop, place.position);
    }
  }

  /// The cheapest way from the place to come out at each stop of the building, then to each place.
  void add_ways_by_connections(std::size_t a) {
    std::vector<double> coming_out(stop_count_, infinity);
    const std::uint32_t floor = places_[a].floor;
    for (std::uint32_t s = stops_.first(floor); s < stops_.end(floor); ++s) {
      const double leaving = leaving_[a * stop_count_ + s];
      if (leaving == infinity) continue;
      const CostsFromStop& rides = costs_->from(s);
      for (std::size_t t = 0; t < stop_count_; ++t)
        coming_out[t] = std::min(coming_out[t], leaving + rides.cost[t]);
    }
    for (std::size_t b = 0; b < places_.size(); ++b)
      for (std::uint32_t t = stops_.first(places_[b].floor); t < stops_.end(places_[b].floor); ++t)
        cost(a, b) = std::min(cost(a, b), coming_out[t] + arriving_[b * stop_count_ + t]);
  }

  const BuildingMap& building_;
  RouteQuery query_;
  std::span<const BuildingPlace> places_;
  const BuildingStops& stops_;
  std::shared_ptr<const StopCosts> costs_;
  std::size_t stop_count_;
  TourCosts found_;
  std::vector<double> leaving_, arriving_;  ///< By place, then by stop of its floor.
};

}  // namespace

TourCosts place_costs(const BuildingMap& building, const BuildingQuery& kind,
                      std::span<const BuildingPlace> places) {
  return Matrix(building, kind, places).run();
}

}  // namespace docent::path
