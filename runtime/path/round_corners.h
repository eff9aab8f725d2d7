#pragma once

#include "runtime/path/floor_map.h"
#include "runtime/path/way.h"

namespace docent::path {

/// Rounds the corners of a way, so that it is smooth where it joins and leaves the medial axis or a
/// wall's curve, and where axes meet. The ends stay, and so does the radius: whatever replaces a
/// corner stays inside the disc about it whose own radius is the corner's clearance less `radius`.
/// Where a way turns back on itself the tip is cut off.
///
/// `length` becomes that of the rounded way, to the flatness of its curves.
void round_corners(const FloorMap& map, double radius, Way& way);

}  // namespace docent::path
