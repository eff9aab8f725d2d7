#pragma once

#include <vector>

#include "runtime/model/museum.h"

namespace docent::guide {

/// Where an exhibit is seen: its picture or object. World frame.
struct ExhibitShape {
  Vec3 middle{};          ///< Where one points to show it.
  Vec2 low{}, high{};     ///< Floor frame: the box that it takes up, seen from above.
  float half_height = 0;  ///< Metres above and below its middle.
};

/// One per exhibit. Where nothing of it is drawn, a point at breast height.
std::vector<ExhibitShape> exhibit_shapes(const Museum& museum);

/// Metres from a point of the floor to the box; 0 within.
double distance_to(const ExhibitShape& shape, Vec2 point) noexcept;

}  // namespace docent::guide
