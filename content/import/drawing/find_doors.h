#pragma once

#include "content/import/drawing/close_plan.h"
#include "content/import/drawing/face_rooms.h"
#include "content/import/drawing/rooms.h"

namespace docent::import {

/// The doors among what shut a plan, between its rooms or to the outside; and doorways that are
/// drawn shut by lines from jamb to jamb. Counts the doors of each room.
void find_doors(const ClosedPlan& closed, const RoomFaces& rooms, FoundPlan& plan,
                FoundPlans& found);

}  // namespace docent::import
