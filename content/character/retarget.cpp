#include "content/character/retarget.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "runtime/motion/leg.h"
#include "runtime/motion/replant.h"

namespace docent::character {
namespace {

motion::PoseView pose_at(MotionClip& clip, std::size_t frame) {
  return {clip.root[frame],
          std::span(clip.rotation).subspan(frame * clip.joint_count, clip.joint_count)};
}

bool is_planted(const FootPlants& plants, Side side) {
  return side == Side::Left ? plants.left : plants.right;
}

/// Where one foot is to be, frame by frame: still while it is planted, and off its own way by a
/// smooth bridge between two plants.
std::vector<motion::Foot> planted_feet(const std::vector<motion::Foot>& feet,
                                       const std::vector<FootPlants>& plants, Side side,
                                       float rest) {
  const std::size_t frames = feet.size();
  std::vector<std::optional<Vec3>> off(frames);
  for (std::size_t begin = 0; begin < frames;) {
    if (!is_planted(plants[begin], side)) {
      ++begin;
      continue;
    }
    std::size_t end = begin;
    Vec3 sum{0};
    while (end < frames && is_planted(plants[end], side)) sum += feet[end++].toe;
    Vec3 place = sum / static_cast<float>(end - begin);
    place.y = rest;
    for (std::size_t f = begin; f < end; ++f) off[f] = place - feet[f].toe;
    begin = end;
  }
  std::vector<motion::Foot> out = feet;
  std::optional<std::size_t> before;
  for (std::size_t f = 0; f <= frames; ++f) {
    if (f < frames && !off[f]) continue;
    if (f < frames) out[f].toe += *off[f];
    const std::size_t first = before ? *before + 1 : 0;
    for (std::size_t g = first; g < f; ++g) {
      const Vec3 from = before ? *off[*before] : f < frames ? *off[f] : Vec3{0};
      const Vec3 to = f < frames ? *off[f] : from;
      const float share =
          static_cast<float>(g + 1 - first) / static_cast<float>(f + 1 - first);
      out[g].toe += glm::mix(from, to, share * share * (3 - 2 * share));
    }
    before = f;
  }
  return out;
}

/// A smooth upper bound of values that must not be fallen short of.
std::vector<float> smooth_bound(const std::vector<float>& value, std::size_t reach) {
  const std::size_t count = value.size();
  std::vector<float> most(count), mean(count);
  for (std::size_t f = 0; f < count; ++f) {
    const std::size_t low = f < reach ? 0 : f - reach, high = std::min(f + reach, count - 1);
    for (std::size_t g = low; g <= high; ++g) most[f] = std::max(most[f], value[g]);
  }
  for (std::size_t f = 0; f < count; ++f) {
    const std::size_t low = f < reach ? 0 : f - reach, high = std::min(f + reach, count - 1);
    float sum = 0;
    for (std::size_t g = low; g <= high; ++g) sum += most[g];
    mean[f] = sum / static_cast<float>(high - low + 1);
  }
  return mean;
}

void spread_arms(const Skeleton& skeleton, float spread, MotionClip& clip) {
  if (spread == 0) return;
  for (const Side side : both_sides) {
    const JointIndex shoulder =
        skeleton[side == Side::Left ? BodyPart::LeftShoulder : BodyPart::RightShoulder];
    if (shoulder == JointIndex::None) continue;
    const Quat out = glm::angleAxis(sign_of(side) * spread, Vec3(0, 0, 1));
    for (std::size_t f = 0; f < clip.root.size(); ++f) {
      Quat& local = clip.rotation[f * clip.joint_count + docent::index_of(shoulder)];
      local = glm::normalize(out * local);
    }
  }
}

}  // namespace

MotionClip retarget(const Skeleton& recorded, const Fit& fit, const MotionClip& clip,
                    float spread) {
  MotionClip out = clip;
  for (Vec3& root : out.root)
    root = {fit.legs * root.x, fit.legs * (root.y - fit.recorded_ankle) + fit.ankle,
            fit.legs * root.z};
  spread_arms(fit.skeleton, spread, out);
  const auto legs = motion::find_legs(fit.skeleton), old_legs = motion::find_legs(recorded);
  if (!legs || !old_legs || out.plants.size() != out.root.size()) return out;

  std::array<std::vector<motion::Foot>, 2> feet;
  std::vector<float> drop(out.root.size());
  const float lowest = 0.5F * fit.toe_rest;
  for (const Side side : both_sides) {
    const motion::Leg& leg = (*legs)[side];
    std::vector<motion::Foot>& own = feet[docent::index_of(side)];
    for (std::size_t f = 0; f < out.root.size(); ++f)
      own.push_back(motion::foot_of(fit.skeleton, leg, pose_at(out, f)));
    own = planted_feet(own, out.plants, side, fit.toe_rest);
    for (std::size_t f = 0; f < own.size(); ++f) {
      own[f].toe.y = std::max(own[f].toe.y, lowest);
      constexpr float straight = 0.998F;
      drop[f] = std::max(
          drop[f], motion::drop_into_reach(motion::hip_of(fit.skeleton, leg, pose_at(out, f)),
                                           motion::ankle_of(leg, own[f]), straight * leg.length));
    }
  }
  const auto reach = static_cast<std::size_t>(std::max(0.06 * out.frame_rate, 1.0));
  const std::vector<float> lower = smooth_bound(drop, reach);
  for (std::size_t f = 0; f < out.root.size(); ++f) {
    out.root[f].y -= lower[f];
    motion::PoseView pose = pose_at(out, f);
    for (const Side side : both_sides)
      motion::place_foot(fit.skeleton, (*legs)[side], feet[docent::index_of(side)][f], pose);
  }
  return out;
}

namespace {

/// The trunk's skin in its rest pose as a stack of ellipses, in the root's frame.
class Trunk {
 public:
  Trunk(const Skeleton& skeleton, const SkinnedMesh& body) {
    const std::vector<bool> is_trunk = trunk_joints(skeleton);
    std::vector<Vec3> points;
    for (const SkinnedVertex& v : body.vertices) {
      int share = 0;
      Vec3 place{0};
      for (std::size_t k = 0; k < 4; ++k) {
        if (is_trunk[v.joint[k]]) share += v.weight[k];
        place += static_cast<float>(v.weight[k]) / 255 *
                 Vec3(body.inverse_bind[v.joint[k]] * Vec4(v.position, 1));
      }
      // Trunk joints do not turn at rest, so a vertex lies by its first joint's frame.
      if (share > 200) points.push_back(v.position);
    }
    build(points);
  }

