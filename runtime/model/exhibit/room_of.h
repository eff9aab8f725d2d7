#pragma once

#include <cstdint>

#include "runtime/model/geometry/polygon.h"
#include "runtime/model/museum.h"
#include "runtime/model/none.h"

namespace docent {

/// The room of a floor whose outline holds the point, as an index into Museum::rooms; none where
/// there is no such room.
inline std::uint32_t room_of(const Museum& museum, std::uint32_t floor, Vec2 point) noexcept {
  for (std::uint32_t i = 0; i < museum.rooms.size(); ++i)
    if (museum.rooms[i].floor == floor && contains(museum.rooms[i].outline, point)) return i;
  return none;
}

}  // namespace docent
