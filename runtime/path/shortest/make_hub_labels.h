#pragma once

#include <cstddef>
#include <stop_token>

#include "runtime/model/geometry/floor_plan.h"
#include "runtime/model/geometry/hub_labels.h"
#include "runtime/model/geometry/tangent_graph.h"

namespace docent::path {

/// The labels of a plan's tangent graph. Takes some seconds for floors of ten thousand corners: the
/// content compiler does it for the museum's radius classes, a thread of the kiosk for any other
/// radius. There are none (has_labels is false) where they would have more than `most_entries`
/// entries (16 bytes each in the database), nor where a stop is requested.
HubLabels make_hub_labels(const FloorPlan& plan, const TangentGraph& graph,
                          const std::stop_token& stop = {}, std::size_t most_entries = 11'000'000);

/// What came of making them.
struct MadeLabels {
  HubLabels labels;
  /// They would be so many more than allowed that those of other radii on this floor would be too
  /// many as well: the same corners see each other.
  bool far_too_many = false;
};
MadeLabels try_hub_labels(const FloorPlan& plan, const TangentGraph& graph,
                          const std::stop_token& stop, std::size_t most_entries);

}  // namespace docent::path
