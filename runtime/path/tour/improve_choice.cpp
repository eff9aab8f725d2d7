#include "runtime/path/tour/improve_choice.h"

#include <algorithm>
#include <cstddef>

#include "runtime/path/tour/tour_order.h"

namespace docent::path {
namespace {

constexpr double least_saving = 1e-6;  // seconds: less is rounding
constexpr int most_rounds = 100;

class Choice {
 public:
  Choice(const TourCosts& costs, std::span<const TourStop> stops, double limit,
         std::vector<std::uint32_t> order)
      : costs_(costs), stops_(stops), limit_(limit), order_(std::move(order)) {}

  std::vector<std::uint32_t> run() {
    for (int round = 0; round < most_rounds; ++round) {
      shorten();
      if (!put_one_in() && !exchange_one()) break;
    }
    return std::move(order_);
  }

 private:
  using Order = std::vector<std::uint32_t>;
  struct Place {
    std::size_t position = 0;  ///< Before the stop that is there now, or at the end.
    double seconds = infinity;
  };

  double seconds_of(const Order& order) const noexcept {
    double seconds = cost_of(costs_, order);
    for (const std::uint32_t place : order) seconds += stops_[place].looking_seconds;
    return seconds;
  }
  bool is_out(std::uint32_t place) const {
    return std::ranges::find(order_, place) == order_.end();
  }

  void shorten() {
    TourCosts chosen = no_ways_between(order_.size() + 1);
    const auto place_of = [&](std::size_t i) { return i == 0 ? 0 : order_[i - 1]; };
    for (std::size_t a = 0; a <= order_.size(); ++a)
      for (std::size_t b = 0; b <= order_.size(); ++b)
        chosen.cost[a * chosen.places + b] = costs_.at(place_of(a), place_of(b));
    Order shorter;
    for (const std::uint32_t i : shortest_order(chosen, {}).order) shorter.push_back(place_of(i));
    if (seconds_of(shorter) < seconds_of(order_)) order_ = std::move(shorter);
  }

  /// Where a place costs least among those of an order that takes so long.
  Place cheapest_place(const Order& order, double seconds, std::uint32_t place) const noexcept {
    Place best;
    for (std::size_t i = 0; i <= order.size(); ++i) {
      const std::uint32_t before = i == 0 ? 0 : order[i - 1];
      double more = costs_.at(before, place) + stops_[place].looking_seconds;
      if (i < order.size()) more += costs_.at(place, order[i]) - costs_.at(before, order[i]);
      if (seconds + more < best.seconds) best = {i, seconds + more};
    }
    return best;
  }

  static Order with(Order order, const Place& at, std::uint32_t place) {
    order.insert(order.begin() + static_cast<std::ptrdiff_t>(at.position), place);
    return order;
  }

  /// What weighs most of what fits.
  bool put_one_in() {
    const double seconds = seconds_of(order_);
    std::uint32_t best = none;
    Place at;
    for (std::uint32_t place = 1; place < costs_.places; ++place) {
      const double least = best == none ? 0 : stops_[best].weight;
      if (stops_[place].weight <= least || !is_out(place)) continue;
      const Place here = cheapest_place(order_, seconds, place);
      if (here.seconds > limit_ - least_saving) continue;
      best = place;
      at = here;
    }
    if (best == none) return false;
    order_ = with(std::move(order_), at, best);
    return true;
  }

  bool exchange_one() {
    const double seconds = seconds_of(order_);
    for (std::size_t i = 0; i < order_.size(); ++i) {
      Order rest = order_;
      rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
      const double of_rest = seconds_of(rest), weight = stops_[order_[i]].weight;
      for (std::uint32_t place = 1; place < costs_.places; ++place) {
        if (stops_[place].weight < weight || !is_out(place)) continue;
        const Place at = cheapest_place(rest, of_rest, place);
        const bool is_heavier = stops_[place].weight > weight && at.seconds < limit_ - least_saving;
        if (!is_heavier && at.seconds > seconds - least_saving) continue;
        order_ = with(std::move(rest), at, place);
        return true;
      }
    }
    return false;
  }

  const TourCosts& costs_;
  std::span<const TourStop> stops_;
  double limit_;
  Order order_;
};

}  // namespace

std::vector<std::uint32_t> improve_choice(const TourCosts& costs, std::span<const TourStop> stops,
                                          double seconds, std::vector<std::uint32_t> order) {
  return Choice(costs, stops, seconds, std::move(order)).run();
}

}  // namespace docent::path
