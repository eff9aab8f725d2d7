#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>

#include "runtime/motion/path_track.h"
#include "runtime/motion/placement.h"
#include "runtime/motion/search.h"
#include "runtime/motion/smoothing.h"
#include "runtime/motion/walk_graph.h"

namespace docent::motion {

/// Followers: what a search knows of a body on its way along a track, which is how far it has come,
/// how it misses the track, and what that costs. Headings in radians, floor frame.

/// Follows a track that the motion will be warped onto: `progress` is metres of effort, and the
/// heading error fades over the distance in which a warp takes it up.
struct WarpedFollower {
  static constexpr std::size_t beam_width = 6;
  static constexpr std::size_t groping = 2;   ///< Times as wide a beam where nothing is foreseen.
  static constexpr double same_moment = 0.1;  ///< Seconds within which clips go on alike.
  static constexpr std::size_t slice = warped_slice;
  static constexpr double forgetting = 0.7;  ///< Metres.
  static constexpr double fair_cost = 0.03;  ///< Per metre, as with the heading off by 10 degrees.

  double progress = 0;
  double heading_error = 0;
  double track_heading = 0;  ///< At `progress`.
  std::size_t hint = 0;

  WarpedFollower(const WalkGraph&, const PathTrack& track, const MotionStart& start) noexcept
      : heading_error(wrap_angle(start.body.heading - track.heading.front())),
        track_heading(track.heading.front()) {}

  void enter(const Placement&) noexcept {}

  /// Goes from one frame of a clip to another; returns what the misfit on the way costs.
  double advance(const PathTrack& track, const ClipPath& clip, std::size_t from,
                 std::size_t to) noexcept {
    const double step = clip.effort[to] - clip.effort[from];
    progress += step;
    const double heading = heading_at_effort(track, progress, hint);
    heading_error += clip.body[to].heading - clip.body[from].heading - (heading - track_heading);
    heading_error *= forgetting / (forgetting + step);
    track_heading = heading;
    return heading_error * heading_error * step;
  }

  static double total(const PathTrack& track) noexcept { return track.effort.back(); }
  static double progress_at(const PathTrack& track, std::size_t sample) noexcept {
    return track.effort[sample];
  }
  /// A motion that stands at the end is judged by its progress alone.
  static constexpr double gap_cost = 0;
  double end_gap(const PathTrack&, const ClipPath&) const noexcept { return 0; }
  std::uint32_t likeness() const noexcept { return 0; }

  static const std::vector<std::uint16_t>& table(const Foresight& foresight) noexcept {
    return foresight.warped;
  }
  /// Where to look in a table of foresight.
  struct Misfit {
    GridAxis::Place turn;
    double foreseen(const std::uint16_t* of_bend) const noexcept { return value_at(of_bend, turn); }
  };
  Misfit misfit() const noexcept { return {turn_axis.place(heading_error)}; }
};

/// Follows a track with the clips' own motion: `progress` is metres of path.
struct RawFollower {
  static constexpr std::size_t beam_width = 20;
  static constexpr std::size_t groping = 1;
  static constexpr double same_moment = 0;
  static constexpr std::size_t slice = raw_slice;
  static constexpr double side_weight = 6.0;     ///< Square radians per square metre.
  static constexpr double heading_weight = 0.3;  ///< Of square radians.
  static constexpr double fair_cost = 0.15;      ///< Per metre, as when 16 cm to the side.
  static constexpr double look_ahead = 0.3;      ///< Metres: the nearest sample is not farther on.

  double progress = 0;
  Placement clip_to_floor;  ///< Lays the present clip onto the floor.
  Vec2 east{1, 0};          ///< The clip's east as the floor sees it.
  double side_error = 0;    ///< Metres to the left of the track.
  double heading_error = 0;
  std::size_t at = 0;  ///< Sample of the track that is nearest.

  RawFollower(const WalkGraph& graph, const PathTrack& track, const MotionStart& start) noexcept {
    const Placement body = graph.clip[start.frame.clip].body[start.frame.frame];
    lay(compose(start.body, inverse(body)));
    find_nearest(track, start.body, 0);
  }

  /// Lays the clip that a transition leads to onto the floor.
  void enter(const Placement& alignment) noexcept { lay(on_floor(alignment)); }
  void lay(const Placement& to_floor) noexcept {
    clip_to_floor = {to_floor.position, wrap_angle(to_floor.heading)};
    east = {std::cos(to_floor.heading), std::sin(to_floor.heading)};
  }
  Placement on_floor(const Placement& body) const noexcept {
    const Vec2 p = body.position;
    return {clip_to_floor.position + p.x * east + p.y * Vec2{-east.y, east.x},
            clip_to_floor.heading + body.heading};
  }

  void find_nearest(const PathTrack& track, const Placement& body, double walked) noexcept {
    const auto squared = [&](std::size_t i) {
      const Vec2 away = body.position - track.position[i];
      return dot(away, away);
    };
    const std::size_t end = track.position.size() - 1;
    const std::size_t last =
        std::min(at + static_cast<std::size_t>(look_ahead / track.spacing), end);
    const std::size_t from = at;
    at = std::min(at + static_cast<std::size_t>(walked / track.spacing), last);
    double least = squared(at);
    const auto step = [&](std::size_t to) {
      const double d = squared(to);
      if (d > least) return false;
      least = d;
      at = to;
      return true;
    };
    if (at < last && step(at + 1))
      while (at < last && step(at + 1)) {
      }
    else
      while (at > from && step(at - 1)) {
      }
    progress = track.spacing * static_cast<double>(at);
    const std::size_t before = std::min(at, end - 1);
    const Vec2 along = track.position[before + 1] - track.position[before];
    side_error = std::copysign(std::sqrt(least), cross(along, body.position - track.position[at]));
    heading_error = body.heading - track.heading[at];
    if (std::abs(heading_error) > std::numbers::pi) heading_error = wrap_angle(heading_error);
  }

  double advance(const PathTrack& track, const ClipPath& clip, std::size_t from,
                 std::size_t to) noexcept {
    const double step = clip.effort[to] - clip.effort[from];
    find_nearest(track, on_floor(clip.body[to]), step);
    return (side_weight * side_error * side_error +
            heading_weight * heading_error * heading_error) *
           step;
  }

  static double total(const PathTrack& track) noexcept { return track.length(); }
  static double progress_at(const PathTrack& track, std::size_t sample) noexcept {
    return track.spacing * static_cast<double>(sample);
  }
  /// A motion that runs past the path's end makes no further progress: what counts is where it
  /// ends.
  static constexpr double gap_cost = 8.0;  ///< Per square metre.
  double end_gap(const PathTrack& track, const ClipPath& clip) const noexcept {
    return glm::distance(on_floor(clip.body[clip.last]).position, track.position.back());
  }
  std::uint32_t likeness() const noexcept {
    const auto cell = [](double value, double size) {  // rounded; for what is above -128 cells
      return static_cast<std::uint32_t>(std::max(0.0, value / size + 128.5)) & 255u;
    };
    return cell(side_error, 0.04) << 8 | cell(heading_error, 0.08);
  }

  static const std::vector<std::uint16_t>& table(const Foresight& foresight) noexcept {
    return foresight.raw;
  }
  struct Misfit {
    GridAxis::Place side, turn;
    double foreseen(const std::uint16_t* of_bend) const noexcept {
      return foreseen_raw(of_bend, side, turn);
    }
  };
  Misfit misfit() const noexcept {
    return {side_axis.place(side_error), turn_axis.place(heading_error)};
  }
};

}  // namespace docent::motion
