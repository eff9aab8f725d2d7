#include "content/object/profile.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "runtime/model/geometry/segment.h"

namespace docent::object {
namespace {

/// Points of one place are one, and a hair is nothing.
constexpr double same = 1e-6;

struct Joints {
  std::vector<Vec2> at;
  std::vector<std::size_t> given;  ///< Which of those given each is; the first of several.
  std::vector<std::size_t> joint_of_given;
};

/// Twice what the profile and the axis enclose: positive where it is on the left.
double doubled_area(std::span<const Vec2> profile) {
  double area = 0;
  for (std::size_t i = 0; i + 1 < profile.size(); ++i)
    area += (profile[i].x + profile[i + 1].x) * (profile[i + 1].y - profile[i].y);
  return area;
}

Joints joints_of(std::span<const Vec2> given) {
  Joints joints;
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (joints.at.empty() || glm::distance(joints.at.back(), given[i]) > same) {
      joints.at.push_back(given[i]);
      joints.given.push_back(i);
    }
    joints.joint_of_given.push_back(joints.at.size() - 1);
  }
  if (doubled_area(joints.at) < 0) {
    std::ranges::reverse(joints.at);
    std::ranges::reverse(joints.given);
    for (std::size_t& joint : joints.joint_of_given) joint = joints.at.size() - 1 - joint;
  }
  return joints;
}

double angle_between(Vec2 a, Vec2 b) {
  return std::abs(std::atan2(cross(a, b), dot(a, b)));
}

bool is_corner(const std::vector<Vec2>& at, std::size_t i) {
  const auto mirrored = [](Vec2 p) { return Vec2{-p.x, p.y}; };
  const bool is_first = i == 0, is_last = i + 1 == at.size();
  if ((is_first || is_last) && at[i].x > same) return true;  // a straight end meets it
  const Vec2 before = is_first ? mirrored(at[1]) : at[i - 1];
  const Vec2 after = is_last ? mirrored(at[i - 1]) : at[i + 1];
  return angle_between(at[i] - before, after - at[i]) > Profile::corner;
}

/// A piece of the curve, from p[1] to p[2].
struct Piece {
  std::array<Vec2, 4> p;
};

Piece piece_of(const std::vector<Vec2>& at, std::size_t i) {
  const auto beyond = [](Vec2 end, Vec2 inner) { return 2.0 * end - inner; };
  const auto mirrored = [](Vec2 p) { return Vec2{-p.x, p.y}; };
  const Vec2 a = at[i], b = at[i + 1];
  const Vec2 before = is_corner(at, i) ? beyond(a, b) : i == 0 ? mirrored(b) : at[i - 1];
  const Vec2 after = is_corner(at, i + 1) ? beyond(b, a)
                     : i + 2 == at.size() ? mirrored(a)
                                          : at[i + 2];
  return {{before, a, b, after}};
}

/// Barry and Goldman's pyramid with knots as far apart as the roots of the chords.
Vec2 on_curve(const Piece& piece, double share) {
  const auto& p = piece.p;
  std::array<double, 4> knot{};
  for (std::size_t i = 1; i < 4; ++i)
    knot[i] = knot[i - 1] + std::sqrt(std::max(glm::distance(p[i], p[i - 1]), same));
  const double t = knot[1] + share * (knot[2] - knot[1]);
  const auto mix = [&](Vec2 a, Vec2 b, std::size_t from, std::size_t to) {
    return ((knot[to] - t) * a + (t - knot[from]) * b) / (knot[to] - knot[from]);
  };
  const Vec2 a = mix(p[0], p[1], 0, 1), b = mix(p[1], p[2], 1, 2), c = mix(p[2], p[3], 2, 3);
  return mix(mix(a, b, 0, 2), mix(b, c, 1, 3), 1, 2);
}

/// Douglas and Peucker: adds what lies between, as far as it is off by more than the tolerance.
void add_between(std::span<const Vec2> fine, double tolerance, std::vector<Vec2>& points) {
  double farthest = tolerance;
  std::size_t at = 0;
  for (std::size_t i = 1; i + 1 < fine.size(); ++i)
    if (const double off = distance_to_segment(fine[i], fine.front(), fine.back());
        off > farthest) {
      farthest = off;
      at = i;
    }
  if (at == 0) return;
  add_between(fine.subspan(0, at + 1), tolerance, points);
  points.push_back(fine[at]);
  add_between(fine.subspan(at), tolerance, points);
}

Profile rounded(const Joints& joints, double tolerance) {
  constexpr int steps = 48;
  Profile profile;
  std::vector<std::size_t> of_joint{0};
  profile.points.push_back(joints.at.front());
  for (std::size_t i = 0; i + 1 < joints.at.size(); ++i) {
    const Piece piece = piece_of(joints.at, i);
    std::vector<Vec2> fine{joints.at[i]};
    // Between its ends it does not touch the axis.
    const double nearest = std::max(1e-3 * std::max(joints.at[i].x, joints.at[i + 1].x), same);
    for (int step = 1; step < steps; ++step) {
      fine.push_back(on_curve(piece, static_cast<double>(step) / steps));
      fine.back().x = std::max(fine.back().x, nearest);
    }
    fine.push_back(joints.at[i + 1]);
    add_between(fine, tolerance, profile.points);
    of_joint.push_back(profile.points.size());
    profile.points.push_back(joints.at[i + 1]);
  }
  for (const std::size_t joint : joints.joint_of_given) profile.of_point.push_back(of_joint[joint]);
  return profile;
}

/// The pieces of the outline with its straight ends, and after which joint each comes.
struct Outline {
  std::vector<Vec2> at;
  std::vector<std::size_t> joint;
};

Outline closed_outline(const Joints& joints, double tolerance) {
  const Profile profile = rounded(joints, tolerance);
  std::vector<std::size_t> place_of_joint(joints.at.size());
  for (std::size_t i = 0; i < joints.joint_of_given.size(); ++i)
    place_of_joint[joints.joint_of_given[i]] = profile.of_point[i];
  Outline outline;
  const auto add = [&](Vec2 p, std::size_t joint) {
    outline.at.push_back(p);
    outline.joint.push_back(joint);
  };
  if (profile.points.front().x > same) add({0, profile.points.front().y}, 0);
  std::size_t joint = 0;
  for (std::size_t i = 0; i < profile.points.size(); ++i) {
    while (joint + 1 < joints.at.size() && place_of_joint[joint + 1] <= i) ++joint;
    add(profile.points[i], joint);
  }
  if (profile.points.back().x > same) add({0, profile.points.back().y}, joints.at.size() - 1);
  return outline;
}

std::optional<ProfileFault> crossing_of(const Joints& joints, double longest) {
  const Outline outline = closed_outline(joints, longest / 1000);
  const auto& at = outline.at;
  const double near = 1e-4 * longest;
  for (std::size_t i = 0; i + 1 < at.size(); ++i)
    for (std::size_t j = i + 2; j + 1 < at.size(); ++j) {
      // Neighbours but for a short piece between them are near each other and do not cross.
      if (segment_distance_squared(at[i], at[i + 1], at[j], at[j + 1]) > near * near) continue;
      double between = 0;
      for (std::size_t k = i + 1; k < j; ++k) between += glm::distance(at[k], at[k + 1]);
      if (between < 3 * near) continue;
      const std::size_t first = joints.given[outline.joint[i]] + 1,
                        second = joints.given[outline.joint[j]] + 1;
      return ProfileFault{
          std::max(first, second) - 1,
          fmt::format("it touches or crosses itself near its points {} and {}",
                      std::min(first, second), std::max(first, second)),
          "write the points in the order of the outline: up the outside from the foot, and for a "
          "hollow vessel over the rim and down the inside"};
    }
  return {};
}

}  // namespace

