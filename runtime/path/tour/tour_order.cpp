#include "runtime/path/tour/tour_order.h"

#include <algorithm>
#include <bit>

#include "runtime/path/tour/improve_order.h"

namespace docent::path {
namespace {

/// The cheapest ways to have visited each set of places, by the place visited last. Sets are masks
/// of places - 1.
class SetTable {
 public:
  SetTable(const TourCosts& costs, const TourEnds& ends)
      : costs_(costs),
        ends_(ends),
        count_(costs.places - 1),
        cost_((std::size_t{1} << count_) * count_, infinity) {
    for (std::uint32_t place = 1; place <= count_; ++place)
      if (may_follow_beginning(place)) of(bit(place), place) = costs_.at(0, place);
    for (std::uint32_t set = 1; set < std::uint32_t{1} << count_; ++set)
      for (std::uint32_t last = 1; last <= count_; ++last)
        if ((set & bit(last)) != 0) extend(set, last);
  }

  TourOrder order() {
    TourOrder found;
    std::uint32_t set = (std::uint32_t{1} << count_) - 1, last = none;
    for (std::uint32_t place = 1; place <= count_; ++place)
      if ((!ends_.last || *ends_.last == place) && of(set, place) < found.cost) {
        found.cost = of(set, place);
        last = place;
      }
    found.optimal = true;
    if (last == none) return found;
    while (last != none) {
      found.order.push_back(last);
      const std::uint32_t before = previous(set, last);
      set &= ~bit(last);
      last = before;
    }
    std::ranges::reverse(found.order);
    return found;
  }

 private:
  static std::uint32_t bit(std::uint32_t place) noexcept { return 1U << (place - 1); }
  double& of(std::uint32_t set, std::uint32_t last) { return cost_[set * count_ + last - 1]; }

  /// A first place that is fixed is first; a last one is first only where it is alone.
  bool may_follow_beginning(std::uint32_t place) const noexcept {
    return ends_.first ? *ends_.first == place : true;
  }

  void extend(std::uint32_t set, std::uint32_t last) {
    const double so_far = of(set, last);
    if (so_far == infinity) return;
    for (std::uint32_t next = 1; next <= count_; ++next) {
      if ((set & bit(next)) != 0) continue;
      double& known = of(set | bit(next), next);
      known = std::min(known, so_far + costs_.at(last, next));
    }
  }

  /// The place before the last one on the cheapest way; none at the beginning.
  std::uint32_t previous(std::uint32_t set, std::uint32_t last) {
    const std::uint32_t rest = set & ~bit(last);
    if (rest == 0) return none;
    std::uint32_t best = none;
    double least = infinity;
    for (std::uint32_t place = 1; place <= count_; ++place) {
      if ((rest & bit(place)) == 0) continue;
      const double cost = of(rest, place) + costs_.at(place, last);
      if (cost < least) {
        least = cost;
        best = place;
      }
    }
    return best;
  }

  const TourCosts& costs_;
  const TourEnds& ends_;
  std::size_t count_;
  std::vector<double> cost_;
};

}  // namespace

double cost_of(const TourCosts& costs, std::span<const std::uint32_t> order) noexcept {
  double sum = 0;
  std::uint32_t at = 0;
  for (const std::uint32_t place : order) {
    sum += costs.at(at, place);
    at = place;
  }
  return sum;
}

TourOrder exact_order(const TourCosts& costs, const TourEnds& ends) {
  if (costs.places < 2) return {.order = {}, .cost = 0, .optimal = true};
  return SetTable(costs, ends).order();
}

TourOrder shortest_order(const TourCosts& costs, const TourEnds& ends) {
  if (costs.places <= most_exact_places + 1) return exact_order(costs, ends);
  return improve_order(costs, ends);
}

}  // namespace docent::path