  /// How deep a place (in the frame in which the body was modelled, metres) lies inside.
  float depth(Vec3 place) const {
    if (rings_.empty()) return -1;
    const float at = (place.y - low_) / height_;
    if (at < 0 || at >= static_cast<float>(rings_.size())) return -1;
    const Ring& ring = rings_[static_cast<std::size_t>(at)];
    if (ring.half.x <= 0 || ring.half.y <= 0) return -1;
    const float x = place.x / ring.half.x, z = (place.z - ring.middle) / ring.half.y;
    const float out = std::sqrt(x * x + z * z);
    return (1 - out) * std::min(ring.half.x, ring.half.y);
  }

 private:
  struct Ring {
    glm::vec2 half{0};
    float middle = 0;
  };

  static std::vector<bool> trunk_joints(const Skeleton& skeleton) {
    std::vector<bool> is_trunk(skeleton.joint.size());
    for (const BodyPart part : {BodyPart::Hips, BodyPart::Spine, BodyPart::Chest})
      if (skeleton[part] != JointIndex::None) is_trunk[docent::index_of(skeleton[part])] = true;
    is_trunk[0] = true;
    return is_trunk;
  }

  void build(std::vector<Vec3>& points) {
    if (points.size() < 20) return;
    std::ranges::sort(points, {}, [](Vec3 p) { return p.y; });
    low_ = points.front().y;
    constexpr std::size_t count = 16;
    height_ = std::max((points.back().y - low_) / count, 1e-4F);
    rings_.resize(count);
    std::array<std::vector<Vec3>, count> in;
    for (const Vec3& p : points)
      in[std::min<std::size_t>(static_cast<std::size_t>((p.y - low_) / height_), count - 1)]
          .push_back(p);
    for (std::size_t r = 0; r < count; ++r) {
      if (in[r].size() < 4) continue;
      const auto [back, front] = std::ranges::minmax(in[r], {}, [](Vec3 p) { return p.z; });
      const Vec3 widest = *std::ranges::max_element(in[r], {}, [](Vec3 p) { return std::abs(p.x); });
      rings_[r] = {{std::abs(widest.x), 0.5F * (front.z - back.z)}, 0.5F * (front.z + back.z)};
    }
  }

