#pragma once

#include <cstdint>

#include "runtime/crowd/reservation_table.h"
#include "runtime/path/route.h"

namespace docent::crowd {

/// A way round all bodies that stand at `seconds` (the crowd's clock) and stay there: the shortest
/// found that leads over one node of the roadmap. Its status says where there is none.
path::Way find_detour(const path::FloorMap& map, const ReservationTable& reservations,
                      std::uint32_t body, const path::RouteQuery& query, double seconds);

}  // namespace docent::crowd
