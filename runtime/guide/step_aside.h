#pragma once

#include <optional>

#include "runtime/guide/exhibit_shape.h"
#include "runtime/interface/goal.h"
#include "runtime/model/motion/side.h"
#include "runtime/path/floor_map.h"

namespace docent::guide {

/// Metres before the end of its way at which a guide turns aside.
inline constexpr double turns_aside = 2.6;

/// Where a guide stands who has led somebody to an exhibit: beside the place from which one looks
/// at it, hiding nothing, clear of walls and of the exhibit, turned half to the exhibit and half to
/// the visitor. They look the way `yaw` (radians); by default as arrival_yaw() has it. The place is
/// chosen by how easily it is walked to from `body`, on `side` of the line of sight where there is
/// room on that; none where there is no room beside. Does not allocate.
std::optional<Placement> place_aside(const path::FloorMap& map, const interface::Goal& goal,
                                     const ExhibitShape& shape, const Placement& body,
                                     std::optional<double> yaw, double radius,
                                     std::optional<Side> side = {}) noexcept;

/// Which way the camera looks at an exhibit that a guide shows who stands there: over the other
/// shoulder of the place from which one looks at it.
double arrival_yaw(const interface::Goal& goal, Vec2 guide) noexcept;
/// About where a guide stands aside, on the side where it is seen so.
Vec2 about_aside(const interface::Goal& goal, Vec2 guide) noexcept;

}  // namespace docent::guide
