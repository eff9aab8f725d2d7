#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "runtime/crowd/body.h"
#include "runtime/crowd/cells.h"
#include "runtime/crowd/contact.h"

namespace docent::crowd {

/// Numbers beyond this are no places on a floor; who has any, or one that is not finite, or a
/// radius below 0, takes no part and meets nobody. Metres, or metres a second.
inline constexpr double largest_number = 1e9;
/// A horizon is at most this, at least 0; one that is not a number is 0. Seconds.
inline constexpr double largest_horizon = 1e6;

/// Are these numbers of a body?
inline bool takes_part(const Body& body) noexcept {
  const auto is_number = [](double value) { return std::abs(value) <= largest_number; };
  return is_number(body.position.x) && is_number(body.position.y) && is_number(body.velocity.x) &&
         is_number(body.velocity.y) && is_number(body.radius) && body.radius >= 0;
}
double clamp_horizon(double horizon) noexcept;

inline Approach approach_of(const Body& a, const Body& b) noexcept {
  return make_approach(b.position - a.position, b.velocity - a.velocity, a.radius + b.radius);
}
/// When the circles of two bodies touch, walls or no walls (contact.h).
inline std::optional<Collision> contact_of_circles(const Body& a, const Body& b,
                                                   double horizon) noexcept {
  return contact(approach_of(a, b), horizon);
}

/// When two bodies meet: the first time t, now or within the horizon, at which their circles touch
/// and the way from one centre to the other is open, both keeping their velocity. The way is three
/// straight lines: with the first body to where it is at t, from there to where the other is at t,
/// and back to where that one is now; it is open if no part of it leaves the floor (along a wall
/// and round a corner is on the floor).
///
/// So a wall drops a pair only if, at every moment at which the circles would touch, it has stopped
/// one of the centres on its way there, or stands between the centres. Circles that are wholly on
/// the floor cannot touch then: together they cover the line between their centres. Nothing is
/// assumed about the discs' own clearance, which may be less than their radius.
///
/// A body whose centre is off the floor, where nobody should be, is held by no wall: there only the
/// circles count. Where more than 64 corners pass between two bodies they count from the first
/// touch. The same for (b, a), but for rounding of the time. Does not allocate.
std::optional<double> time_of_impact(const WalkableCells& floor, const Body& a, const Body& b,
                                     double horizon) noexcept;

/// The same for bodies that take part and stand on the floor, with their contact at hand.
std::optional<double> time_in_sight(const WalkableCells& floor, const Body& a, const Body& b,
                                    const Collision& contact) noexcept;

/// From a point to the nearest wall, metres, if that is less than `most`; perhaps a little less.
double clearance_at(const WalkableCells& floor, Vec2 point, double most) noexcept;

/// Where a centre is, and where it will be up to the horizon: no further than `tolerance` from a
/// line.
struct SweptLine {
  Vec2 from{}, to{};
  double tolerance = 0;  ///< Metres.
};
/// What `time_in_sight` says of any two who are each in their stretch.
enum class Sight : std::uint8_t {
  Unknown,  ///< Not asked yet.
  Open,     ///< No wall comes between them: they meet when their circles touch.
  Closed,   ///< A wall always does: they do not meet.
  Either,   ///< Sometimes.
};
Sight sight_between(const WalkableCells& floor, const SweptLine& a, const SweptLine& b) noexcept;

}  // namespace docent::crowd
