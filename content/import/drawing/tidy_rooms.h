#pragma once

#include <span>

#include "content/import/drawing/drawing.h"
#include "content/import/drawing/drawn_box.h"
#include "content/import/drawing/face_rooms.h"
#include "content/import/drawing/rooms.h"
#include "content/import/drawing/stairs.h"

namespace docent::import {

/// Names the rooms by the texts in them, and takes out what is none: furniture, frames, shafts.
void tidy_rooms(const Drawing& drawing, RoomFaces faces, FoundPlan& plan, FoundPlans& found);

/// Flights within a box, side by side or one after another, are one pair of stairs; so are rooms
/// that are called so.
void add_stairs(std::span<const Flight> flights, const DrawnBox& box, FoundPlan& plan);

/// Rooms that are called stairs or lift, unless such are known in them.
void add_named_stairs(FoundPlan& plan);

}  // namespace docent::import
