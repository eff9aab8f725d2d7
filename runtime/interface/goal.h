#pragma once

#include <optional>

#include "runtime/interface/control.h"

namespace docent::interface {

/// Where a visitor is led, or has arrived. Floor frame.
struct Goal {
  std::uint32_t floor = 0;
  Placement standing;  ///< Where one stands, and looks at it.
  Vec2 position{};     ///< Where it is itself.
};

/// None where the visitor wants nothing, or where it is not known yet which place is the nearest.
std::optional<Goal> goal_of(const Museum& museum, const InterfaceState& state) noexcept;

/// Does the visitor want to go somewhere, or are they there?
bool has_goal(const InterfaceState& state) noexcept;

/// Where one stands at a place, and looks at it.
Placement standing_at(const Place& place) noexcept;

}  // namespace docent::interface