  std::vector<Ring> rings_;
  float low_ = 0, height_ = 1;
};

/// The deepest place of one side's arm in a frame.
float arm_depth(const Skeleton& skeleton, const Trunk& trunk, const SkinnedMesh& body,
                const motion::PoseView& pose, Side side) {
  const bool left = side == Side::Left;
  const auto place = [&](BodyPart part) {
    return motion::place_of(skeleton, skeleton[part], pose).place;
  };
  // Hips carry the lower half of the trunk, the chest the upper: the shallower counts, since cloth
  // between them follows both.
  const Vec3 elbow = place(left ? BodyPart::LeftElbow : BodyPart::RightElbow);
  const Vec3 wrist = place(left ? BodyPart::LeftWrist : BodyPart::RightWrist);
  const BodyPart tip_part = left ? BodyPart::LeftHandTip : BodyPart::RightHandTip;
  const Vec3 tip = skeleton[tip_part] == JointIndex::None ? wrist + 0.5F * (wrist - elbow)
                                                          : place(tip_part);
  const auto into = [&](BodyPart part) {
    const motion::JointPlace frame =
        motion::place_of(skeleton, skeleton[part] == JointIndex::None ? JointIndex{0} : skeleton[part],
                         pose);
    const std::size_t j =
        skeleton[part] == JointIndex::None ? 0 : docent::index_of(skeleton[part]);
    // Trunk joints are bound without a turn, so going back is the place they were bound at.
    const Vec3 bound = -Vec3(body.inverse_bind[j][3]);
    return std::pair{frame, bound};
  };
  const auto [hips, hips_bound] = into(BodyPart::Hips);
  const auto [chest, chest_bound] = into(BodyPart::Chest);
  const float waist = 0.5F * (hips_bound.y + chest_bound.y);
  float deepest = -1;
  for (const float at : {0.0F, 0.5F, 1.0F, 1.5F, 2.0F}) {
    const Vec3 p = at <= 1 ? glm::mix(elbow, wrist, at) : glm::mix(wrist, tip, at - 1);
    const Vec3 by_hips = glm::inverse(hips.rotation) * (p - hips.place) + hips_bound;
    const Vec3 by_chest = glm::inverse(chest.rotation) * (p - chest.place) + chest_bound;
    deepest = std::max(deepest, trunk.depth(by_hips.y < waist ? by_hips : by_chest));
  }
  return deepest;
}

float depth_of(const Skeleton& skeleton, const Trunk& trunk, const SkinnedMesh& body,
               const MotionClip& clip, std::size_t every) {
  float deepest = -1;
  MotionClip& frames = const_cast<MotionClip&>(clip);
  for (std::size_t f = 0; f < clip.root.size(); f += every)
    for (const Side side : both_sides)
      deepest = std::max(deepest, arm_depth(skeleton, trunk, body, pose_at(frames, f), side));
  return deepest;
}

}  // namespace

float depth_in_trunk(const Skeleton& skeleton, const SkinnedMesh& body, const MotionClip& clip) {
  return depth_of(skeleton, Trunk(skeleton, body), body, clip, 1);
}

float spread_for(const Skeleton& recorded, const Fit& fit, const SkinnedMesh& body,
                 std::span<const MotionClip* const> clips) {
  const Trunk trunk(fit.skeleton, body);
  constexpr float step = std::numbers::pi_v<float> / 180, most = 35 * step;
  float spread = 0;
  for (const MotionClip* clip : clips) {
    constexpr std::size_t every = 4;
    MotionClip moved = retarget(recorded, fit, *clip, spread);
    while (spread < most &&
           depth_of(fit.skeleton, trunk, body, moved, every) > -0.01F) {
      spread += step;
      spread_arms(fit.skeleton, step, moved);
    }
  }
  return spread;
}

}  // namespace docent::character
