#pragma once

#include <vector>

#include "runtime/model/geometry/floor_plan.h"
#include "runtime/model/geometry/hub_labels.h"
#include "runtime/model/geometry/roadmap.h"
#include "runtime/model/geometry/sight_map.h"
#include "runtime/model/geometry/tangent_graph.h"
#include "runtime/model/geometry/voronoi_diagram.h"
#include "runtime/model/local_text.h"

namespace docent {

/// One floor as the database holds it.
struct Floor {
  FloorPlan plan;
  LocalText title;  ///< What visitors call it; may be empty.
  VoronoiDiagram diagram;
  Roadmap roadmap;
  SightMap sight;
  std::vector<TangentGraph>
      tangent_graphs;                 ///< One per radius class, ascending radius; the first is 0.
  std::vector<HubLabels> hub_labels;  ///< One per tangent graph.
};

}  // namespace docent
