#pragma once

#include <cstdint>

#include "runtime/crowd/timetable.h"
#include "runtime/path/route.h"

namespace docent {

/// A way that passes nobody who stands at a moment, by a place of the roadmap that the way asked
/// for does not lead to; the shortest such, or a way whose status says that there is none.
Way find_detour(const FloorMap& map, const Timetable& timetable, std::uint32_t body,
                const RouteQuery& query, double seconds);

}  // namespace docent
