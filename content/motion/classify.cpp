#include "content/motion/classify.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "content/import/motion/body.h"
#include "content/motion/extract_root_motion.h"

namespace docent::motion::offline {
namespace {

// Speeds of adults, m/s. Walking ends, and running begins, at about 2 m/s (Bertram 2005).
constexpr double slowest_walk = 0.35, fastest_walk = 2.2;
constexpr double least_turn = 20 * std::numbers::pi / 180;
// A walk always has a foot on the ground. By toes and heels brisk walks come to 0.04, runs that
// stop suddenly to 0.19, jogs to 0.39 and more (by the toes' plants alone brisk walks to 0.28).
constexpr double most_airborne = 0.12;
constexpr double most_astray = 0.2;
constexpr double crouching = 0.75;  // Hips lower than this share of the leg's length.

/// Metres a second from one frame to another, straight.
double speed_between(const MotionClip& clip, std::size_t first, std::size_t last) {
  if (last <= first) return 0;
  return glm::distance(to_floor(clip.root[first]), to_floor(clip.root[last])) * clip.frame_rate /
         static_cast<double>(last - first);
}

/// Does the body move more than 45 degrees away from where it faces?
bool moves_astray(const std::vector<Placement>& body, std::size_t frame) {
  const std::size_t before = frame > 0 ? frame - 1 : frame;
  const std::size_t after = std::min(frame + 1, body.size() - 1);
  const Vec2 way = body[after].position - body[before].position;
  const Vec2 faces{std::cos(body[frame].heading), std::sin(body[frame].heading)};
  return dot(way, faces) < std::sqrt(0.5) * glm::length(way);
}

double median_of(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

}  // namespace

/// In which frames is a foot on the ground by its heel? At heel strike the ankle is a little above
/// where it is when the foot is flat, and has stopped; in the air it is high or fast.
std::vector<bool> stands_on_heel(const Skeleton& skeleton, const JointPositions& track,
                                 BodyPart ankle, double frame_rate) {
  constexpr double highest = 0.04, fastest = 0.8;  // metres above rest, m/s, of an adult
  const std::size_t frames = track.place.size() / track.joints;
  std::vector<bool> down(frames);
  if (skeleton[ankle] == JointIndex::None) return down;
  const std::size_t joint = index_of(skeleton[ankle]);
  std::vector<float> heights;
  for (std::size_t f = 0; f < frames; ++f) heights.push_back(track.at(f, joint).y);
  std::ranges::nth_element(heights, heights.begin() + static_cast<std::ptrdiff_t>(frames / 10));
  const double rest = heights[frames / 10], size = size_of(skeleton);
  for (std::size_t f = 0; f < frames; ++f) {
    const std::size_t before = f > 0 ? f - 1 : f, after = std::min(f + 1, frames - 1);
    const double speed = glm::distance(track.at(before, joint), track.at(after, joint)) *
                         frame_rate / static_cast<double>(std::max<std::size_t>(after - before, 1));
    down[f] = track.at(f, joint).y < rest + highest * size && speed < fastest * size;
  }
  return down;
}

ClipMeasures measure_clip(const Skeleton& skeleton, const MotionClip& clip,
                          const JointPositions& track) {
  const std::vector<Placement> body = extract_root_motion(skeleton, clip, track);
  const std::vector<double> speed = body_speed(body, clip.frame_rate);
  const double size = size_of(skeleton), leg = import::leg_length(skeleton);
  const std::size_t frames = speed.size();
  const std::size_t quarter = std::min<std::size_t>(frames - 1, frames_in(0.25, clip.frame_rate));

  ClipMeasures measures{.first_speed = speed_between(clip, 0, quarter),
                        .last_speed = speed_between(clip, frames - 1 - quarter, frames - 1),
                        .turned = body.back().heading - body.front().heading};
  const auto left = stands_on_heel(skeleton, track, BodyPart::LeftAnkle, clip.frame_rate);
  const auto right = stands_on_heel(skeleton, track, BodyPart::RightAnkle, clip.frame_rate);
  std::vector<double> moving, hips, moving_hips;
  std::size_t airborne = 0, astray = 0;
  for (std::size_t f = 0; f < frames; ++f) {
    hips.push_back(track.at(f, 0).y);
    if (speed[f] < standing_speed * size) continue;
    moving.push_back(speed[f]);
    moving_hips.push_back(hips.back());
    airborne += !clip.plants[f].left && !clip.plants[f].right && !left[f] && !right[f];
    astray += moves_astray(body, f);
  }
  if (leg > 0) measures.lowest_hips = std::ranges::min(hips) / leg;
  if (!moving.empty()) {
    measures.airborne = static_cast<double>(airborne) / static_cast<double>(moving.size());
    measures.astray = static_cast<double>(astray) / static_cast<double>(moving.size());
    measures.typical_speed = median_of(moving);
    if (leg > 0) measures.typical_hips = median_of(moving_hips) / leg;
  }
  return measures;
}

ClipRole classify(const ClipMeasures& m, double size) {
  const bool walks = std::string_view(motion_class_of(m, size)) != "other";
  const bool stands_first = m.first_speed < standing_speed * size;
  const bool stands_last = m.last_speed < standing_speed * size;
  if (!walks || (stands_first && stands_last)) return ClipRole::Other;
  if (stands_first) return ClipRole::Start;
  if (stands_last) return ClipRole::Stop;
  if (m.turned > least_turn) return ClipRole::TurnLeft;
  return m.turned < -least_turn ? ClipRole::TurnRight : ClipRole::Walk;
}

const char* motion_class_of(const ClipMeasures& m, double size) {
  // Figures for adults: brisk walks were recorded at 1.5 to 1.7 m/s, ordinary ones at 0.9 to 1.3,
  // jogs at 2.1 to 2.6, runs from 3.1 m/s on; stealthy ones at 0.4 with hips 10 % lower than usual.
  constexpr double brisk = 1.4, running = 2.8, slow = 0.65, low_hips = 1.1;
  const double speed = m.typical_speed / size;
  if (speed < slowest_walk || m.astray > most_astray || m.lowest_hips < crouching) return "other";
  if (m.airborne >= most_airborne || speed >= fastest_walk) {
    // Who flies and is slow climbs or hops.
    if (speed < brisk) return "other";
    return speed < running ? "jog" : "run";
  }
  if (speed < slow && m.typical_hips < low_hips) return "stealthy-walk";
  return speed < brisk ? "walk" : "brisk-walk";
}

const char* name_of(ClipRole role) {
  switch (role) {
    case ClipRole::Walk:
      return "walk";
    case ClipRole::Start:
      return "start";
    case ClipRole::Stop:
      return "stop";
    case ClipRole::TurnLeft:
      return "turn-left";
    case ClipRole::TurnRight:
      return "turn-right";
    case ClipRole::Other:
      break;
  }
  return "other";
}

}  // namespace docent::motion::offline
