#include "content/motion/parametric_turns.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>

#include "content/motion/classify.h"
#include "content/motion/extract_root_motion.h"
#include "content/motion/foot_plants.h"

namespace docent::motion::offline {
namespace {

constexpr double degree = std::numbers::pi / 180;

Vec2 turned(Vec2 v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x - s * v.y, s * v.x + c * v.y};
}
Quat about_vertical(double heading) {
  return glm::angleAxis(static_cast<float>(heading), Vec3(0, 1, 0));
}

/// A clip as it is between its frames.
class Parent {
 public:
  Parent(const Skeleton& skeleton, const MotionClip& clip)
      : clip_(clip), track_(joint_positions(skeleton, clip)) {
    for (std::size_t f = 0; f < clip.root.size(); ++f)
      heading_.push_back(hip_heading(skeleton, track_, f, f > 0 ? heading_.back() : 0));
  }

  double heading(double at) const {
    return between(at, [&](std::size_t f) { return heading_[f]; });
  }
  double height(double at) const {
    return between(at, [&](std::size_t f) { return static_cast<double>(clip_.root[f].y); });
  }
  /// Relative to its parent; the root's relative to where the hips face.
  Quat rotation(double at, std::size_t joint) const {
    const auto [f, part] = split(at);
    const Quat here =
        glm::slerp(clip_.rotation[f * clip_.joint_count + joint],
                   clip_.rotation[(f + 1) * clip_.joint_count + joint], static_cast<float>(part));
    return joint == 0 ? about_vertical(-heading(at)) * here : here;
  }
  /// How far a joint moves over the floor, as seen from where the hips face at first.
  Vec2 moved(std::size_t joint, double from, double to) const {
    const auto place = [&](double at) {
      return between(at, [&](std::size_t f) { return to_floor(track_.at(f, joint)); });
    };
    return turned(place(to) - place(from), -heading(from));
  }
  FootPlants plants(double at) const {
    return clip_
        .plants[std::min(static_cast<std::size_t>(std::lround(at)), clip_.plants.size() - 1)];
  }

 private:
  struct Place {
    std::size_t frame;
    double part;
  };
  Place split(double at) const {
    const std::size_t frame =
        std::min(static_cast<std::size_t>(std::max(at, 0.0)), clip_.root.size() - 2);
    return {frame, std::clamp(at - static_cast<double>(frame), 0.0, 1.0)};
  }
  auto between(double at, auto&& value) const -> decltype(value(std::size_t{})) {
    const auto [frame, part] = split(at);
    return value(frame) * (1 - part) + value(frame + 1) * part;
  }

  const MotionClip& clip_;
  JointPositions track_;
  std::vector<double> heading_;
};

/// The moments of both parents for each frame of the blend, whose time runs between theirs.
Registration at_frames(const Registration& curve, double share) {
  const auto time = [&](std::size_t k) { return std::lerp(curve.a[k], curve.b[k], share); };
  Registration result;
  std::size_t k = 0;
  for (double at = time(0); at <= time(curve.a.size() - 1); ++at) {
    while (k + 2 < curve.a.size() && time(k + 1) <= at) ++k;
    const double part = (at - time(k)) / (time(k + 1) - time(k));
    result.a.push_back(std::lerp(curve.a[k], curve.a[k + 1], part));
    result.b.push_back(std::lerp(curve.b[k], curve.b[k + 1], part));
  }
  return result;
}

/// The mean of a few frames to each side.
std::vector<double> softened(const std::vector<double>& values, std::size_t half) {
  std::vector<double> result;
  for (std::size_t f = 0; f < values.size(); ++f) {
    const std::size_t from = f > half ? f - half : 0, to = std::min(f + half, values.size() - 1);
    double sum = 0;
    for (std::size_t g = from; g <= to; ++g) sum += values[g];
    result.push_back(sum / static_cast<double>(to - from + 1));
  }
  return result;
}

class Blend {
 public:
  Blend(const Skeleton& skeleton, const MotionClip& a, const MotionClip& b,
        const Registration& curve, double share)
      : skeleton_(skeleton),
        a_(skeleton, a),
        b_(skeleton, b),
        share_(share),
        moment_(at_frames(curve, share)) {
    clip_.frame_rate = a.frame_rate;
    clip_.joint_count = a.joint_count;
    clip_.motion_class = a.motion_class;
    for (std::size_t f = 0; f < moment_.a.size(); ++f) add_pose(f);
    walk();
  }
  MotionClip take() { return std::move(clip_); }

 private:
  double mix(double of_a, double of_b) const { return std::lerp(of_a, of_b, share_); }

  /// A pose that stands above the origin, turned to where it faces.
  void add_pose(std::size_t f) {
    const double at = moment_.a[f], bt = moment_.b[f];
    // The second clip is laid onto the first where both begin.
    heading_.push_back(
        mix(a_.heading(at), b_.heading(bt) - b_.heading(moment_.b[0]) + a_.heading(moment_.a[0])));
    clip_.root.push_back({0, static_cast<float>(mix(a_.height(at), b_.height(bt))), 0});
    for (std::size_t j = 0; j < clip_.joint_count; ++j) {
      const Quat pose =
          glm::slerp(a_.rotation(at, j), b_.rotation(bt, j), static_cast<float>(share_));
      clip_.rotation.push_back(j == 0 ? about_vertical(heading_.back()) * pose : pose);
    }
  }

  /// How far a joint of the blend is to move to the next frame.
  Vec2 wanted(std::size_t joint, std::size_t f) const {
    const Vec2 of_a = a_.moved(joint, moment_.a[f], moment_.a[f + 1]);
    const Vec2 of_b = b_.moved(joint, moment_.b[f], moment_.b[f + 1]);
    return turned((1 - share_) * of_a + share_ * of_b, heading_[f]);
  }

