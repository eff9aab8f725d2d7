#pragma once

#include <span>
#include <vector>

#include "runtime/model/geometry/floor_plan.h"
#include "runtime/model/geometry/voronoi_diagram.h"

namespace docent::floor {

/// A reflex corner, as discs bend at it. The centre of a disc that rolls round the corner lies in
/// directions from `begin` counter-clockwise to `end`, as far as its radius; where there is room
/// for a disc, there is room for a smaller one in the same direction, for the corner's Voronoi
/// region is a star about it.
struct Bend {
  Vec2 position{};
  Vec2 begin{}, end{};  ///< Unit normals of the walls that begin and end at the corner.
  double reach = 0;     ///< Radius of the largest disc that touches the corner. Metres.
};

/// The bends at these vertices of a plan, which are reflex, in their order.
std::vector<Bend> bends_at(const FloorPlan& plan, const VoronoiDiagram& diagram,
                           std::span<const std::uint32_t> corners);

/// May the shortest way of some disc go straight from bend `a` to bend `b`? Never wrongly no, and
/// yes at most by a rounding error too often: the disc's line touches the circles about both
/// corners in a direction that each has.
bool some_disc_goes_straight(const Bend& a, const Bend& b);

/// In how many ways a point goes straight from `a` to `b`: 0 to 4, by the side on which it passes
/// each.
unsigned straight_ways_of_a_point(const Bend& a, const Bend& b);

}  // namespace docent::floor
