#include "runtime/guide/strollers.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "runtime/scene/look.h"

namespace docent::guide {
namespace {

constexpr double slowest = 0.7;      // share of the clips' pace
constexpr double taken = 0.9;        // metres about a place that somebody else holds or goes to
constexpr double aimless = 0.2;      // share of the ways that lead just somewhere
constexpr double other_floor = 0.3;  // share of the exhibits on other floors that tempt somebody
constexpr int most_tries = 12;
constexpr std::size_t most_at_times = 4;      // of a museum that has none, ...
constexpr std::size_t exhibits_for_each = 3;  // ... and what each of them needs to look at

}  // namespace

/// SplitMix64 (Steele, Lea, Flood 2014), as a number in [0, 1).
double Strollers::random(Stroller& stroller) const noexcept {
  stroller.chance += 0x9e3779b97f4a7c15U;
  std::uint64_t z = stroller.chance;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1.0p-53;
}

Placement Strollers::start_of(std::size_t i) const noexcept {
  // At an entrance the next one waits until the one before has gone on.
  const std::vector<Vec2>& entrances = museum_.ambient.entrances;
  if (!entrances.empty()) return {entrances[i % entrances.size()], 0};
  const auto on_floor = [this](const Exhibit& e) { return e.floor == museum_.kiosk_floor; };
  const auto count = static_cast<std::size_t>(std::ranges::count_if(museum_.exhibits, on_floor));
  if (count == 0) return museum_.kiosk;
  // Spread over the exhibits; who comes when all are taken waits for room.
  std::size_t skip = (i * 7 + 3) % count;
  for (const Exhibit& exhibit : museum_.exhibits)
    if (on_floor(exhibit) && skip-- == 0) return exhibit.viewing_point;
  return museum_.kiosk;
}

std::size_t Strollers::most(const Museum& museum) noexcept {
  if (museum.ambient.count > 0) return museum.ambient.count;
  return std::min(most_at_times, museum.exhibits.size() / exhibits_for_each);
}

void Strollers::enter(Crowd& crowd) {
  const std::size_t count = std::min(most(museum_), crowd.room());
  for (std::size_t i = 0; i < count; ++i) {
    Stroller stroller;
    stroller.chance = 1000003 * (i + 1);
    const double pace = slowest + (1 - slowest) * random(stroller);
    const bool comes_in = !museum_.ambient.entrances.empty();
    stroller.who = crowd.add(museum_.kiosk_floor, start_of(i), 0, pace);
    crowd.set_look(stroller.who,
                   static_cast<std::uint32_t>(scene::guide_look_count +
                                              i % (scene::looks.size() - scene::guide_look_count)));
    stroller.goes_on_at = comes_in ? 0 : museum_.ambient.look_most * random(stroller);
    strollers_.push_back(stroller);
  }
  leave(crowd);
}

void Strollers::come(Crowd& crowd) const noexcept {
  if (museum_.ambient.count > 0) return;
  for (std::size_t i = 0; i < strollers_.size(); ++i)
    crowd.appear(strollers_[i].who, museum_.kiosk_floor, start_of(i));
}

void Strollers::leave(Crowd& crowd) const noexcept {
  if (museum_.ambient.count > 0) return;
  for (const Stroller& stroller : strollers_) crowd.leave(stroller.who);
}

void Strollers::step(Crowd& crowd) noexcept {
  for (Stroller& stroller : strollers_) {
    const Agent& one = crowd[stroller.who];
    if (!one.is_here || (one.goal && !one.has_arrived)) {
      stroller.looks = false;
      continue;
    }
    if (!stroller.looks) {
      stroller.looks = true;
      stroller.goes_on_at = crowd.clock() + std::lerp(museum_.ambient.look_least,
                                                      museum_.ambient.look_most, random(stroller));
    }
    if (crowd.clock() >= stroller.goes_on_at) choose(stroller, crowd);
  }
}

/// Now and then to another floor, where there is a way up or down at all; not so many at a time
/// that they would stand in a queue at the lift.
bool Strollers::may_go_to(std::uint32_t floor, const Agent& one, const Crowd& crowd,
                          Stroller& stroller) const noexcept {
  if (floor == one.avatar.floor) return true;
  const auto changes_floors = [](const Agent& other) {
    return other.goal && !other.has_arrived && other.goal_floor != other.avatar.floor;
  };
  const auto on_their_way =
      static_cast<std::size_t>(std::ranges::count_if(crowd.members(), changes_floors));
  return 2 * on_their_way < museum_.connections.size() && random(stroller) < other_floor;
}

/// Where to next: to an exhibit that nobody else is at or goes to, or somewhere on the medial axis.
void Strollers::choose(Stroller& stroller, Crowd& crowd) const noexcept {
  const std::uint32_t floor = crowd[stroller.who].avatar.floor;
  const auto is_taken = [&](std::uint32_t on, Vec2 place) {
    return std::ranges::any_of(crowd.members(), [&](const Agent& other) {
      if (&other == &crowd[stroller.who] || !other.is_here) return false;
      return (other.avatar.floor == on &&
              glm::distance(other.avatar.body.position, place) < taken) ||
             (other.goal && other.goal_floor == on &&
              glm::distance(other.goal->position, place) < taken);
    });
  };
  const Roadmap& roads = museum_.floors[floor].roadmap;
  for (int i = 0; i < most_tries; ++i) {
    const RouteKind kind =
        route_kinds[static_cast<std::size_t>(random(stroller) *
                                             static_cast<double>(route_kinds.size()))]
            .kind;
    if (random(stroller) < aimless && !roads.position.empty()) {
      const auto node =
          static_cast<std::size_t>(random(stroller) * static_cast<double>(roads.position.size()));
      const double heading = 2 * std::numbers::pi * (random(stroller) - 0.5);
      if (roads.clearance[node] < 2 * museum_.body_radius || is_taken(floor, roads.position[node]))
        continue;
      return crowd.send(stroller.who, floor, {roads.position[node], heading}, RouteKind::Skeleton);
    }
    if (museum_.exhibits.empty()) continue;
    const auto chosen =
        static_cast<std::uint32_t>(random(stroller) * static_cast<double>(museum_.exhibits.size()));
    const Exhibit& exhibit = museum_.exhibits[chosen];
    if (!may_go_to(exhibit.floor, crowd[stroller.who], crowd, stroller) ||
        is_taken(exhibit.floor, exhibit.viewing_point.position))
      continue;
    return crowd.send(stroller.who, exhibit.floor, exhibit.viewing_point, kind, {}, chosen);
  }
  stroller.looks = false;  // everything is taken: it looks on
}

}  // namespace docent::guide
