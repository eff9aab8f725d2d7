#include "runtime/motion/speed_limit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/gtc/quaternion.hpp>
#include <span>
#include <utility>

#include "runtime/motion/smoothing.h"
#include "runtime/motion/walk_graph.h"

namespace docent::motion {
namespace {

constexpr double plausible = 1.14;  // times the quickest that was recorded
constexpr double slowing_seconds =
    0.09;                             // half of the time in which a walk slows down, or picks up
constexpr double still_joint = 0.05;  // radians a second: of joints that recordings do not move
constexpr std::array calming_seconds{0.1, 0.2, 0.4, 0.8};  // over which a joint's motion is spread

/// The squared distance of two rotations in quaternion space: the square of half their angle, to
/// within a hundredth where that is below 20 degrees. Unlike the angle itself it costs no arc.
float squared_half_angle(const Quat& a, const Quat& b) noexcept {
  const float w = a.w - b.w, x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
  const float apart = w * w + x * x + y * y + z * z;
  return std::min(apart, 4 - apart);  // q and -q are one rotation
}

/// Metres a second.
template <typename Motion>
double quickest_root(const Motion& motion) {
  double square = 0;
  for (std::size_t f = 1; f < motion.root.size(); ++f) {
    const Vec3 step = motion.root[f] - motion.root[f - 1];
    square = std::max(square, static_cast<double>(glm::dot(step, step)));
  }
  return std::sqrt(square) * motion.frame_rate;
}

/// What the steps between frames are measured by: their squares at the limit.
struct StepLimits {
  float root = 0;
  std::vector<float> joint;

  StepLimits(const QuickestMotion& quickest, double frame_rate) {
    const auto squared = [&](double speed) {
      return static_cast<float>(std::pow(plausible * speed / frame_rate, 2));
    };
    root = squared(quickest.root);
    for (const double turning : quickest.joint)
      joint.push_back(squared(std::max(turning, still_joint) / 2));
  }
};

/// Where a walk is too quick.
struct Haste {
  std::vector<double> excess;  ///< Of the step from each frame to the next: how many times; 1 where
                               ///< it is not.
  std::vector<bool> joint;     ///< Whether it is, anywhere.
};

/// Is any joint's step too long? Without a branch, as it is asked of every frame.
bool is_any_too_long(const Quat* now, const Quat* next, const std::vector<float>& limit) noexcept {
  unsigned is_any = 0;
  for (std::size_t j = 0; j < limit.size(); ++j)
    is_any |= squared_half_angle(now[j], next[j]) > limit[j] ? 1U : 0U;
  return is_any != 0;
}

/// Looks at the root and at all joints that `counts` names; the others are only told of.
Haste find_haste(const StepLimits& limits, const std::vector<bool>& counts, const Walk& walk) {
  const std::size_t joints = walk.joint_count;
  Haste haste{std::vector<double>(walk.root.size() - 1, 1.0), std::vector<bool>(joints)};
  const auto exceed = [&](std::size_t f, float squared_step, float limit) {
    haste.excess[f] = std::max(haste.excess[f], std::sqrt(double{squared_step} / double{limit}));
  };
  for (std::size_t f = 0; f < haste.excess.size(); ++f) {
    const Vec3 step = walk.root[f + 1] - walk.root[f];
    if (const float square = glm::dot(step, step); square > limits.root)
      exceed(f, square, limits.root);
    const Quat* now = walk.rotation.data() + f * joints;
    if (!is_any_too_long(now, now + joints, limits.joint)) continue;
    for (std::size_t j = 0; j < joints; ++j) {
      const float square = squared_half_angle(now[j], now[joints + j]);
      if (square <= limits.joint[j]) continue;
      haste.joint[j] = true;
      if (counts[j]) exceed(f, square, limits.joint[j]);
    }
  }
  return haste;
}

/// Spreads one joint's motion over more time where it is too quick: its path is averaged (by a
/// triangle, with both ends kept), the more widely the quicker it is.
class JointCalming {
 public:
  JointCalming(Walk& walk, std::size_t joint, float limit)
      : walk_(walk), joint_(joint), limit_(limit), frames_(walk.root.size()) {}

