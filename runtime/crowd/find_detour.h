#pragma once

#include <cstdint>

#include "runtime/crowd/reservation_table.h"
#include "runtime/path/route.h"

namespace docent::crowd {

/// A way that passes nobody who stands at a moment, by a place of the roadmap that the way asked
/// for does not lead to; the shortest such, or a way whose status says that there is none.
path::Way find_detour(const path::FloorMap& map, const ReservationTable& reservations,
                      std::uint32_t body, const path::RouteQuery& query, double seconds);

}  // namespace docent::crowd
