#include "runtime/path/shortest/landmarks.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "runtime/model/none.h"

namespace docent::path {
namespace {

std::vector<double> distances_from(const FloorPlan& plan, const SightMap& sight,
                                   std::uint32_t landmark) {
  const auto position = [&](std::uint32_t corner) { return plan.vertex[sight.corner[corner]]; };
  std::vector<double> distance(sight.corner.size(), infinity);
  std::vector<std::pair<double, std::uint32_t>> queue{{0, landmark}};
  distance[landmark] = 0;
  while (!queue.empty()) {
    std::ranges::pop_heap(queue, std::greater<>{});
    const auto [length, at] = queue.back();
    queue.pop_back();
    if (length > distance[at]) continue;
    for (std::uint32_t i = sight.pair_first[at]; i < sight.pair_first[at + 1]; ++i) {
      const std::uint32_t seen = sight.pair_other[i];
      const double further = length + glm::distance(position(at), position(seen));
      if (further >= distance[seen]) continue;
      distance[seen] = further;
      queue.emplace_back(further, seen);
      std::ranges::push_heap(queue, std::greater<>{});
    }
  }
  return distance;
}

}  // namespace

Landmarks::Landmarks(const FloorPlan& plan, const SightMap& sight)
    : distance_(sight.corner.size()) {
  if (distance_.empty()) return;
  // Each landmark is the corner farthest from those before it, and of a part of the floor that has
  // none yet before all others.
  std::vector<std::vector<double>> all;
  std::vector<double> nearest = distances_from(plan, sight, 0);
  for (std::size_t i = 0; i < count; ++i) {
    const auto farthest = std::ranges::max_element(nearest);
    all.push_back(
        distances_from(plan, sight, static_cast<std::uint32_t>(farthest - nearest.begin())));
    for (std::size_t c = 0; c < nearest.size(); ++c)
      nearest[c] = i == 0 ? all[0][c] : std::min(nearest[c], all[i][c]);
  }
  double longest = 0;
  for (const auto& from : all)
    for (const double distance : from)
      if (distance < infinity) longest = std::max(longest, distance);
  if (longest > 0) metres_per_step_ = longest / most;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t c = 0; c < distance_.size(); ++c)
      if (all[i][c] < infinity)
        distance_[c][i / lanes][i % lanes] =
            static_cast<std::int16_t>(std::lround(all[i][c] / metres_per_step_));
}

}  // namespace docent::path
