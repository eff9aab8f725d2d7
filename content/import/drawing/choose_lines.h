#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "content/import/drawing/arrangement.h"
#include "content/import/drawing/drawing.h"
#include "content/import/drawing/layer_kind.h"
#include "content/import/drawing/rooms.h"
#include "content/import/drawing/stairs.h"
#include "content/import/drawing/swing.h"

namespace docent::import {

/// The lines that could be walls and the arcs that could be doors, before any geometry.
struct Chosen {
  std::vector<WallLine> lines;
  std::vector<WallLine> stairs;         ///< On layers of stairs.
  std::vector<WallLine> leaves;         ///< Strokes on layers of doors; more may be among `lines`.
  std::vector<std::uint32_t> arcs;      ///< Those that swing like a door about a hinge.
  std::vector<std::uint32_t> any_arcs;  ///< These and those that might, whatever their centre.
  /// Strokes of the latter: walls where no leaf is found.
  std::vector<std::pair<std::uint32_t, WallLine>> strokes_of_arcs;
};

/// By the kinds of layers, without strays far away and the axes of a building's grid. What is left
/// out is counted in `found`.
Chosen choose_lines(const Drawing& drawing, const std::vector<LayerKind>& kinds, FoundPlans& found);

/// The flights of stairs; their treads are no walls.
std::vector<Flight> take_flights(Chosen& chosen, FoundPlans& found);

/// The doors among the arcs; the strokes of arcs that are none become walls.
std::vector<Swing> swings_of(const Drawing& drawing, Chosen& chosen, FoundPlans& found);

}  // namespace docent::import
