#pragma once

#include <string>

#include "runtime/model/motion/motion_graph.h"

namespace docent::draw {

/// Draws a motion graph as an SVG document 1,800 pixels wide: each clip a line along its time, with
/// the foot plants of its left foot above and its right foot below, and each transition an arc from
/// the frame that is left to the frame that is reached, coloured by its distance (the founding
/// paper's figure 2b). Arcs bow to the right as one travels along them, so the two directions do
/// not cover each other.
std::string draw_motion_graph(const MotionGraph& graph);

}  // namespace docent::draw