  /// How firmly each foot stands, from 0 to 1, softly from one to the other.
  std::vector<double> firmness(bool FootPlants::* foot) const {
    std::vector<double> firm;
    for (std::size_t f = 0; f < moment_.a.size(); ++f)
      firm.push_back(a_.plants(moment_.a[f]).*foot && b_.plants(moment_.b[f]).*foot ? 1.0 : 0.0);
    return softened(firm, frames_in(0.04, clip_.frame_rate));
  }

  /// Moves the poses so that standing feet stay where they are.
  void walk() {
    struct Foot {
      std::size_t toe;
      std::vector<double> firm;
    };
    std::vector<Foot> feet;
    for (const auto& [part, foot] : {std::pair{BodyPart::LeftToe, &FootPlants::left},
                                     std::pair{BodyPart::RightToe, &FootPlants::right}})
      if (skeleton_[part] != JointIndex::None)
        feet.push_back({index_of(skeleton_[part]), firmness(foot)});
    const JointPositions track = joint_positions(skeleton_, clip_);
    Vec2 place{};
    for (std::size_t f = 0; f + 1 < clip_.root.size(); ++f) {
      Vec2 step{};
      double firm = 0;
      for (const Foot& foot : feet) {
        const Vec2 by_pose = to_floor(track.at(f + 1, foot.toe)) - to_floor(track.at(f, foot.toe));
        step += foot.firm[f] * (wanted(foot.toe, f) - by_pose);
        firm += foot.firm[f];
      }
      const double in_air = std::max(0.0, 1 - firm);
      place += (step + in_air * wanted(0, f)) / (firm + in_air);
      clip_.root[f + 1] = to_world(place, clip_.root[f + 1].y);
    }
  }

  const Skeleton& skeleton_;
  Parent a_, b_;
  double share_;
  Registration moment_;
  MotionClip clip_;
  std::vector<double> heading_;
};

/// A clip that walks, and how its body turns.
struct Turn {
  std::size_t clip = 0;
  std::vector<double> heading;  ///< Per frame.

  double angle() const { return heading.back() - heading.front(); }
};

/// All that can be a turn's parent, class by class, from the rightmost to the leftmost.
std::vector<Turn> find_turns(const Skeleton& skeleton, const std::vector<MotionClip>& clips) {
  std::vector<Turn> turns;
  for (std::size_t c = 0; c < clips.size(); ++c) {
    const ClipRole role = clips[c].role;
    if (role != ClipRole::Walk && role != ClipRole::TurnLeft && role != ClipRole::TurnRight)
      continue;
    Turn& turn = turns.emplace_back(c);
    for (const Placement& body :
         extract_root_motion(skeleton, clips[c], joint_positions(skeleton, clips[c])))
      turn.heading.push_back(body.heading);
  }
  std::ranges::stable_sort(turns, {}, [&](const Turn& turn) {
    return std::pair(std::string_view(clips[turn.clip].motion_class), turn.angle());
  });
  return turns;
}

/// Does a registration hold most of a clip's turn?
bool holds_turn(const std::vector<double>& moments, const Turn& turn) {
  constexpr double most = 2.0 / 3, straight = 10 * degree;
  if (std::abs(turn.angle()) < straight) return true;
  const auto heading_at = [&](double moment) {
    return turn.heading[static_cast<std::size_t>(std::lround(moment))];
  };
  return (heading_at(moments.back()) - heading_at(moments.front())) / turn.angle() > most;
}

}  // namespace

MotionClip blend_clips(const Skeleton& skeleton, const MotionClip& a, const MotionClip& b,
                       const Registration& registration, double share) {
  return Blend(skeleton, a, b, registration, share).take();
}

std::vector<MotionClip> parametric_turns(const Skeleton& skeleton,
                                         const std::vector<MotionClip>& clips,
                                         const std::vector<PoseCloud>& cloud) {
  constexpr double wide = 20 * degree, widest = 30 * degree;
  constexpr double alike = 0.15;  // metres, of an adult
  std::vector<MotionClip> made;
  const std::vector<Turn> turns = find_turns(skeleton, clips);
  for (std::size_t i = 0; i + 1 < turns.size(); ++i) {
    const Turn &a = turns[i], &b = turns[i + 1];
    const double gap = b.angle() - a.angle();
    if (gap < wide || clips[a.clip].motion_class != clips[b.clip].motion_class) continue;
    const Registration shared = register_clips({clips[a.clip], cloud[a.clip], a.heading},
                                               {clips[b.clip], cloud[b.clip], b.heading});
    if (shared.unlikeness > alike * size_of(skeleton) || !holds_turn(shared.a, a) ||
        !holds_turn(shared.b, b))
      continue;
    const double parts = std::ceil(gap / widest);
    for (double part = 1; part < parts; ++part) {
      MotionClip clip = blend_clips(skeleton, clips[a.clip], clips[b.clip], shared, part / parts);
      const JointPositions track = joint_positions(skeleton, clip);
      find_foot_plants(skeleton, track, clip);
      clip.role = classify(measure_clip(skeleton, clip, track), size_of(skeleton));
      if (clip.role == ClipRole::Other) continue;
      clip.name = fmt::format("{} {:.0f} of {} and {}", name_of(clip.role),
                              std::abs(a.angle() + gap * part / parts) / degree, clips[a.clip].name,
                              clips[b.clip].name);
      made.push_back(std::move(clip));
    }
  }
  return made;
}

}  // namespace docent::motion::offline
