#pragma once

#include <span>
#include <vector>

#include "runtime/model/geometry/polyline.h"
#include "runtime/model/geometry/vec2.h"
#include "runtime/motion/careful_place.h"

namespace docent::motion {

/// How briskly bends are taken.
struct TrackPace {
  double speed = 1.0;         ///< Metres a second, of the clips' ordinary walk.
  double turning_rate = 2.4;  ///< Radians a second that a walker turns at most.
  double first_share = 0;     ///< Share of the ordinary speed that a walker has at the track's
                              ///< beginning and cannot shed at once; 0 from standing.
  double most_share = 1;      ///< Share of the ordinary speed that is walked at most.
  double first_turn = 0;      ///< Radians between how the body moves and how the track begins.
  std::span<const CarefulPlace> careful{};  ///< Where it is slower.
};

/// Where the body's circle goes along a path, and which way it faces: the polyline with its corners
/// rounded (by at most 7 cm at a right angle and 8 cm at a full turn; a path along a circle of 0.5
/// m radius is missed by 1 cm), its two ends kept.
///
/// A walker takes shorter strides where the heading turns quickly, and nearly as many a second.
/// `effort` measures the track in metres of the clips' own stride: walking one metre of effort
/// covers `stride` metres.
struct PathTrack {
  double spacing = 0;           ///< Metres of path between samples.
  std::vector<Vec2> position;   ///< Floor frame.
  std::vector<double> heading;  ///< Radians, unwrapped.
  std::vector<double> stride;   ///< In (0, 1]: share of the clips' stride,
  std::vector<double> cadence;  ///< and of their cadence, likewise.
  std::vector<double> effort;   ///< Metres from the beginning; strictly increasing.

  double length() const noexcept { return spacing * static_cast<double>(position.size() - 1); }
};

/// A place on a track.
struct TrackPoint {
  Placement placement;
  double along = 0;  ///< Metres of path.
  double stride = 1, cadence = 1;
};

/// Needs at least two different points; coincident neighbours are harmless.
PathTrack make_path_track(std::span<const Vec2> path, const TrackPace& pace);

/// The place where `effort` metres have been walked, clamped to the ends. `hint` speeds up a walk
/// along the track: it holds the sample found last.
TrackPoint at_effort(const PathTrack& track, double effort, std::size_t& hint) noexcept;

/// The heading there alone, which a search asks for.
double heading_at_effort(const PathTrack& track, double effort, std::size_t& hint) noexcept;

}  // namespace docent::motion
