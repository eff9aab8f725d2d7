#include "runtime/path/tour/improve_order.h"

#include <algorithm>
#include <random>
#include <tuple>
#include <utility>

namespace docent::path {
namespace {

constexpr double least_gain = 1e-6;      // of costs: less is rounding
constexpr std::size_t longest_part = 8;  // that is moved; longer ones hardly ever pay
constexpr std::size_t longest_kick = 12;

/// An order as a path from the beginning to an end that costs nothing to reach, so that both ends
/// of the path stay where they are and fixed places are a matter of costs alone.
class Path {
 public:
  Path(const TourCosts& costs, const TourEnds& ends) : count_(costs.places + 1) {
    cost_.resize(count_ * count_, TourCosts::most);
    for (std::size_t a = 0; a + 1 < count_; ++a) {
      for (std::size_t b = 1; b + 1 < count_; ++b)
        cost_[a * count_ + b] = std::min(costs.at(a, b), TourCosts::most);
      if (!ends.last || *ends.last == a) cost_[a * count_ + count_ - 1] = 0;
    }
    if (ends.first)
      for (std::size_t b = 1; b + 1 < count_; ++b)
        if (b != *ends.first) cost_[b] = TourCosts::most;
    begin_with(costs, ends);
  }

  /// Improves what lies about the places that are waiting until nothing gets better.
  void mend() {
    while (!waiting_.empty()) {
      const std::uint32_t place = waiting_.back();
      waiting_.pop_back();
      is_waiting_[place] = false;
      while (turn_about(position_[place]) || move_from(position_[place])) {
      }
    }
  }

  void kick(std::mt19937& random) {
    const std::size_t inner = count_ - 2;
    const auto below = [&](std::size_t limit) { return random() % limit; };
    const std::size_t most = std::min(longest_kick, inner / 2);
    const std::size_t first = 1 + below(most), second = 1 + below(most);
    const std::size_t at = 1 + below(inner - first - second + 1);
    std::rotate(path_.begin() + static_cast<std::ptrdiff_t>(at),
                path_.begin() + static_cast<std::ptrdiff_t>(at + first),
                path_.begin() + static_cast<std::ptrdiff_t>(at + first + second));
    note();
    for (const std::size_t p :
         {at - 1, at, at + second - 1, at + second, at + second + first - 1, at + second + first})
      wake(p);
  }

  double length() const noexcept { return forward_.back(); }
  std::size_t inner() const noexcept { return count_ - 2; }
  const std::vector<std::uint32_t>& path() const noexcept { return path_; }
  void go_back_to(const std::vector<std::uint32_t>& path) {
    path_ = path;
    note();
  }

 private:
  double at(std::uint32_t a, std::uint32_t b) const noexcept { return cost_[a * count_ + b]; }
  /// Between the places at two positions of the path.
  double step(std::size_t a, std::size_t b) const noexcept { return at(path_[a], path_[b]); }

  /// Places from which more can be reached come first, so that no way back is needed; of those that
  /// are alike the nearest to the place before.
  void begin_with(const TourCosts& costs, const TourEnds& ends) {
    std::vector<std::pair<std::size_t, std::uint32_t>> rest;
    for (std::uint32_t a = 1; a < costs.places; ++a) {
      std::size_t unreached = 0;
      for (std::size_t b = 1; b < costs.places; ++b)
        if (b != a && costs.at(a, b) == infinity) ++unreached;
      if (ends.first && *ends.first == a) unreached = 0;
      if (ends.last && *ends.last == a) unreached = costs.places + 1;
      rest.emplace_back(unreached, a);
    }
    path_ = {0};
    while (!rest.empty()) {
      const auto next = std::ranges::min_element(rest, {}, [&](const auto& one) {
        return std::tuple(one.first, at(path_.back(), one.second), one.second);
      });
      path_.push_back(next->second);
      rest.erase(next);
    }
    path_.push_back(static_cast<std::uint32_t>(count_ - 1));
    position_.resize(count_);
    forward_.resize(count_);
    backward_.resize(count_);
    is_waiting_.assign(count_, false);
    note();
    for (std::size_t p = count_ - 1; p-- > 1;) wake(p);
  }

  void note() {
    for (std::size_t p = 0; p < count_; ++p) position_[path_[p]] = p;
    for (std::size_t p = 1; p < count_; ++p) {
      forward_[p] = forward_[p - 1] + step(p - 1, p);
      backward_[p] = backward_[p - 1] + step(p, p - 1);
    }
  }

