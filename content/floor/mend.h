#pragma once

#include <vector>

#include "content/floor/ring_overlay.h"
#include "content/import/floor/imported_plan.h"
#include "runtime/model/diagnostic.h"
#include "runtime/model/geometry/floor_plan.h"

namespace docent::floor {

/// Makes walls of drawn rings: the union over all polygons of the outer ring's inside without the
/// holes' insides, where the inside of a ring that crosses itself is every point it winds about
/// (so both halves of a bow tie). The result keeps the invariants of FloorPlan.
///
/// Vertices of rings that need no mending come through bit for bit and in their order; only exactly
/// collinear ones are dropped. The rest is computed exactly and rounded once:
///  - vertices closer together than 1 mm become the first of them;
///  - spikes and rings without area are left out;
///  - where rings cross, touch, overlap or nest, the walls are those of what remains walkable, each
///    keeping to its own side of a point that two rings share: nobody fits through there.
/// Each mending is appended to `mendings` as a warning with its place in the source, also where it
/// throws.
///
/// Throws ContentError where nothing walkable remains, and where the plan's size says that its
/// numbers cannot be metres.
FloorPlan mend(const import::ImportedPlan& imported, std::vector<Diagnostic>& mendings);

/// The same of rings that are walls already, with the floor on their left, and of obstacles that
/// lie on their right: what remains walkable, without a word. Throws where nothing does.
FloorPlan plan_of_walls(std::vector<OverlayRing> rings);

}  // namespace docent::floor
