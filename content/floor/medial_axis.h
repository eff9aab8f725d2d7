#pragma once

#include "runtime/model/geometry/floor_plan.h"
#include "runtime/model/geometry/roadmap.h"
#include "runtime/model/geometry/voronoi_diagram.h"

namespace docent::floor {

/// The middle of the room as a network to walk on: the medial axis without its dead ends.
///
/// Left out are the twigs that run into a convex corner, between its two walls (or the many walls
/// that a scan makes of two), and the dead ends that matter to nobody: those whose discs reach less
/// than 5 cm beyond the disc of the junction they hang from (after Shaked and Bruckstein, Pruning
/// medial axes, 1998), such as the noise of a traced wall makes. Nothing left out connects two
/// places, so the widest way between any two points of what stays is unchanged.
///
/// A part of the floor whose whole axis was twigs (a square room) keeps its widest point as a node
/// without edges. Nodes without edges occur for no other reason.
Roadmap medial_axis(const FloorPlan& plan, const VoronoiDiagram& diagram);

}  // namespace docent::floor
