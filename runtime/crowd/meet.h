#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "runtime/crowd/body.h"
#include "runtime/crowd/cells.h"
#include "runtime/crowd/contact.h"

namespace docent::crowd {

/// The largest coordinate, speed or radius that counts. Metres, or metres a second. A body with a
/// larger number, one that is not finite, or a negative radius takes no part and meets nobody.
inline constexpr double largest_number = 1e9;
/// A horizon is at most this, at least 0; one that is not a number is 0. Seconds.
inline constexpr double largest_horizon = 1e6;

/// Are all numbers of this body ones that count?
inline bool takes_part(const Body& body) noexcept {
  const auto is_number = [](double value) { return std::abs(value) <= largest_number; };
  return is_number(body.position.x) && is_number(body.position.y) && is_number(body.velocity.x) &&
         is_number(body.velocity.y) && is_number(body.radius) && body.radius >= 0;
}
double clamp_horizon(double horizon) noexcept;

inline Approach approach_of(const Body& a, const Body& b) noexcept {
  return make_approach(b.position - a.position, b.velocity - a.velocity, a.radius + b.radius);
}
/// When the circles of two bodies touch, whether or not a wall is between them (contact.h).
inline std::optional<Collision> contact_of_circles(const Body& a, const Body& b,
                                                   double horizon) noexcept {
  return contact(approach_of(a, b), horizon);
}

/// When two bodies meet if both keep their velocity: the first time t from now to the horizon
/// (seconds) at which their circles touch and the line from one centre to the other is open. That
/// line has three straight parts: from where the first body is now to where it is at t, from there
/// to where the other is at t, and from there to where the other is now. It is open if no part of
/// it leaves the floor; touching a wall or a corner is not leaving.
///
/// So a wall keeps two bodies apart only if, at every moment at which the circles would touch, it
/// has stopped one of the centres on its way there, or stands between the centres. Circles that are
/// wholly on the floor cannot touch then: together they cover the line between their centres.
/// Nothing is assumed about the clearance of the centres, which may be less than the radius.
///
/// A body whose centre is off the floor, where nobody should be, is held by no wall: for it only
/// the circles count. Two bodies between which more than 64 corners pass meet at their first touch.
/// (a, b) and (b, a) give the same answer, but for rounding of the time. Does not allocate.
std::optional<double> time_of_impact(const WalkableCells& floor, const Body& a, const Body& b,
                                     double horizon) noexcept;

/// The same for bodies that take part and are on the floor, whose `contact` is known already.
std::optional<double> time_in_sight(const WalkableCells& floor, const Body& a, const Body& b,
                                    const Collision& contact) noexcept;

/// Distance from a point to the nearest wall, metres; perhaps a little less. At most `most`.
double clearance_at(const WalkableCells& floor, Vec2 point, double most) noexcept;

/// A straight piece from which a centre is no further than `tolerance`, now and up to the horizon.
struct SweptLine {
  Vec2 from{}, to{};
  double tolerance = 0;  ///< Metres.
};
/// What `time_in_sight` says of any two bodies that keep to their swept lines.
enum class Sight : std::uint8_t {
  Unknown,  ///< Not asked yet.
  Open,     ///< No wall comes between them: they meet when their circles touch.
  Closed,   ///< A wall always does: they do not meet.
  Either,   ///< Sometimes.
};
Sight sight_between(const WalkableCells& floor, const SweptLine& a, const SweptLine& b) noexcept;

}  // namespace docent::crowd
