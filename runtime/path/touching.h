#pragma once

namespace docent::path {

/// What fits, for every kind of route: a disc of radius R may be where every wall is R away, or
/// nearer by no more than `touching`. So it passes a door that is narrower than 2 R by twice that,
/// keeping to the middle, and no narrower one. Metres.
///
/// Whoever asks whether there is room compares a clearance with `least_clearance`; whoever measures
/// a way or a place does so for R itself. Radius 0 is a point, which passes any door.
inline constexpr double touching = 1e-9;

/// How far from that limit rounding may decide. Metres, on floors within 10 km of their origin.
inline constexpr double rounding = 1e-11;

/// The smallest clearance at which a disc fits.
constexpr double least_clearance(double radius) noexcept {
  return radius - touching;
}

/// The radius of the circles about corners on which the shortest way of a disc bends. In a door, a
/// way that rolls on one side has to leave the least clearance to the other, so it rolls at just
/// that and not at R. Places on the circles are off by rounding, so they are `slack` farther out,
/// and what is tested against walls may be `slack` nearer than the least clearance: doors pass at
/// the very limit, and all else within `slack` of it. Arcs are told with R: as tangents grow by
/// what arcs lose, lengths are those of a disc of R but for the square of the difference.
constexpr double rolling_radius(double radius, double slack) noexcept {
  return radius == 0 ? 0 : least_clearance(radius) + slack;
}

}  // namespace docent::path
