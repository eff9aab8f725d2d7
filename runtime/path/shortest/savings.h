#pragma once

#include <vector>

#include "runtime/model/geometry/tangent_graph.h"

namespace docent::path {

/// Per side of a tangent graph, metres: what the ways of a disc save at an end, if they touch that
/// side first as seen from there. A point's shortest way between the corners that a disc's way
/// touches first and last is no longer than the disc's way between the two touches and what both
/// ends save. So what is known of points bounds the ways of discs, and closely: mostly a tenth of
/// the radius is saved, where the corner alone allows for all of it.
///
/// Never more than the graph's radius; 0 for sides that no tangent leaves.
std::vector<double> savings(const TangentGraph& graph);

}  // namespace docent::path
