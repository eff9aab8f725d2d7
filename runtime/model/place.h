#pragma once

#include <cstdint>
#include <string>

#include "runtime/model/geometry/vec2.h"
#include "runtime/model/local_text.h"
#include "runtime/model/place_kind.h"

namespace docent {

/// Something that visitors ask for: toilets, an exit, a seat.
struct Place {
  std::string id{};  ///< Stable.
  PlaceKind kind = PlaceKind::Information;
  std::uint32_t floor = 0;  ///< Index into Museum::floors.
  Vec2 position{};          ///< Where it is: on the floor, in or behind a wall.
  Vec2 standing{};          ///< Where the way to it ends: clear of walls, as near as can be.
  LocalText title{};        ///< Empty where its kind says enough.
};

}  // namespace docent
