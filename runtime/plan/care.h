#pragma once

#include <optional>
#include <span>
#include <vector>

#include "runtime/model/museum.h"
#include "runtime/motion/careful_place.h"
#include "runtime/plan/plan.h"

namespace docent::plan {

/// Where a plan's way goes through doors, and where it ends at stairs: there one slows down.
std::vector<motion::CarefulPlace> careful_places(const Museum& museum, const Plan& plan);

/// Where the segment p q crosses the door, if it does.
std::optional<Vec2> crossing(Vec2 p, Vec2 q, const Door& door) noexcept;

/// How much longer a way takes because of them, at that speed elsewhere. Seconds.
double seconds_of_care(std::span<const motion::CarefulPlace> places, std::span<const Vec2> way,
                       double speed);

}  // namespace docent::plan
