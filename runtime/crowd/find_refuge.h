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

/// Places near a body where it would stand out of the way of a line that another wants to go along,
/// clear of walls and of where others will stand; the nearest to walk to first, at most `most`.
std::vector<Refuge> find_refuges(const path::FloorMap& map, const ReservationTable& reservations,
                                 std::uint32_t body, Vec2 from, std::span<const Vec2> line,
                                 std::size_t most);

}  // namespace docent::crowd
