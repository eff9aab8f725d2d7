#pragma once

#include <span>
#include <string>
#include <vector>

#include "runtime/model/exhibit/exhibit.h"
#include "runtime/model/geometry/floor_plan.h"
#include "runtime/path/route.h"

namespace docent::compile {

/// A doorway or gap that is too narrow for a body, between two parts of a floor that have room for
/// it.
struct NarrowDoor {
  Vec2 position{};   ///< Where it is narrowest. Floor frame.
  double width = 0;  ///< Metres, there.
  std::string name;  ///< As staff know it: "the door between 'Foyer' and 'Garden Court'".
  bool is_on_widest_way = false;  ///< If these had room, the body would get everywhere.
};

/// A body that comes from one place of a floor, and what people call the floor's parts.
struct ComingBody {
  const path::FloorMap& map;
  std::span<const Room> rooms;  ///< Of this floor.
  std::span<const Door> doors;
  std::string language;  ///< Of the names.
  Vec2 from{};           ///< With room for the body.
  double radius = 0.25;
};

/// The doors that keep a body from rooms, and from the places in `wanted` that have room for it. A
/// body is kept from a room where it gets to no part of it. Where several doors lie one after
/// another or side by side, all of them are named. Doors beyond which nobody wants to go are not
/// named; narrow places inside a room are named only where no wider way leads round them.
std::vector<NarrowDoor> narrow_doors(const ComingBody& body, std::span<const Vec2> wanted);

}  // namespace docent::compile
