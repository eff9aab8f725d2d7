#pragma once

#include "runtime/interface/control.h"
#include "runtime/path/building/building_map.h"

namespace docent::plan {

/// Orders what a visitor has collected by the shortest walk from the kiosk, over floors, with what
/// is closed just now, and finds out how long it takes. Who is on that tour already keeps what they
/// have seen and where they go. What is closed, or cannot be reached as the visitor wishes, is
/// walked to as if it could be: it says so itself. Where there is no way at all the order stays as
/// it is, and takes nobody knows how long.
void order_own_tour(const Museum& museum, const path::BuildingMap& building,
                    interface::InterfaceState& state);

}  // namespace docent::plan
