#include "tests/bench/zero_moment_point.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "runtime/motion/placement.h"
#include "runtime/motion/smoothing.h"
#include "tests/bench/measure.h"

namespace docent::bench {
namespace {

/// A segment's share of the body's mass, which lies so far from its first end to its second.
struct Segment {
  BodyPart from, to;
  double mass, middle;
};

using enum BodyPart;
constexpr std::array<Segment, 14> segments{{{Hips, Neck, 0.497, 0.5},
                                            {Neck, HeadTop, 0.081, 0.6},
                                            {LeftShoulder, LeftElbow, 0.028, 0.436},
                                            {RightShoulder, RightElbow, 0.028, 0.436},
                                            {LeftElbow, LeftWrist, 0.016, 0.430},
                                            {RightElbow, RightWrist, 0.016, 0.430},
                                            {LeftWrist, LeftHandTip, 0.006, 0.506},
                                            {RightWrist, RightHandTip, 0.006, 0.506},
                                            {LeftHip, LeftKnee, 0.100, 0.433},
                                            {RightHip, RightKnee, 0.100, 0.433},
                                            {LeftKnee, LeftAnkle, 0.0465, 0.433},
                                            {RightKnee, RightAnkle, 0.0465, 0.433},
                                            {LeftAnkle, LeftToeTip, 0.0145, 0.5},
                                            {RightAnkle, RightToeTip, 0.0145, 0.5}}};
constexpr double gravity = 9.81;     // metres a second squared
constexpr double smoothing = 0.022;  // seconds: a Gaussian that halves the power at 6 Hz  //
                                     // seconds: a Gaussian that halves the power at 4 Hz
constexpr double sole_half_width = 0.045, heel_behind_ankle = 0.055;  // metres
constexpr double ankle_is_down = 0.035, toe_is_down = 0.02;           // metres above their lowest

/// A segment's middle of mass on the floor and its height, smooth, by frame.
struct Mass {
  std::vector<double> x, y, height;
};

Mass mass_of(const TrackedMotion& motion, const Segment& segment) {
  Mass mass;
  for (std::size_t f = 0; f < motion.frames(); ++f) {
    const Vec3 place = glm::mix(motion.at(f, segment.from), motion.at(f, segment.to),
                                static_cast<float>(segment.middle));
    const Vec2 floor = to_floor(place);
    mass.x.push_back(floor.x);
    mass.y.push_back(floor.y);
    mass.height.push_back(static_cast<double>(place.y));
  }
  const std::vector<double> kernel = motion::gaussian_kernel(smoothing * motion.rate);
  for (std::vector<double>* values : {&mass.x, &mass.y, &mass.height})
    *values = motion::smooth_held(*values, kernel);
  return mass;
}

double acceleration(const std::vector<double>& values, std::size_t f, double rate) {
  return (values[f + 1] - 2 * values[f] + values[f - 1]) * rate * rate;
}

Vec2 zero_moment_point(const std::array<Mass, segments.size()>& masses, std::size_t f,
                       double rate) {
  Vec2 sum{};
  double weight = 0;
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const Mass& mass = masses[s];
    const double m = segments[s].mass;
    const double up = acceleration(mass.height, f, rate) + gravity;
    sum +=
        m * (up * Vec2{mass.x[f], mass.y[f]} -
             mass.height[f] * Vec2{acceleration(mass.x, f, rate), acceleration(mass.y, f, rate)});
    weight += m * up;
  }
  return sum / weight;
}

struct FootParts {
  BodyPart ankle, toe, tip;
};
constexpr std::array<FootParts, 2> feet{
    {{LeftAnkle, LeftToe, LeftToeTip}, {RightAnkle, RightToe, RightToeTip}}};

/// Above which a part is for 95 % of the time: how high it is while it rests on the ground.
float resting_height(const TrackedMotion& motion, BodyPart part) {
  std::vector<double> heights;
  for (std::size_t f = 0; f < motion.frames(); ++f)
    heights.push_back(static_cast<double>(motion.at(f, part).y));
  return static_cast<float>(quantile(heights, 0.05));
}

/// Adds the corners of what touches the ground of a foot: heel and ball of a flat foot, or one.
void add_sole(const TrackedMotion& motion, std::size_t f, const FootParts& foot, bool heel_down,
              bool toe_down, std::vector<Vec2>& corners) {
  const Vec2 ankle = to_floor(motion.at(f, foot.ankle)), toe = to_floor(motion.at(f, foot.toe)),
             tip = to_floor(motion.at(f, foot.tip));
  const Vec2 way = toe - ankle;
  const Vec2 ahead = glm::length(way) > 1e-6 ? glm::normalize(way) : Vec2{1, 0};
  const Vec2 across = sole_half_width * Vec2{-ahead.y, ahead.x};
  const auto add = [&](Vec2 place) {
    corners.push_back(place + across);
    corners.push_back(place - across);
  };
  if (heel_down) add(ankle - heel_behind_ankle * ahead);
  if (heel_down && !toe_down) add(ankle);
  if (toe_down) {
    add(toe);
    add(tip);
  }
}

/// From a point to the convex hull of others: the largest of the gaps seen along all directions.
double distance_to_hull(Vec2 point, const std::vector<Vec2>& corners) {
  constexpr int directions = 72;
  double widest = 0;
  for (int d = 0; d < directions; ++d) {
    const Vec2 along = motion::turned({1, 0}, d * 6.283185307179586 / directions);
    double reach = -std::numeric_limits<double>::infinity();
    for (const Vec2 corner : corners) reach = std::max(reach, glm::dot(corner, along));
    widest = std::max(widest, glm::dot(point, along) - reach);
  }
  return widest;
}

}  // namespace

std::vector<double> outside_the_feet(const TrackedMotion& motion) {
  std::array<Mass, segments.size()> masses;
  for (std::size_t s = 0; s < segments.size(); ++s) masses[s] = mass_of(motion, segments[s]);
  std::array<float, 2> ankle_rest{}, toe_rest{};
  for (std::size_t side = 0; side < 2; ++side) {
    ankle_rest[side] = resting_height(motion, feet[side].ankle);
    toe_rest[side] = resting_height(motion, feet[side].toe);
  }
  std::vector<double> distances;
  std::vector<Vec2> corners;
  const std::size_t margin = motion.frames_in(3 * smoothing);
  for (std::size_t f = margin; f + margin + 1 < motion.frames(); ++f) {
    if (!motion.is_walking[f]) continue;
    corners.clear();
    for (std::size_t side = 0; side < 2; ++side)
      add_sole(motion, f, feet[side],
               motion.at(f, feet[side].ankle).y < ankle_rest[side] + ankle_is_down,
               motion.at(f, feet[side].toe).y < toe_rest[side] + toe_is_down, corners);
    if (!corners.empty())
      distances.push_back(distance_to_hull(zero_moment_point(masses, f, motion.rate), corners));
  }
  return distances;
}

}  // namespace docent::bench
