#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "runtime/model/geometry/vec2.h"

namespace docent::object {

/// Why a profile cannot be turned.
struct ProfileFault {
  std::size_t point = 0;  ///< Of those that were given.
  std::string what;       ///< A sentence without a full stop.
  std::string hint;
};

/// Half a section of something round: radius and height along its outline, the axis at radius 0.
/// Its ends are joined to the axis straight. Where it turns by less than `corner` radians it is
/// rounded (centripetal Catmull-Rom: Yuksel, Schaefer and Keyser 2011), and goes through the
/// points as they were given.
struct Profile {
  static constexpr float corner = 1.1F;  ///< More than what make_object takes for an edge.
  static constexpr std::size_t most_points = 100;

  std::vector<Vec2> points;           ///< Upwards on the outside: what it encloses is on the left.
  std::vector<std::size_t> of_point;  ///< Where those that were given are among them, in order.
};

/// What is wrong with a profile, given from either end; empty where it can be turned. Radii are 0
/// or more.
std::optional<ProfileFault> fault_of(std::span<const Vec2> given);

/// The profile of points without a fault, as near as `tolerance`.
Profile profile_of(std::span<const Vec2> given, double tolerance);

/// The longer one of how wide and how high it is.
double longest_side(std::span<const Vec2> profile);

}  // namespace docent::object
