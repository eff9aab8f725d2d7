#pragma once

#include <span>
#include <vector>

#include "content/scenery/furniture.h"
#include "runtime/model/exhibit/object.h"

namespace docent::scenery {

/// Where an object stands and how large, and what has to be built under it.
struct PlacedObject {
  ObjectStand stand;
  Outline plinth;            ///< Floor frame; empty where the plan has something to stand on.
  double plinth_height = 0;  ///< Metres.
  Blocker shade;             ///< What keeps light away.
};

/// In the middle of its case, within the glass; on its pedestal; or on a plinth of its own, the
/// lower the larger the object is. It keeps its size, but where there is no room for it: then it is
/// so small that nothing of it comes through the glass or beyond the edge, whichever way it is
/// turned, and that it stays below what cameras look over. `size` is its own, metres.
PlacedObject place_object(const ExhibitStand& stand, Vec3 size);

}  // namespace docent::scenery
