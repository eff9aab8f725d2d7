#pragma once

#include "runtime/path/floor_map.h"
#include "runtime/path/way.h"

namespace docent::path {

/// Rounds the corners of a way, so that it is smooth where it joins and leaves the medial axis or a
/// wall's curve, and where axes meet. The ends stay, and the way still keeps `radius` from the
/// walls: whatever replaces a corner stays within the corner's clearance less `radius` of it. Where
/// a way turns back on itself the tip is cut off.
///
/// `length` becomes that of the rounded way, to the flatness of its curves.
void round_corners(const FloorMap& map, double radius, Way& way);

}  // namespace docent::path
