#include "runtime/path/tour/best_tour.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

#include "runtime/path/tour/improve_choice.h"

namespace docent::path {
namespace {

constexpr double weight_rounding = 1e-9;  // relative

/// A beginning of a tour: what it has visited, and where it is.
struct Beginning {
  std::uint64_t visited = 0;  ///< A bit for each place, from place 1.
  std::uint32_t last = 0;
  std::uint32_t before = none;  ///< Index of the beginning that it goes on from.
  double seconds = 0, weight = 0;
  double most = 0;  ///< What a tour that begins so may weigh.
};

std::uint64_t bit(std::size_t place) noexcept {
  return std::uint64_t{1} << (place - 1);
}

class Search {
 public:
  Search(const TourCosts& costs, std::span<const TourStop> stops, double seconds)
      : costs_(costs), stops_(stops), limit_(seconds) {
    find_least_seconds();
    for (std::uint32_t place = 1; place < costs.places; ++place)
      if (stops[place].weight > 0 && least_[place] <= seconds) worthy_.push_back(place);
    find_unit();
    std::ranges::stable_sort(worthy_, std::greater<>(), [&](std::uint32_t place) {
      return stops_[place].weight / std::max(least_[place], 1e-9);
    });
  }

  BestTour run(std::size_t beginnings) {
    all_.push_back({.most = most_weight({})});
    best_ = all_.front();
    BestTour found;
    found.most_weight = all_.front().most;
    double dropped = 0;
    for (std::size_t first = 0; first < all_.size();) {
      const std::size_t end = all_.size();
      std::vector<Beginning> next = grown(first, end);
      dropped = std::max(dropped, keep_promising(next, beginnings));
      all_.insert(all_.end(), next.begin(), next.end());
      first = end;
    }
    take_order(found);
    found.optimal = !outweighs(dropped, found.weight);
    found.most_weight = std::max(found.weight, std::min(dropped, found.most_weight));
    return found;
  }

 private:
  bool outweighs(double a, double b) const noexcept { return a > b + weight_rounding * (1 + b); }

  /// The least that a place takes: the nearest way there, and looking.
  void find_least_seconds() {
    least_.assign(costs_.places, infinity);
    for (std::size_t to = 1; to < costs_.places; ++to) {
      for (std::size_t from = 0; from < costs_.places; ++from)
        if (from != to) least_[to] = std::min(least_[to], costs_.at(from, to));
      least_[to] += stops_[to].looking_seconds;
    }
  }

  /// Where all weights are whole multiples of the least one, so is every tour's.
  void find_unit() {
    double least = infinity;
    for (const std::uint32_t place : worthy_) least = std::min(least, stops_[place].weight);
    const bool are_multiples = std::ranges::all_of(worthy_, [&](std::uint32_t place) {
      return std::remainder(stops_[place].weight, least) == 0;
    });
    unit_ = are_multiples && least < infinity ? least : 0;
  }
  double whole(double weight) const noexcept {
    return unit_ > 0 ? unit_ * std::floor(weight / unit_ + weight_rounding) : weight;
  }

  /// No tour that begins so weighs more: the rest of the time is filled with the places that weigh
  /// most for the least that they take, the last one in part.
  double most_weight(const Beginning& beginning) const noexcept {
    double left = limit_ - beginning.seconds, weight = beginning.weight;
    for (const std::uint32_t place : worthy_) {
      if ((beginning.visited & bit(place)) != 0) continue;
      if (least_[place] > left) return whole(weight + stops_[place].weight * left / least_[place]);
      left -= least_[place];
      weight += stops_[place].weight;
    }
    return weight;
  }

  bool is_better(const Beginning& a, const Beginning& b) const noexcept {
    return outweighs(a.weight, b.weight) ||
           (!outweighs(b.weight, a.weight) && a.seconds < b.seconds);
  }

