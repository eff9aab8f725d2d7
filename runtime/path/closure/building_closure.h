#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "runtime/path/closure/closed_doors.h"

namespace docent::path {

/// What is closed in a building just now, made ready for queries. Immutable; any thread may ask.
struct BuildingClosure {
  std::vector<std::shared_ptr<const ClosedDoors>> floors;  ///< Null where no door is closed.
  std::vector<std::uint8_t> connection;                    ///< By connection: is it closed?

  const ClosedDoors* on(std::uint32_t floor) const noexcept { return floors[floor].get(); }
};

/// The closed doors of a floor, also where all are open. `closure`: null where nothing is closed.
inline const ClosedDoors* doors_closed_on(const BuildingClosure* closure,
                                          std::uint32_t floor) noexcept {
  static const ClosedDoors all_open;
  const ClosedDoors* closed = closure != nullptr ? closure->on(floor) : nullptr;
  return closed != nullptr ? closed : &all_open;
}

}  // namespace docent::path
