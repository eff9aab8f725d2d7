#include "runtime/path/building/nearest_place.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace docent::path {
namespace {

struct Candidate {
  std::uint32_t place = 0;
  double bound = 0;  ///< No way there costs less.
};

/// How much an answer says: a way, what closes it, that it has steps, nothing.
int worth(BuildingStatus status) noexcept {
  switch (status) {
    case BuildingStatus::Ok:
      return 4;
    case BuildingStatus::Closed:
      return 3;
    case BuildingStatus::NoStepFree:
      return 2;
    case BuildingStatus::StartBlocked:
    case BuildingStatus::GoalBlocked:
      return 1;
    case BuildingStatus::NoRoute:
      break;
  }
  return 0;
}

}  // namespace

NearestPlace nearest_place(const BuildingMap& building, const BuildingQuery& query,
                           std::span<const Place> places, PlaceKind kind) {
  BuildingQuery asked = query;
  asked.metric = query.metric.value_or(Metric::Time);
  const auto cost = [&](const BuildingWay& way) {
    return *asked.metric == Metric::Time ? way.seconds : way.length;
  };
  // A straight line bounds ways along the floor. Of other floors nothing is known.
  const double pace = *asked.metric == Metric::Time ? strolling_pace : 1;
  std::vector<Candidate> candidates;
  for (std::uint32_t i = 0; i < places.size(); ++i)
    if (answers(places[i].kind, kind))
      candidates.push_back({i, places[i].floor == query.from_floor
                                   ? glm::distance(query.way.from, places[i].standing) / pace
                                   : 0});
  std::ranges::stable_sort(candidates, {}, &Candidate::bound);

  NearestPlace nearest;
  for (const Candidate& candidate : candidates) {
    const bool is_found = nearest.place != none && nearest.way.status == BuildingStatus::Ok;
    if (is_found && candidate.bound > cost(nearest.way)) continue;
    asked.to_floor = places[candidate.place].floor;
    asked.way.to = places[candidate.place].standing;
    BuildingWay way = building.route(asked);
    const bool is_nearer = is_found && way.status == BuildingStatus::Ok &&
                           (cost(way) < cost(nearest.way) ||
                            (cost(way) == cost(nearest.way) && candidate.place < nearest.place));
    if (nearest.place != none && !is_nearer && worth(way.status) <= worth(nearest.way.status))
      continue;
    nearest = {candidate.place, std::move(way)};
  }
  return nearest;
}

}  // namespace docent::path