  /// All that go on by one stop from those of [first, end): the earliest of those that are alike.
  std::vector<Beginning> grown(std::size_t first, std::size_t end) {
    std::vector<Beginning> next;
    std::unordered_map<std::uint64_t, std::uint32_t> alike;  // by places visited, first of a chain
    std::vector<std::uint32_t> chain;
    for (std::size_t i = first; i < end; ++i)
      for (const std::uint32_t place : worthy_) {
        const Beginning& from = all_[i];
        if ((from.visited & bit(place)) != 0) continue;
        Beginning one{
            .visited = from.visited | bit(place),
            .last = place,
            .before = static_cast<std::uint32_t>(i),
            .seconds = from.seconds + (costs_.at(from.last, place) + stops_[place].looking_seconds),
            .weight = from.weight + stops_[place].weight};
        if (one.seconds > limit_) continue;
        one.most = most_weight(one);
        if (is_better(one, best_)) best_ = one;
        std::uint32_t& head = alike.try_emplace(one.visited, none).first->second;
        std::uint32_t known = head;
        while (known != none && next[known].last != place) known = chain[known];
        if (known == none) {
          chain.push_back(head);
          head = static_cast<std::uint32_t>(next.size());
          next.push_back(one);
        } else if (one.seconds < next[known].seconds) {
          next[known] = one;
        }
      }
    return next;
  }

  /// Drops what cannot outweigh the best, and what is too many. Returns what those that were too
  /// many might have come to weigh.
  double keep_promising(std::vector<Beginning>& next, std::size_t beginnings) const {
    std::erase_if(next, [&](const Beginning& one) { return !outweighs(one.most, best_.weight); });
    if (next.size() <= beginnings || worthy_.size() <= most_exact_choices) return 0;
    std::ranges::stable_sort(next, std::greater<>(), &Beginning::most);
    double dropped = 0;
    for (std::size_t i = beginnings; i < next.size(); ++i)
      dropped = std::max(dropped, next[i].most);
    next.resize(beginnings);
    return dropped;
  }

  /// The best tour's places, and what else fits when they are improved.
  void take_order(BestTour& found) const {
    for (const Beginning* at = &best_; at->before != none; at = &all_[at->before])
      found.order.push_back(at->last);
    std::ranges::reverse(found.order);
    found.seconds = best_.seconds;
    found.weight = best_.weight;
    const std::vector<std::uint32_t> better = improve_choice(costs_, stops_, limit_, found.order);
    double weight = 0;
    for (const std::uint32_t place : better) weight += stops_[place].weight;
    const double seconds = seconds_of(better);
    const bool is_shorter = !outweighs(best_.weight, weight) && seconds < best_.seconds;
    if (seconds > limit_ || (!is_shorter && !outweighs(weight, best_.weight))) return;
    found.order = better;
    found.seconds = seconds;
    found.weight = weight;
  }

  /// Summed up as a beginning's time is, so that weight_rounding makes nobody late.
  double seconds_of(std::span<const std::uint32_t> order) const noexcept {
    double seconds = 0;
    std::uint32_t at = 0;
    for (const std::uint32_t place : order) {
      seconds += costs_.at(at, place) + stops_[place].looking_seconds;
      at = place;
    }
    return seconds;
  }

  const TourCosts& costs_;
  std::span<const TourStop> stops_;
  double limit_;
  double unit_ = 0;                    ///< Of weights; 0 where they have none.
  std::vector<double> least_;          ///< Per place.
  std::vector<std::uint32_t> worthy_;  ///< What weighs most for its least time first.
  std::vector<Beginning> all_;         ///< Those that went on, by their number of stops.
  Beginning best_;
};

}  // namespace

BestTour best_tour_within(const TourCosts& costs, std::span<const TourStop> stops, double seconds,
                          std::size_t beginnings) {
  if (costs.places < 2 || !(seconds >= 0)) {
    BestTour nothing;
    nothing.optimal = true;
    return nothing;
  }
  return Search(costs, stops, seconds).run(beginnings);
}

}  // namespace docent::path
