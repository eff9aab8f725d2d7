#include "content/motion/gait_cycle.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "content/import/motion/body.h"
#include "content/motion/extract_root_motion.h"

namespace docent::motion::offline {
namespace {

using enum BodyPart;
constexpr std::array<BodyPart, GaitCycle::joints> compared{
    Hips,      Chest,      Head,     LeftHip,      LeftKnee,  LeftAnkle, LeftToe,       RightHip,
    RightKnee, RightAnkle, RightToe, LeftShoulder, LeftElbow, LeftWrist, RightShoulder, RightElbow};

/// By how much the left ankle is before the right, in the direction in which the hips face; metres.
std::vector<double> leg_swing(const Skeleton& skeleton, const JointPositions& track,
                              std::size_t frames) {
  const std::size_t left = index_of(skeleton[LeftAnkle]), right = index_of(skeleton[RightAnkle]);
  std::vector<double> swing;
  double heading = 0;
  for (std::size_t f = 0; f < frames; ++f) {
    heading = hip_heading(skeleton, track, f, heading);
    const Vec2 apart = to_floor(track.at(f, left)) - to_floor(track.at(f, right));
    swing.push_back(apart.x * std::cos(heading) + apart.y * std::sin(heading));
  }
  return swing;
}

/// Where the left leg comes to the front, as frames with fractions. The leg counts as having been
/// behind when it was so by `clear`, so that shuffling on the spot is no stride.
std::vector<double> overtakings(const std::vector<double>& swing, double clear) {
  std::vector<double> frames;
  bool was_behind = false;
  double crossing = -1;
  for (std::size_t f = 1; f < swing.size(); ++f) {
    if (swing[f] < -clear) was_behind = true;
    if (swing[f - 1] < 0 && swing[f] >= 0)
      crossing = static_cast<double>(f) - swing[f] / (swing[f] - swing[f - 1]);
    if (swing[f] > clear && was_behind && crossing >= 0) {
      frames.push_back(crossing);
      was_behind = false;
    }
  }
  return frames;
}

GaitCycle sample_cycle(const Skeleton& skeleton, const MotionClip& clip,
                       const JointPositions& track, double first, double last) {
  GaitCycle cycle{.seconds = (last - first) / clip.frame_rate};
  const auto frame_at = [&](double part) {
    return std::min(static_cast<std::size_t>(std::lround(first + (last - first) * part)),
                    clip.root.size() - 1);
  };
  cycle.metres = glm::distance(to_floor(clip.root[frame_at(0)]), to_floor(clip.root[frame_at(1)]));
  for (std::size_t p = 0; p < GaitCycle::poses; ++p) {
    const std::size_t f = frame_at(static_cast<double>(p) / GaitCycle::poses);
    Vec2 middle{};
    std::size_t count = 0;
    for (const BodyPart part : compared)
      if (skeleton[part] != JointIndex::None) {
        middle += to_floor(track.at(f, index_of(skeleton[part])));
        ++count;
      }
    middle /= static_cast<double>(count);
    for (std::size_t j = 0; j < compared.size(); ++j) {
      if (skeleton[compared[j]] == JointIndex::None) continue;
      const Vec3 place = track.at(f, index_of(skeleton[compared[j]]));
      const Vec2 on_floor = to_floor(place) - middle;
      cycle.place[p][j] = {static_cast<float>(on_floor.x), static_cast<float>(on_floor.y), place.y};
    }
  }
  return cycle;
}

}  // namespace

std::vector<GaitCycle> find_gait_cycles(const Skeleton& skeleton, const MotionClip& clip,
                                        const JointPositions& track) {
  constexpr double shortest = 0.3, longest = 2.2;  // seconds: a sprint's stride, and a stealthy one
  std::vector<GaitCycle> cycles;
  if (skeleton[LeftAnkle] == JointIndex::None || skeleton[RightAnkle] == JointIndex::None)
    return cycles;
  const std::vector<double> starts =
      overtakings(leg_swing(skeleton, track, clip.root.size()), 0.1 * import::leg_length(skeleton));
  for (std::size_t i = 1; i < starts.size(); ++i) {
    const double seconds = (starts[i] - starts[i - 1]) / clip.frame_rate;
    if (seconds >= shortest && seconds <= longest)
      cycles.push_back(sample_cycle(skeleton, clip, track, starts[i - 1], starts[i]));
  }
  return cycles;
}

double unlikeness(const GaitCycle& a, const GaitCycle& b) {
  double sum = 0;
  for (std::size_t p = 0; p < GaitCycle::poses; ++p) {
    double own_a = 0, own_b = 0, dot = 0, cross = 0, height = 0;
    for (std::size_t j = 0; j < GaitCycle::joints; ++j) {
      const glm::dvec3 u(a.place[p][j]), v(b.place[p][j]);
      own_a += glm::dot(u, u);
      own_b += glm::dot(v, v);
      dot += u.x * v.x + u.y * v.y;
      cross += u.y * v.x - u.x * v.y;
      height += u.z * v.z;
    }
    // |a - s R b|2 = |a|2 - 2 s (hypot(dot, cross) + height) + s2 |b|2, least at s = (...) / |b|2.
    const double common = std::hypot(dot, cross) + height;
    const double left = own_b > 0 ? own_a - common * common / own_b : own_a;
    sum += std::sqrt(std::max(0.0, left) / GaitCycle::joints);
  }
  return sum;
}

std::size_t basic_gait(std::span<const GaitCycle> cycles) {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    double sum = 0;
    for (const GaitCycle& other : cycles) sum += unlikeness(cycles[i], other);
    if (sum < least) least = sum, best = i;
  }
  return best;
}

}  // namespace docent::motion::offline
