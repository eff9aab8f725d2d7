#pragma once

#include "runtime/directions/directions.h"
#include "runtime/interface/layout.h"

namespace docent::interface {

/// What a kiosk of this museum may be asked to show; for properties.
ViewRequest any_request(const Museum& museum);

/// A way as it may be told: rooms, doors, turns, floors.
directions::Directions any_directions(const Museum& museum);

}  // namespace docent::interface