  void calm() {
    for (const double seconds : calming_seconds) {
      if (!find_haste()) return;
      const auto radius = static_cast<std::size_t>(seconds * walk_.frame_rate);
      spread(radius, shares(radius));
    }
  }

 private:
  Quat& at(std::size_t frame) const { return walk_.rotation[frame * walk_.joint_count + joint_]; }

  bool find_haste() {
    hasty_.assign(frames_, 0.0);
    bool found = false;
    for (std::size_t f = 1; f < frames_; ++f)
      if (squared_half_angle(at(f - 1), at(f)) > limit_)
        hasty_[f - 1] = hasty_[f] = 1, found = true;
    return found;
  }

  /// How much of the averaged path is taken in each frame: all of it where it was too quick.
  std::vector<double> shares(std::size_t radius) const {
    std::vector<double> share(frames_, 0.0);
    std::size_t until = 0;
    for (std::size_t f = 0; f < frames_; ++f) {
      if (hasty_[f] == 0) continue;
      for (until = std::max(until, f - std::min(f, 2 * radius));
           until < std::min(f + 2 * radius + 1, frames_); ++until)
        share[until] = 1;
    }
    return box_held(box_held(share, 2 * radius + 1), 2 * radius + 1);
  }

  void spread(std::size_t radius, const std::vector<double>& share) {
    std::vector<Vec2> wx, yz;
    Quat last = at(0);
    for (std::size_t f = 0; f < frames_; ++f) {
      const Quat q = glm::dot(last, at(f)) < 0 ? -at(f) : at(f);
      wx.emplace_back(q.w, q.x), yz.emplace_back(q.y, q.z);
      last = q;
    }
    const auto averaged = [&](const std::vector<Vec2>& path) {
      return box_pinned(box_pinned(path, 2 * radius + 1), 2 * radius + 1);
    };
    const std::vector<Vec2> calm_wx = averaged(wx), calm_yz = averaged(yz);
    for (std::size_t f = 0; f < frames_; ++f) {
      if (share[f] <= 0) continue;
      const Vec2 a = glm::mix(wx[f], calm_wx[f], share[f]),
                 b = glm::mix(yz[f], calm_yz[f], share[f]);
      at(f) = glm::normalize(Quat(static_cast<float>(a.x), static_cast<float>(a.y),
                                  static_cast<float>(b.x), static_cast<float>(b.y)));
    }
  }

  Walk& walk_;
  std::size_t joint_;
  float limit_;  ///< Of a step's squared half angle.
  std::size_t frames_;
  std::vector<double> hasty_;
};

bool bears_body(const WalkGraph& graph, std::size_t joint) {
  return std::ranges::any_of(graph.legs.leg, [joint](const Leg& leg) {
    const auto* end = leg.joint.data() + leg.toe + 1;
    return std::find(leg.joint.data(), end, joint) != end;
  });
}

/// Writes a walk anew: frames as they are, and frames between frames.
class Retiming {
 public:
  explicit Retiming(const Walk& from) : from_(from), joints_(from.joint_count) {
    to_ = from;
    to_.root.clear(), to_.rotation.clear(), to_.plants.clear(), to_.body.clear();
    to_.along.clear(), to_.gait.clear(), to_.source.clear();
  }

  void copy(std::size_t first, std::size_t end) {
    const auto add = [&](auto& to, const auto& from, std::size_t each) {
      const auto begin = from.begin();
      to.insert(to.end(), begin + static_cast<std::ptrdiff_t>(first * each),
                begin + static_cast<std::ptrdiff_t>(end * each));
    };
    add(to_.root, from_.root, 1);
    add(to_.rotation, from_.rotation, joints_);
    add(to_.plants, from_.plants, 1);
    add(to_.body, from_.body, 1);
    add(to_.along, from_.along, 1);
    add(to_.gait, from_.gait, 1);
    add(to_.source, from_.source, 1);
  }

