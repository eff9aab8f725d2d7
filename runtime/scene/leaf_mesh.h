#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "runtime/model/scenery.h"
#include "runtime/scene/draw_list.h"

namespace docent::scene {

/// Vertices that a leaf takes: a board, and a bar on either side on two stays.
inline constexpr std::size_t vertices_of_a_leaf = 36, vertices_of_its_bars = 6 * 36;

/// Metres above the floor of the bars across a leaf, from its middle to their surface, and how
/// thick they are.
inline constexpr double bar_height = 1.08, bar_surface = 0.075, bar_thickness = 0.03;

/// Makes triangles of leaves, counter-clockwise seen from outside, world frame: the boards of all,
/// then the bars of all. As many leaves as `mesh` has room for; does not allocate. Returns where
/// the bars begin.
std::size_t make_leaves(std::span<const LeafDraw> leaves,
                        std::vector<SceneryVertex>& mesh) noexcept;

}  // namespace docent::scene
