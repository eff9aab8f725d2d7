#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "runtime/model/geometry/floor_plan.h"
#include "runtime/model/route_kind.h"

namespace docent::draw {

/// How many soft tints there are for Voronoi regions.
constexpr std::size_t region_tints = 8;
/// The colour of a tint, "#RRGGBB".
std::string region_colour(std::size_t tint);

/// The name of the pattern that fills blocks.
inline constexpr std::string_view block_hatch = "block";

/// Attributes of a door: dotted where one walks through, a line where it is closed.
std::string door_stroke(const Door& door);

/// Attributes of a wall as a site of its own: each unlike the one before it.
std::string wall_site_stroke(std::size_t wall);

/// Attributes of a piece of the medial axis, `wide` from 0 to 1: thicker and greener where the room
/// is wider.
std::string axis_stroke(double wide);

/// Attributes of a way: its colour and its pattern, which tells the kinds apart without colours,
/// too. `width` in pixels.
std::string way_stroke(const RouteKindInfo& kind, double width);

/// Attributes of an area whose edge is a line of equal clearance, where `levels` such areas lie one
/// within another: each darkens what lies below a little.
std::string level_style(std::size_t levels);

}  // namespace docent::draw
