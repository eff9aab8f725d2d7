#pragma once

#include <span>
#include <vector>

#include "content/import/drawing/arrangement.h"
#include "content/import/drawing/drawing.h"

namespace docent::import {

/// A door as plans draw it: the leaf, open, and the arc on which its edge swings. Metres.
struct Swing {
  Vec2 hinge{};
  Vec2 shut{};  ///< Where the leaf's edge is when the door is shut.
  Vec2 open{};
  std::uint32_t arc = 0;  ///< Index into Drawing::arcs.
};

/// Could this arc, in metres, be a door's? A leaf of 0.45 to 1.6 m that opens by 8 to 120 degrees.
bool swings_like_a_door(const DrawnArc& arc);

/// Could this arc, in metres, be what the tip of a leaf draws, whatever its centre? Hands draw
/// doors ajar with an arc through three points, whose centre is not the hinge.
bool could_end_at_a_leaf(const DrawnArc& arc);

/// The doors among arcs drawn by hand: a leaf goes from a wall to one end of the arc, and the other
/// end is on a wall, as far from the hinge as the leaf is long.
std::vector<Swing> find_swings_by_leaves(const Drawing& drawing,
                                         std::span<const std::uint32_t> arcs,
                                         std::span<const WallLine> walls);

/// The doors among the arcs: those whose hinge is at a wall, with the shut end nearer to a wall
/// than the open one, or where the shut end of another leaf is. `walls` are lines of walls, without
/// the arcs; `leaves` are strokes that may draw a leaf, walls or not.
std::vector<Swing> find_swings(const Drawing& drawing, std::span<const std::uint32_t> arcs,
                               std::span<const WallLine> walls, std::span<const WallLine> leaves);

/// Does this stroke draw the open leaf of that door?
bool draws_the_leaf(const Swing& swing, Vec2 a, Vec2 b);

}  // namespace docent::import
