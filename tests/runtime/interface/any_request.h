#pragma once

#include "runtime/directions/directions.h"
#include "runtime/interface/layout.h"

namespace docent::interface {

/// What a kiosk of this museum may be asked to show; for properties.
ViewRequest any_request(const Museum& museum);

/// Gives two exhibits of three further pictures, few or as many as there may be, some with captions
/// and some described, and every other one a longer text and something to listen to.
void add_pictures_and_more(Museum& museum);
/// Any picture and text of the exhibit that one is at; for properties.
void look_closer(InterfaceState& state);

/// A way as it may be told: rooms, doors, turns, floors.
directions::Directions any_directions(const Museum& museum);

}  // namespace docent::interface
