#pragma once

#include <span>
#include <vector>

#include "runtime/path/route.h"
#include "tests/content/floor/plans.h"

namespace docent::test {

/// The length of the shortest way of a point, by Dijkstra over all pairs of vertices that see each
/// other, seeing being decided by cutting the segment at every wall and testing the middle of each
/// part. Infinite where there is none.
double brute_force_length(const FloorPlan& plan, Vec2 from, Vec2 to);
/// The same to many places at once.
std::vector<double> brute_force_lengths(const FloorPlan& plan, Vec2 from, std::span<const Vec2> to);

/// The smallest distance to a wall over points of a polyline at most 1 cm apart, by brute force.
double sampled_clearance(const FloorPlan& plan, const std::vector<Vec2>& points);
/// Does the polyline cross a wall from one side to the other?
bool crosses_a_wall(const FloorPlan& plan, const std::vector<Vec2>& points);
double polyline_length(const std::vector<Vec2>& points);

}  // namespace docent::test