  void wake(std::size_t position) {
    const std::uint32_t place = path_[position];
    if (position == 0 || position + 1 >= count_ || is_waiting_[place]) return;
    is_waiting_[place] = true;
    waiting_.push_back(place);
  }
  void wake_between(std::size_t first, std::size_t last) {
    for (const std::size_t p : {first - 1, first, last, last + 1}) wake(p);
  }

  /// What the part [i, j] costs, walked from i to j or from j to i.
  double along(std::size_t i, std::size_t j) const noexcept { return forward_[j] - forward_[i]; }
  double back_along(std::size_t i, std::size_t j) const noexcept {
    return backward_[j] - backward_[i];
  }

  /// Turns the part round that begins or ends here, if that pays.
  bool turn_about(std::size_t here) {
    for (std::size_t other = 1; other + 1 < count_; ++other) {
      const auto [i, j] = std::minmax(here, other);
      if (i == j) continue;
      const double gain = step(i - 1, i) + along(i, j) + step(j, j + 1) - step(i - 1, j) -
                          back_along(i, j) - step(i, j + 1);
      if (gain < least_gain) continue;
      std::reverse(path_.begin() + static_cast<std::ptrdiff_t>(i),
                   path_.begin() + static_cast<std::ptrdiff_t>(j + 1));
      note();
      wake_between(i, j);
      return true;
    }
    return false;
  }

  /// Moves a part that begins here between two others, if that pays.
  bool move_from(std::size_t i) {
    const std::size_t end = std::min(i + longest_part, count_ - 1);
    for (std::size_t j = i; j < end; ++j) {
      const double out = step(i - 1, i) + step(j, j + 1) - step(i - 1, j + 1);
      const double turned = back_along(i, j) - along(i, j);
      for (std::size_t k = 0; k + 1 < count_; ++k) {  // between k and k + 1
        if (k + 1 >= i && k <= j) continue;
        const double room = out + step(k, k + 1);
        const bool straight = room - step(k, i) - step(j, k + 1) > least_gain;
        if (!straight && room - step(k, j) - step(i, k + 1) - turned <= least_gain) continue;
        move({i, j, k}, !straight);
        return true;
      }
    }
    return false;
  }

  struct Move {
    std::size_t i, j, k;  ///< The part, and the position after which it goes.
  };
  void move(const Move& move, bool turned) {
    const auto [i, j, k] = move;
    const auto place = [&](std::size_t p) {
      return path_.begin() + static_cast<std::ptrdiff_t>(p);
    };
    if (turned) std::reverse(place(i), place(j + 1));
    if (k > j)
      std::rotate(place(i), place(j + 1), place(k + 1));
    else
      std::rotate(place(k + 1), place(i), place(j + 1));
    note();
    const std::size_t length = j - i + 1;
    const std::size_t from = k > j ? k - length + 1 : k + 1;
    wake_between(from, from + length - 1);
    wake(k > j ? i - 1 : j);
    wake(k > j ? i : std::min(j + 1, count_ - 1));
  }

  std::size_t count_;
  std::vector<double> cost_;  ///< By place; the last is the end.
  std::vector<std::uint32_t> path_;
  std::vector<std::size_t> position_;       ///< Per place, in the path.
  std::vector<double> forward_, backward_;  ///< Per position: along the path up to there, and back.
  std::vector<std::uint32_t> waiting_;
  std::vector<bool> is_waiting_;
};

}  // namespace

TourOrder improve_order(const TourCosts& costs, const TourEnds& ends, std::size_t kicks) {
  if (costs.places < 2) return {.order = {}, .cost = 0};
  Path path(costs, ends);
  path.mend();
  std::vector<std::uint32_t> best = path.path();
  double least = path.length();
  std::mt19937 random(1);  // NOLINT: the same order every time
  for (std::size_t kick = 0; kick < kicks && path.inner() >= 3; ++kick) {
    path.kick(random);
    path.mend();
    if (path.length() > least) {
      path.go_back_to(best);
      continue;
    }
    best = path.path();
    least = path.length();
  }
  TourOrder found{.order = {best.begin() + 1, best.end() - 1}};
  found.cost = least < TourCosts::most ? cost_of(costs, found.order) : infinity;
  if (found.cost == infinity) found.order.clear();
  return found;
}

}  // namespace docent::path
