#include "runtime/motion/path_track.h"

#include <algorithm>
#include <cmath>

#include "runtime/motion/smoothing.h"

namespace docent::motion {
namespace {

constexpr double sample_spacing = 0.02;    // metres
constexpr double corner_rounding = 0.10;   // metres: standard deviation of the positions' bell
constexpr double heading_rounding = 0.22;  // metres: a walker begins to turn before the corner
constexpr double slowest = 0.2;            // share of the clips' speed
constexpr double least_cadence = 0.95;     // share of the clips' where a walker is slowest: people
                                           // turn by short steps, not by slow ones
constexpr double bend_acceleration = 1.5;  // metres a second squared that a body turns by
constexpr double joining_way = 0.7;        // metres in which a moving body gets onto its track,
constexpr double joining_care = 0.6;       // slower by this share for each radian that it turns
constexpr double braking = 1.2;            // metres a second squared

std::vector<Vec2> resample(std::span<const Vec2> path, std::size_t intervals) {
  const double step = polyline_length(path) / static_cast<double>(intervals);
  std::vector<Vec2> out;
  out.reserve(intervals + 1);
  double walked = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double length = glm::distance(path[i - 1], path[i]);
    while (out.size() < intervals && static_cast<double>(out.size()) * step <= walked + length) {
      const double t = length > 0 ? (static_cast<double>(out.size()) * step - walked) / length : 0;
      out.push_back(glm::mix(path[i - 1], path[i], std::clamp(t, 0.0, 1.0)));
    }
    walked += length;
  }
  out.resize(intervals + 1, path.back());
  return out;
}

std::vector<double> headings(std::span<const Vec2> points) {
  std::vector<double> out(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t from = i + 1 < points.size() ? i : i - 1;
    const Vec2 step = points[from + 1] - points[from];
    out[i] = glm::length(step) > 1e-9 ? std::atan2(step.y, step.x) : (i > 0 ? out[i - 1] : 0.0);
  }
  unwrap_angles(out);
  return out;
}

/// Speed as a share of the ordinary one: what the bend allows, and what a walker can slow down to
/// in time.
std::vector<double> speed_shares(const PathTrack& track, const TrackPace& pace) {
  const std::size_t count = track.heading.size();
  std::vector<double> share(count, 1.0);
  std::ranges::fill(share, std::clamp(pace.most_share, slowest, 1.0));
  for (std::size_t next = 1; next < count; ++next) {
    const double bend = std::abs(track.heading[next] - track.heading[next - 1]) / track.spacing;
    if (bend * pace.speed > pace.turning_rate)
      share[next - 1] =
          std::min(share[next - 1], std::max(slowest, pace.turning_rate / (bend * pace.speed)));
  }
  const std::vector<double> direction = headings(track.position);
  for (std::size_t next = 1; next < count; ++next) {
    const double bend = std::abs(direction[next] - direction[next - 1]) / track.spacing;
    const double fastest = std::sqrt(bend_acceleration / std::max(bend, 1e-6)) / pace.speed;
    share[next - 1] = std::min(share[next - 1], std::max(slowest, fastest));
  }
  for (const CarefulPlace& place : pace.careful)
    for (std::size_t i = 0; i < count; ++i)
      if (glm::distance(track.position[i], place.at) < place.radius)
        share[i] = std::min(share[i], std::max(slowest, place.share));
  const double careful = std::max(0.5, 1 - joining_care * std::abs(pace.first_turn));
  const auto joining = static_cast<std::size_t>(joining_way / track.spacing);
  for (std::size_t i = 0; i < std::min(joining, count); ++i) share[i] = std::min(share[i], careful);
  const double gain = 2 * braking * track.spacing / (pace.speed * pace.speed);
  const auto limit = [&](std::size_t i, double neighbour) {
    share[i] = std::min(share[i], std::sqrt(neighbour * neighbour + gain));
  };
  for (std::size_t i = 1; i < count; ++i) limit(i, share[i - 1]);
  for (std::size_t i = count - 1; i-- > 0;) limit(i, share[i + 1]);
  double momentum = pace.first_share * pace.first_share;
  for (std::size_t i = 0; i < count && momentum > slowest * slowest; ++i, momentum -= gain)
    share[i] = std::max(share[i], std::sqrt(momentum));
  return smooth_held(share, gaussian_kernel(0.08 / track.spacing));
}

}  // namespace

PathTrack make_path_track(std::span<const Vec2> path, const TrackPace& pace) {
  const double length = polyline_length(path);
  const auto intervals =
      std::max<std::size_t>(8, static_cast<std::size_t>(std::ceil(length / sample_spacing)));
  PathTrack track;
  track.spacing = length / static_cast<double>(intervals);
  const std::vector<Vec2> points = resample(path, intervals);
  const auto kernel_over = [&](double metres) {
    return gaussian_kernel(std::min(metres, length / 6) / track.spacing);
  };
  track.position = smooth_pinned(points, kernel_over(corner_rounding));
  track.heading = smooth_held(headings(points), kernel_over(heading_rounding));
  track.stride = speed_shares(track, pace);
  for (double& share : track.stride) {
    track.cadence.push_back(least_cadence + (1 - least_cadence) * share);
    share /= track.cadence.back();
  }
  track.effort.resize(track.stride.size());
  for (std::size_t i = 1; i < track.effort.size(); ++i)
    track.effort[i] =
        track.effort[i - 1] + 2 * track.spacing / (track.stride[i - 1] + track.stride[i]);
  return track;
}

namespace {

/// How far an effort is from the sample that it comes after, as a share of the way to the next.
double share_after(const PathTrack& track, double effort, std::size_t& sample) noexcept {
  const std::size_t last = track.effort.size() - 1;
  std::size_t i = std::min(sample, last - 1);
  while (i > 0 && track.effort[i] > effort) --i;
  while (i + 1 < last && track.effort[i + 1] <= effort) ++i;
  sample = i;
  return std::clamp((effort - track.effort[i]) / (track.effort[i + 1] - track.effort[i]), 0.0, 1.0);
}

}  // namespace

double heading_at_effort(const PathTrack& track, double effort, std::size_t& hint) noexcept {
  const double t = share_after(track, effort, hint);
  return glm::mix(track.heading[hint], track.heading[hint + 1], t);
}

TrackPoint at_effort(const PathTrack& track, double effort, std::size_t& hint) noexcept {
  const double t = share_after(track, effort, hint);
  const std::size_t i = hint;
  TrackPoint point;
  point.placement.position = glm::mix(track.position[i], track.position[i + 1], t);
  point.placement.heading = glm::mix(track.heading[i], track.heading[i + 1], t);
  point.along = track.spacing * (static_cast<double>(i) + t);
  point.stride = glm::mix(track.stride[i], track.stride[i + 1], t);
  point.cadence = glm::mix(track.cadence[i], track.cadence[i + 1], t);
  return point;
}

}  // namespace docent::motion