double longest_side(std::span<const Vec2> profile) {
  double low = std::numeric_limits<double>::infinity(), high = -low, widest = 0;
  for (const Vec2 p : profile) {
    low = std::min(low, p.y);
    high = std::max(high, p.y);
    widest = std::max(widest, p.x);
  }
  return std::max(2 * widest, high - low);
}

std::optional<ProfileFault> fault_of(std::span<const Vec2> given) {
  const Joints joints = joints_of(given);
  if (joints.at.size() < 2)
    return ProfileFault{0, "it has one point, and an outline needs two or more",
                        "write [radius, height] in metres, from the foot up: [[0.10, 0], [0.18, "
                        "0.2], [0.08, 0.4]]"};
  if (given.size() > Profile::most_points)
    return ProfileFault{
        Profile::most_points,
        fmt::format("it has {} points, and at most {} are turned", given.size(),
                    Profile::most_points),
        "leave points out: what lies between them is rounded; or name a scan in 'model'"};
  const auto [low, high] = std::ranges::minmax(joints.at, {}, &Vec2::y);
  const double longest = longest_side(joints.at);
  if (high.y - low.y < 1e-3 * longest || high.y - low.y < 1e-3)
    return ProfileFault{0, "its heights go nowhere: it is flat",
                        "each point is [radius, height], in metres"};
  for (std::size_t i = 1; i + 1 < joints.at.size(); ++i)
    if (joints.at[i].x < same)
      return ProfileFault{joints.given[i],
                          "only its first and its last point may lie on the axis (radius 0)",
                          "give it a radius there, or leave the points behind it out"};
  if (auto crossing = crossing_of(joints, longest)) return crossing;
  if (doubled_area(joints.at) < 1e-4 * longest * longest)
    return ProfileFault{0, "it encloses next to nothing",
                        "radii come first: [radius, height], in metres"};
  return {};
}

Profile profile_of(std::span<const Vec2> given, double tolerance) {
  return rounded(joints_of(given), tolerance);
}

}  // namespace docent::object
