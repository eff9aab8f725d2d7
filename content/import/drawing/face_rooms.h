#pragma once

#include <cstdint>
#include <vector>

#include "content/import/drawing/close_plan.h"
#include "content/import/drawing/drawn_box.h"
#include "content/import/drawing/rooms.h"

namespace docent::import {

constexpr double narrowest_room = 0.38;  ///< Half its width: less is a wall's inside or a niche.
constexpr double smallest_room = 0.9;    ///< Square metres.

/// What is known of the rooms of a plan beside what they are; one entry each, in their order.
struct RoomFaces {
  std::vector<std::uint32_t> face;  ///< Of ClosedPlan::faces.
  std::vector<bool> sealed;         ///< Was it shut by a line wider than a door?
  std::vector<bool> frames;         ///< Does it lie around most of the plan?
};

/// Makes rooms and columns of the faces of a closed plan.
RoomFaces find_face_rooms(const ClosedPlan& closed, FoundPlan& plan, FoundPlans& found);

/// The boxes about the rooms of a plan.
std::vector<DrawnBox> boxes_of(const FoundPlan& plan);

}  // namespace docent::import