  /// The moment between a frame and the next; `share` of the next is below one.
  void add(std::size_t frame, double share) {
    const auto part = static_cast<float>(share);
    const std::size_t next = frame + 1, nearest = share < 0.5 ? frame : next;
    to_.root.push_back(glm::mix(from_.root[frame], from_.root[next], part));
    for (std::size_t j = 0; j < joints_; ++j)
      to_.rotation.push_back(glm::slerp(from_.rotation[frame * joints_ + j],
                                        from_.rotation[next * joints_ + j], part));
    to_.plants.push_back(from_.plants[nearest]);
    const Placement &a = from_.body[frame], &b = from_.body[next];
    to_.body.push_back({glm::mix(a.position, b.position, share),
                        a.heading + share * wrap_angle(b.heading - a.heading)});
    to_.along.push_back(glm::mix(from_.along[frame], from_.along[next], part));
    to_.gait.push_back(from_.gait[nearest]);
    to_.source.push_back(from_.source[nearest]);
  }

  Walk take() { return std::move(to_); }

 private:
  const Walk& from_;
  std::size_t joints_;
  Walk to_;
};

/// Writes the frames of [first, end), whose steps are to take `slowness` times as long, and a
/// little longer, so that whole frames go on after them.
void add_slowly(std::size_t first, std::size_t end, std::span<const double> slowness,
                Retiming& out) {
  double added = 0;
  for (std::size_t f = first; f < end; ++f) added += slowness[f] - 1;
  const double more = std::ceil(added) / added;
  double began = 0;  // frames after the first one, when the step begins
  std::size_t written = 0;
  for (std::size_t f = first; f < end; ++f) {
    const double taken = 1 + more * (slowness[f] - 1);
    for (; static_cast<double>(written) < began + taken - 1e-6; ++written)
      out.add(f, std::max(0.0, (static_cast<double>(written) - began) / taken));
    began += taken;
  }
}

}  // namespace

QuickestMotion quickest_motion(const MotionGraph& motion) {
  QuickestMotion quickest;
  quickest.joint.resize(motion.skeleton.joint.size(), 0.0);
  for (const MotionClip& clip : motion.clips) {
    quickest.root = std::max(quickest.root, quickest_root(clip));
    const std::size_t joints = clip.joint_count;
    for (std::size_t i = joints; i < clip.rotation.size(); ++i) {
      const double half =
          std::sqrt(squared_half_angle(clip.rotation[i - joints], clip.rotation[i]));
      double& most = quickest.joint[i % joints];
      most = std::max(most, 2 * half * clip.frame_rate);
    }
  }
  return quickest;
}

void limit_speeds(const WalkGraph& graph, Walk& walk) {
  if (walk.root.size() < 2 || graph.quickest.joint.size() != walk.joint_count) return;
  const StepLimits limits(graph.quickest, walk.frame_rate);
  std::vector<bool> counts(walk.joint_count);
  for (std::size_t j = 0; j < counts.size(); ++j) counts[j] = bears_body(graph, j);
  Haste haste = find_haste(limits, counts, walk);
  bool has_calmed = false;
  for (std::size_t j = 0; j < counts.size(); ++j)
    if (!counts[j] && haste.joint[j])
      has_calmed = true, JointCalming(walk, j, limits.joint[j]).calm();
  if (has_calmed) haste = find_haste(limits, std::vector<bool>(counts.size(), true), walk);
  if (std::ranges::max(haste.excess) <= 1) return;
  const std::vector<double> slowness =
      smooth_above(haste.excess, static_cast<std::size_t>(slowing_seconds * walk.frame_rate));
  Retiming out(walk);
  for (std::size_t f = 0; f < slowness.size();) {
    const auto is_slow = [&](std::size_t at) { return slowness[at] > 1 + 1e-9; };
    std::size_t end = f;
    while (end < slowness.size() && is_slow(end) == is_slow(f)) ++end;
    if (is_slow(f))
      add_slowly(f, end, slowness, out);
    else
      out.copy(f, end);
    f = end;
  }
  out.copy(walk.root.size() - 1, walk.root.size());
  walk = out.take();
}

}  // namespace docent::motion
