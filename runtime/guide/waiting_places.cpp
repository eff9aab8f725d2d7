#include "runtime/guide/waiting_places.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace docent::guide {
namespace {

constexpr double farthest = 10, step = 0.3;          // metres from the kiosk, between candidates
constexpr double arms_length = 0.4;                  // metres between two bodies
constexpr double least_back = 0.1, most_back = 0.5;  // metres of air behind a body
constexpr double ahead = 0.6;                        // metres before a body where others can pass

struct Candidate {
  Placement place;
  double cost = 0;  ///< Metres from the kiosk.
};

/// Who stands there looks into the room, the wall behind; nothing where there is no such wall, as
/// in a doorway, or no such room, as in a corridor.
std::optional<double> heading_at(const path::FloorMap& map, Vec2 at, double radius) noexcept {
  constexpr int directions = 16;
  const double here = path::clearance_at(map, at);
  double widest = 0, heading = 0;
  for (int i = 0; i < directions; ++i) {
    const double angle = 2 * std::numbers::pi * i / directions;
    const Vec2 before = at + ahead * Vec2{std::cos(angle), std::sin(angle)};
    const double clearance = path::is_inside(map, before) ? path::clearance_at(map, before) : 0;
    if (clearance <= widest) continue;
    widest = clearance;
    heading = angle;
  }
  const Vec2 back = at - 0.5 * radius * Vec2{std::cos(heading), std::sin(heading)};
  const bool wall_behind = path::clearance_at(map, back) < here - 0.25 * radius;
  if (!wall_behind || widest < here + 0.75 * ahead) return std::nullopt;
  return heading;
}

}  // namespace

std::vector<Placement> waiting_places(const path::FloorMap& map, const Placement& kiosk,
                                      std::size_t count, double radius,
                                      std::span<const Vec2> keep_clear) {
  std::vector<Candidate> candidates;
  const auto steps = static_cast<int>(farthest / step);
  for (int i = -steps; i <= steps; ++i)
    for (int j = -steps; j <= steps; ++j) {
      const Vec2 at = kiosk.position + step * Vec2{i, j};
      const double cost = glm::distance(at, kiosk.position);
      const double clearance = path::clearance_at(map, at);
      if (cost > farthest || !path::is_inside(map, at) || clearance < radius + least_back ||
          clearance > radius + most_back || !path::can_see(map, kiosk.position, at))
        continue;
      if (const auto heading = heading_at(map, at, radius))
        candidates.push_back({{at, *heading}, cost});
    }
  std::ranges::stable_sort(candidates, {}, &Candidate::cost);

  const double apart = 2 * radius + arms_length;
  std::vector<Placement> places{kiosk};
  for (const Candidate& candidate : candidates) {
    if (places.size() >= count) break;
    const auto is_near = [&](Vec2 other) {
      return glm::distance(other, candidate.place.position) < apart;
    };
    if (std::ranges::any_of(places, is_near, &Placement::position) ||
        std::ranges::any_of(keep_clear, is_near))
      continue;
    places.push_back(candidate.place);
  }
  return places;
}

}  // namespace docent::guide
