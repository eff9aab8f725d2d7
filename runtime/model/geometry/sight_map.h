#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "runtime/model/geometry/vec2.h"

namespace docent {

/// What the reflex corners of a floor see: each other, and the cells of a grid. It serves discs of
/// every radius: where a disc can go straight from a point to the circle about a corner (or from
/// one such circle to another), the straight line to the corner itself is free of walls too.
///
/// Frame: floor. `corner` lists the vertices that may be reflex, ascending; corner i sees the
/// corners pair_other[pair_first[i] .. pair_first[i + 1]), and cell c may hold a point that sees
/// the corners cell_corner[cell_first[c] .. cell_first[c + 1]), perhaps some more; all lists ascend
/// and hold indices into `corner`. Cells are numbered row by row from `origin`, the lower left; a
/// point off the grid is on no floor. Made by the content compiler. Immutable once loaded.
struct SightMap {
  std::vector<std::uint32_t> corner;
  std::vector<std::uint32_t> pair_first{0}, pair_other;
  Vec2 origin{};
  double cell_size = 1;  ///< Metres.
  std::uint32_t columns = 0, rows = 0;
  std::vector<std::uint32_t> cell_first{0}, cell_corner;

  std::optional<std::size_t> cell_at(Vec2 point) const noexcept {
    const Vec2 at = (point - origin) / cell_size;
    if (!(at.x >= 0 && at.y >= 0 && at.x < columns && at.y < rows)) return {};
    return static_cast<std::size_t>(at.y) * columns + static_cast<std::size_t>(at.x);
  }
};

}  // namespace docent
