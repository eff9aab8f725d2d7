#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "runtime/crowd/body.h"
#include "runtime/crowd/cells.h"

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

/// From when to when two circles overlap or touch if both keep their velocity; seconds from now.
struct Collision {
  double first = 0;  ///< 0 where they touch already.
  double last = 0;   ///< At most the horizon.
};

/// Two bodies as one that comes towards the other, which stands.
struct Approach {
  double beyond = 0;   ///< Distance squared less reach squared: positive where they are apart.
  double nearing = 0;  ///< Half of how fast the squared distance falls.
  double speed_squared = 0;
  double square = 0;  ///< Negative where the line of the drift passes outside of the reach.
};
inline Approach approach_of(const Body& a, const Body& b) noexcept {
  const Vec2 apart = b.position - a.position, drift = b.velocity - a.velocity;
  const double reach = a.radius + b.radius;
  const double speed_squared = dot(drift, drift);
  // No difference of squares of distances here: a near miss is decided by how far the line passes.
  const double beside = cross(apart, drift);
  return {dot(apart, apart) - reach * reach, -dot(apart, drift), speed_squared,
          speed_squared * reach * reach - beside * beside};
}
/// Do the circles surely not touch within the horizon? Without a branch, since most do not.
inline bool surely_miss(const Approach& approach, double horizon) noexcept {
  const bool is_apart = approach.beyond > 0;
  const bool is_slow = approach.beyond > 2 * horizon * approach.nearing;
  return is_apart & (is_slow | (approach.square < 0));
}

/// When the circles touch, walls or no walls. Touching with no speed to spare counts. The same for
/// (a, b) as for (b, a), to the last bit.
inline std::optional<Collision> contact_of_circles(const Body& a, const Body& b,
                                                   double horizon) noexcept {
  const Approach approach = approach_of(a, b);
  if (surely_miss(approach, horizon)) return {};
  const auto [beyond, nearing, speed_squared, square] = approach;
  const double root = std::sqrt(square > 0 ? square : 0.0);
  const double first = beyond > 0 ? beyond / (nearing + root) : 0;
  if (first > horizon) return {};
  const double last = speed_squared > 0 ? (nearing + root) / speed_squared : horizon;
  return Collision{first, std::min(std::max(last, first), horizon)};
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
