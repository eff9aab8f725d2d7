#include "content/motion/find_transitions.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>
#include <tuple>

namespace docent {
namespace {

struct ClipPair {
  std::uint32_t a = 0, b = 0;
};

/// Two clips and what is known of them, in frames.
struct Comparison {
  const MotionClip& a;
  const MotionClip& b;
  const DistanceMatrix& distance;
  bool same_clip = false;
  std::uint32_t radius = 0, least_radius = 0, apart = 0;
  double threshold = 0;
};

/// A frame of each clip that could be one moment.
struct Meeting {
  std::uint32_t a = 0, b = 0;
};

/// Is no other pair of frames nearby closer? Of equal ones the first counts.
bool is_local_minimum(const Comparison& c, std::uint32_t i, std::uint32_t j) {
  const float here = c.distance.at(i, j);
  const auto from = [&](std::uint32_t f) { return f > c.apart ? f - c.apart : 0; };
  const auto to = [&](std::uint32_t f, std::size_t frames) {
    return std::min<std::size_t>(f + c.apart + 1, frames);
  };
  for (std::size_t y = from(i); y < to(i, c.distance.rows); ++y)
    for (std::size_t x = from(j); x < to(j, c.distance.columns); ++x) {
      const float other = c.distance.at(y, x);
      const bool earlier = std::tuple(y, x) < std::tuple<std::size_t, std::size_t>(i, j);
      if (other < here || (other == here && earlier)) return false;
    }
  return true;
}

/// Frames that a blend may reach to both sides of `frame` without leaving its clip.
std::uint32_t room_at(const MotionClip& clip, std::uint32_t frame) {
  return std::min(frame, frame_count(clip) - 1 - frame);
}

/// Do the same feet stand in the middle, and for most of the blend?
bool same_feet(const Comparison& c, Meeting at, std::uint32_t radius) {
  const auto alike = [&](std::uint32_t i, std::uint32_t j) {
    return c.a.plants[i].left == c.b.plants[j].left && c.a.plants[i].right == c.b.plants[j].right;
  };
  if (!alike(at.a, at.b)) return false;
  std::uint32_t same = 0;
  for (std::uint32_t k = 0; k <= 2 * radius; ++k)
    same += alike(at.a - radius + k, at.b - radius + k);
  return 5 * same >= 4 * (2 * radius + 1);
}

std::vector<Meeting> find_meetings(const Comparison& c) {
  std::vector<Meeting> meetings;
  for (std::uint32_t i = c.least_radius; i + c.least_radius < c.distance.rows; ++i)
    for (std::uint32_t j = c.least_radius; j + c.least_radius < c.distance.columns; ++j) {
      // Within a clip, pairs mirror each other, and a passage is not taken for its own neighbour.
      if (c.same_clip && j < i + 2 * c.radius) continue;
      if (static_cast<double>(c.distance.at(i, j)) >= c.threshold) continue;
      if (is_local_minimum(c, i, j)) meetings.push_back({i, j});
    }
  return meetings;
}

bool touches_fault(const std::vector<CaptureFault>& faults, std::uint32_t frame,
                   std::uint32_t radius) {
  return std::ranges::any_of(faults, [&](const CaptureFault& fault) {
    return frame + radius >= fault.first && frame <= fault.last + radius;
  });
}

/// The rigid motion that undoes another.
Placement inverse(const Placement& p) {
  const double c = std::cos(p.heading), s = std::sin(p.heading);
  return {.position = {-(c * p.position.x + s * p.position.y), s * p.position.x - c * p.position.y},
          .heading = -p.heading};
}

std::vector<Transition> transitions_between(ClipPair pair, const std::vector<MotionClip>& clips,
                                            const StudiedClips& studied, double threshold,
                                            const TransitionOptions& options) {
  const MotionClip &a = clips[pair.a], &b = clips[pair.b];
  const PoseCloud &cloud_a = studied.cloud[pair.a], &cloud_b = studied.cloud[pair.b];
  const std::uint32_t radius = frames_in(options.radius, a.frame_rate);
  const DistanceMatrix distance = measure_distances(cloud_a, cloud_b, radius);
  const Comparison comparison{.a = a,
                              .b = b,
                              .distance = distance,
                              .same_clip = pair.a == pair.b,
                              .radius = radius,
                              .least_radius = (radius + 1) / 2,
                              .apart = frames_in(options.apart, a.frame_rate),
                              .threshold = threshold};
  std::vector<Transition> found;
  for (const Meeting at : find_meetings(comparison)) {
    const std::uint32_t fits = std::min({radius, room_at(a, at.a), room_at(b, at.b)});
    if (!same_feet(comparison, at, fits) || touches_fault(studied.faults[pair.a], at.a, fits) ||
        touches_fault(studied.faults[pair.b], at.b, fits))
      continue;
    const PoseMatch match = compare_poses(cloud_a, at.a, cloud_b, at.b, radius);
    const Transition there{.from = {pair.a, at.a},
                           .to = {pair.b, at.b},
                           .radius = fits,
                           .distance = static_cast<float>(match.distance),
                           .alignment = match.alignment};
    found.push_back(there);
    found.push_back({.from = there.to,
                     .to = there.from,
                     .radius = fits,
                     .distance = there.distance,
                     .alignment = inverse(there.alignment)});
  }
  return found;
}

std::vector<ClipPair> all_pairs(std::uint32_t clips) {
  std::vector<ClipPair> pairs;
  for (std::uint32_t a = 0; a < clips; ++a)
    for (std::uint32_t b = a; b < clips; ++b) pairs.push_back({a, b});
  return pairs;
}

}  // namespace

double alike_threshold(const std::vector<MotionClip>& clips, const StudiedClips& studied,
                       const TransitionOptions& options) {
  std::vector<double> covered;
  for (std::size_t c = 0; c < clips.size(); ++c) {
    const std::size_t lag = frames_in(options.alike_within, clips[c].frame_rate);
    const std::size_t half = frames_in(options.radius, clips[c].frame_rate);
    const std::size_t step = frames_in(0.05, clips[c].frame_rate);
    for (std::size_t f = 0; f + lag < studied.cloud[c].frames; f += step)
      covered.push_back(
          compare_poses(studied.cloud[c], f, studied.cloud[c], f + lag, half).distance);
  }
  if (covered.empty()) return 0;
  const auto middle = covered.begin() + static_cast<std::ptrdiff_t>(covered.size() / 2);
  std::ranges::nth_element(covered, middle);
  return *middle;
}

std::vector<Transition> find_transitions(const std::vector<MotionClip>& clips,
                                         const StudiedClips& studied, double threshold,
                                         const TransitionOptions& options, unsigned jobs) {
  const std::vector<ClipPair> pairs = all_pairs(static_cast<std::uint32_t>(clips.size()));
  std::vector<std::vector<Transition>> found(pairs.size());
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t p = next++; p < pairs.size(); p = next++)
      found[p] = transitions_between(pairs[p], clips, studied, threshold, options);
  };
  {
    std::vector<std::jthread> helpers;
    for (unsigned i = 1; i < jobs; ++i) helpers.emplace_back(work);
    work();
  }
  std::vector<Transition> all;
  for (const auto& some : found) all.insert(all.end(), some.begin(), some.end());
  std::ranges::sort(all, {}, [](const Transition& t) {
    return std::tuple(t.from.clip, t.from.frame, t.to.clip, t.to.frame);
  });
  return all;
}

}  // namespace docent
