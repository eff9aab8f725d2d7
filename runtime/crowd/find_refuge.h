#pragma once

#include <span>
#include <vector>

#include "runtime/crowd/reservation_table.h"
#include "runtime/path/route.h"

namespace docent::crowd {

/// A place to step aside to.
struct Refuge {
  Vec2 place{};
  std::vector<Vec2> way;  ///< The shortest way there.
};

/// Refuges for a body that stands at `from`: places where it is clear of the line that another
/// wants to go along, of walls, and of where others will stand. At most `most`, the shortest way
/// first. Frame: floor.
std::vector<Refuge> find_refuges(const path::FloorMap& map, const ReservationTable& reservations,
                                 std::uint32_t body, Vec2 from, std::span<const Vec2> line,
                                 std::size_t most);

}  // namespace docent::crowd
