#include "content/motion/foot_plants.h"

#include <algorithm>
#include <cmath>

namespace docent::motion::offline {
namespace {

// Figures for an adult; measured on recorded walks, where planted toes drift by 5 to 9 cm/s and
// swinging ones reach 4 m/s.
constexpr double put_down_speed = 0.25, lift_speed = 0.55;     // m/s
constexpr double put_down_height = 0.025, lift_height = 0.05;  // metres above rest
constexpr double shortest_plant = 0.06, shortest_step = 0.04;  // seconds
constexpr double speed_span = 0.025;  // seconds over which a speed is taken, against jitter

double quantile(std::vector<double> values, double q) {
  if (values.empty()) return 0;
  const auto nth =
      values.begin() + static_cast<std::ptrdiff_t>(q * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, nth);
  return *nth;
}

struct ToeMotion {
  std::vector<double> height, speed;
};

ToeMotion toe_motion(const JointPositions& track, std::size_t toe, double frame_rate) {
  ToeMotion motion;
  const std::size_t frames = track.place.size() / track.joints;
  const std::size_t half = std::max<std::size_t>(1, frames_in(speed_span, frame_rate) / 2);
  for (std::size_t f = 0; f < frames; ++f) {
    const std::size_t a = f > half ? f - half : 0, b = std::min(f + half, frames - 1);
    const double seconds = static_cast<double>(std::max<std::size_t>(b - a, 1)) / frame_rate;
    motion.height.push_back(track.at(f, toe).y);
    motion.speed.push_back(glm::distance(track.at(a, toe), track.at(b, toe)) / seconds);
  }
  return motion;
}

/// Turns runs of `value` that are shorter than `frames`, and do not touch an end, into the other.
void drop_short_runs(std::vector<bool>& down, bool value, std::size_t frames) {
  for (std::size_t begin = 0; begin < down.size();) {
    std::size_t end = begin;
    while (end < down.size() && down[end] == down[begin]) ++end;
    if (down[begin] == value && begin > 0 && end < down.size() && end - begin < frames)
      std::fill(down.begin() + static_cast<std::ptrdiff_t>(begin),
                down.begin() + static_cast<std::ptrdiff_t>(end), !value);
    begin = end;
  }
}

std::vector<bool> plants_of(const ToeMotion& toe, double size, double frame_rate) {
  std::vector<double> slow_heights;
  for (std::size_t f = 0; f < toe.height.size(); ++f)
    if (toe.speed[f] < put_down_speed * size) slow_heights.push_back(toe.height[f]);
  const double rest = quantile(slow_heights, 0.3);

  std::vector<bool> down(toe.height.size());
  bool planted = false;
  for (std::size_t f = 0; f < down.size(); ++f) {
    const double high = toe.height[f] - rest;
    planted = planted ? toe.speed[f] < lift_speed * size && high < lift_height * size
                      : toe.speed[f] < put_down_speed * size && high < put_down_height * size;
    down[f] = planted && !slow_heights.empty();
  }
  drop_short_runs(down, false, frames_in(shortest_step, frame_rate));
  drop_short_runs(down, true, frames_in(shortest_plant, frame_rate));
  return down;
}

}  // namespace

void find_foot_plants(const Skeleton& skeleton, const JointPositions& track, MotionClip& clip) {
  clip.plants.assign(clip.root.size(), {});
  const double size = size_of(skeleton);
  const auto find = [&](BodyPart toe, bool FootPlants::* foot) {
    if (skeleton[toe] == JointIndex::None) return;
    const ToeMotion motion = toe_motion(track, index_of(skeleton[toe]), clip.frame_rate);
    const std::vector<bool> down = plants_of(motion, size, clip.frame_rate);
    for (std::size_t f = 0; f < down.size(); ++f) clip.plants[f].*foot = down[f];
  };
  find(BodyPart::LeftToe, &FootPlants::left);
  find(BodyPart::RightToe, &FootPlants::right);
}

double planted_height(const Skeleton& skeleton, const JointPositions& track,
                      const MotionClip& clip) {
  double sum = 0;
  int feet = 0;
  const auto add = [&](BodyPart toe, bool FootPlants::* foot) {
    std::vector<double> heights;
    for (std::size_t f = 0; f < clip.plants.size(); ++f)
      if (clip.plants[f].*foot) heights.push_back(track.at(f, index_of(skeleton[toe])).y);
    if (heights.empty()) return;
    sum += quantile(std::move(heights), 0.5);
    ++feet;
  };
  add(BodyPart::LeftToe, &FootPlants::left);
  add(BodyPart::RightToe, &FootPlants::right);
  return feet > 0 ? sum / feet : 0;
}

double rest_height(const Skeleton& skeleton, std::span<const double> heights) {
  constexpr double highest_rest = 0.09, usual_rest = 0.025;  // metres, of an adult's toe joint
  const double common = quantile({heights.begin(), heights.end()}, 0.5), size = size_of(skeleton);
  const bool plausible = common >= 0 && common < highest_rest * size;
  return plausible ? common : usual_rest * size;
}

void level_ground(double up, MotionClip& clip) {
  constexpr double least_move = 5e-4;  // Below it, a clip is as level as can be measured.
  if (std::abs(up) < least_move) return;
  for (Vec3& root : clip.root) root.y += static_cast<float>(up);
}

}  // namespace docent::motion::offline
