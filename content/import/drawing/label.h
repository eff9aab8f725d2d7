#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "content/import/drawing/drawing.h"

namespace docent::import {

/// What the texts in a room say together.
struct RoomLabel {
  std::string name;
  std::optional<double> area;  ///< Square metres.
};

/// Names from the top down; areas, heights, sizes of doors and marks of axes are no names.
RoomLabel label_of(std::vector<DrawnText> texts);

/// `corridor` or `hall` where the name says so in one of some languages, else nothing.
std::string kind_of_room(std::string_view name);

/// `stairs`, `lift`, `ramp` where the name says so.
std::string connection_of_room(std::string_view name);

/// A kind of place, `toilets` or `cloakroom`, that the room's name tells.
std::string place_of_room(std::string_view name);

}  // namespace docent::import
