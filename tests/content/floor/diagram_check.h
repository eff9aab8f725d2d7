#pragma once

#include <string>

#include "runtime/model/geometry/floor_plan.h"
#include "runtime/model/geometry/voronoi_diagram.h"

namespace docent::test {

/// What went wrong first, or nothing.
using Complaint = std::string;

/// Is this the plan's Voronoi diagram? By brute force: every vertex is as far from the nearest wall
/// as it claims, to within `at_vertices` metres; five points of every edge are equally far from its
/// two sites, and no wall is nearer, to within `along_edges`; every region is one loop, and the
/// regions' areas make up the floor's.
Complaint check(FloorPlan plan, VoronoiDiagram diagram, double at_vertices = 1e-9,
                double along_edges = 1e-9);

}  // namespace docent::test
