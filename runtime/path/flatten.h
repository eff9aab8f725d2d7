#pragma once

#include <vector>

#include "runtime/path/shortest/reflex_corner.h"

namespace docent::path {

/// How far a flattened curve may be from the true one. Metres.
inline constexpr double flatness = 1e-3;

/// Appends a point unless it repeats the last one.
void append_point(Vec2 point, std::vector<Vec2>& points);

/// Appends points of a circle from one angle to another, both included; the chords are within
/// `flatness` of the arc and turn by 15 degrees at most. Angles are measured from the unit
/// direction `begin`, radians.
void append_arc(Vec2 centre, Vec2 begin, double radius, double from, double to,
                std::vector<Vec2>& points);

}  // namespace docent::path
