#include "runtime/path/shortest/radius_maps.h"

#include <algorithm>
#include <utility>

#include "runtime/model/last_catch.h"
#include "runtime/path/shortest/make_hub_labels.h"
#include "runtime/path/shortest/make_tangent_graph.h"

namespace docent::path {
namespace {

/// Without arcs there is nothing to have labels for.
bool can_meet(const TangentGraph& graph, const HubLabels& labels) noexcept {
  return labels.has_labels() || graph.arc.empty();
}

}  // namespace

RadiusMaps::Owned::Owned(const Floor& floor, const TangentSearchMap& search, double radius,
                         const std::stop_token& stop)
    : graph(make_tangent_graph(floor.plan, floor.sight, radius)),
      labels(make_hub_labels(floor.plan, graph, stop)),
      map(floor.plan, floor.sight, graph, labels, search) {}

RadiusMaps::RadiusMaps(const Floor& floor, const TangentSearchMap& search)
    : floor_(floor), search_(search) {
  for (std::size_t i = 0; i < floor.tangent_graphs.size(); ++i) {
    const TangentGraph& graph = floor.tangent_graphs[i];
    const HubLabels& labels = floor.hub_labels[i];
    precomputed_.push_back({graph.radius, nullptr});
    if (!can_meet(graph, labels)) continue;
    of_classes_.push_back(
        std::make_unique<const ShortestWayMap>(floor.plan, floor.sight, graph, labels, search));
    precomputed_.back().map = {std::shared_ptr<const void>{}, of_classes_.back().get()};
  }
}

std::shared_ptr<const ShortestWayMap> RadiusMaps::find(double radius) const {
  if (const auto known = std::ranges::find(precomputed_, radius, &Known::radius);
      known != precomputed_.end())
    return known->map;
  const std::scoped_lock lock(mutex_);
  if (const auto known = std::ranges::find(made_, radius, &Known::radius); known != made_.end())
    return known->map;
  wanted_ = radius;
  asked_.notify_one();
  if (!thread_.joinable())
    thread_ = std::jthread([this](const std::stop_token& stop) { make_wanted(stop); });
  return {};
}

void RadiusMaps::make_wanted(const std::stop_token& stop) const {
  std::unique_lock lock(mutex_);
  while (asked_.wait(lock, stop, [&] { return wanted_.has_value(); })) {
    const double radius = *wanted_;
    lock.unlock();
    Known made{radius, nullptr};
    guarded("preparing ways of another radius", [&] {  // without, each is searched for
      if (const auto owned = std::make_shared<const Owned>(floor_, search_, radius, stop);
          can_meet(owned->graph, owned->labels))
        made.map = {owned, &owned->map};
    });
    lock.lock();
    if (stop.stop_requested()) return;
    if (made_.size() == kept_radii) made_.erase(made_.begin());
    made_.push_back(std::move(made));
    if (wanted_ == radius) wanted_.reset();
  }
}

}  // namespace docent::path
