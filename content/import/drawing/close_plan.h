#pragma once

#include <optional>
#include <span>
#include <vector>

#include "content/import/drawing/arrangement.h"
#include "content/import/drawing/rooms.h"
#include "content/import/drawing/swing.h"

namespace docent::import {

/// A line that shuts an opening, and what was seen there.
struct Closing {
  Vec2 a{}, b{};
  bool swing = false, certain = false;
  bool seal = false;  ///< Wider than a door: keeps a room from running out of the house.
};

/// The walls of a plan with its doors shut: each face is a room, or what lies between.
struct ClosedPlan {
  std::vector<Closing> closings;
  Arrangement arrangement;
  Faces faces;
};

/// Shuts the openings between lines that lie together: swings first, then gaps, then wide ends of
/// halls. What is left out is counted in `found`; empty, and a refusal in `found`, where the lines
/// cross too often.
std::optional<ClosedPlan> close_plan(std::vector<WallLine> lines, std::span<const Swing> swings,
                                     FoundPlans& found);

}  // namespace docent::import
