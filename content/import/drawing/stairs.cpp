#include "content/import/drawing/stairs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "content/import/drawing/segment_grid.h"

namespace docent::import {
namespace {

constexpr double narrowest_flight = 0.6, widest_flight = 5;     ///< Metres, of a flight.
constexpr double shallowest_tread = 0.2, deepest_tread = 0.42;  ///< Metres, of a tread.
constexpr double unlike_treads = 0.12;    ///< Treads of one flight differ by less of their depth.
constexpr std::size_t fewest_treads = 5;  ///< Lines.
constexpr std::size_t most_treads = 60;   ///< Lines: more are a hatch or a floor's boards.

class Flights {
 public:
  explicit Flights(std::span<const WallLine> lines) : lines_(lines), taken_(lines.size(), false) {
    for (std::uint32_t i = 0; i < lines.size(); ++i)
      if (could_be_tread(i)) grid_.add(i, middle(i), middle(i));
  }

  std::vector<Flight> find() {
    std::vector<Flight> flights;
    for (std::uint32_t i = 0; i < lines_.size(); ++i) {
      if (taken_[i] || !could_be_tread(i)) continue;
      std::vector<std::uint32_t> chain = chain_from(i);
      if (chain.size() < fewest_treads || chain.size() > most_treads) continue;
      for (const std::uint32_t tread : chain) taken_[tread] = true;
      const Vec2 begin = middle(chain.front()), end = middle(chain.back());
      flights.push_back({std::move(chain), begin, end, length(i)});
    }
    return flights;
  }

 private:
  Vec2 middle(std::uint32_t i) const { return 0.5 * (lines_[i].a + lines_[i].b); }
  double length(std::uint32_t i) const { return glm::length(lines_[i].b - lines_[i].a); }
  Vec2 along(std::uint32_t i) const { return (lines_[i].b - lines_[i].a) / length(i); }
  bool could_be_tread(std::uint32_t i) const {
    return length(i) > narrowest_flight && length(i) < widest_flight;
  }

  /// The next line like `i` in that direction across, if it is a tread away, and how far it is.
  std::optional<std::pair<std::uint32_t, double>> next(std::uint32_t i, Vec2 across) const {
    const Vec2 at = middle(i), run = along(i);
    const double own = length(i);
    std::optional<std::pair<std::uint32_t, double>> best;
    double nearest = std::numeric_limits<double>::max();
    const Vec2 ahead = at + shallowest_tread * across;
    grid_.near(ahead, ahead, deepest_tread, [&](std::uint32_t j) {
      if (j == i || taken_[j]) return;
      const double away = dot(middle(j) - at, across);
      if (away < 0.02 || away > deepest_tread) return;
      if (std::abs(cross(run, along(j))) > 0.02 || std::abs(length(j) - own) > 0.1 * own ||
          std::abs(dot(middle(j) - at, run)) > 0.1 * own || away >= nearest)
        return;
      nearest = away;
      best = std::pair{j, away};
    });
    // Boards and hatches have lines between.
    if (nearest < shallowest_tread) best.reset();
    return best;
  }

  /// All treads of the flight on which `i` lies.
  std::vector<std::uint32_t> chain_from(std::uint32_t i) const {
    const Vec2 across = left_of(along(i));
    std::vector<std::uint32_t> chain{i};
    double depth = 0;
    const auto extend = [&](Vec2 direction) {
      while (chain.size() <= most_treads) {
        const auto found = next(chain.back(), direction);
        if (!found || std::ranges::find(chain, found->first) != chain.end()) return;
        if (depth > 0 && std::abs(found->second - depth) > unlike_treads * depth) return;
        depth = depth > 0 ? depth : found->second;
        chain.push_back(found->first);
      }
    };
    extend(across);
    std::ranges::reverse(chain);
    extend(-across);
    return chain;
  }

  std::span<const WallLine> lines_;
  std::vector<bool> taken_;
  SegmentGrid grid_{1};
};

}  // namespace

std::vector<Flight> find_flights(std::span<const WallLine> lines) {
  return Flights(lines).find();
}

}  // namespace docent::import
