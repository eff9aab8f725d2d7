#include "content/character/retarget.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "runtime/motion/leg.h"

namespace docent::character {
namespace {

motion::PoseView pose_at(MotionClip& clip, std::size_t frame) {
  return {clip.root[frame],
          std::span(clip.rotation).subspan(frame * clip.joint_count, clip.joint_count)};
}

bool is_planted(const FootPlants& plants, Side side) {
  return side == Side::Left ? plants.left : plants.right;
}

/// A stretch of frames in which a foot is planted.
struct Plant {
  Side side;
  std::size_t begin = 0, end = 0;
  Vec3 place{0};  ///< Of the toe joint.
};

std::vector<Plant> plants_of(const MotionClip& clip, float rest) {
  std::vector<Plant> plants;
  for (const Side side : both_sides)
    for (std::size_t f = 0; f < clip.plants.size();) {
      std::size_t end = f;
      while (end < clip.plants.size() && is_planted(clip.plants[end], side)) ++end;
      if (end > f) plants.push_back({.side = side, .begin = f, .end = end, .place = {0, rest, 0}});
      f = std::max(end, f + 1);
    }
  std::ranges::stable_sort(plants, {}, &Plant::begin);
  return plants;
}

float smooth_step(float share) {
  const float t = std::clamp(share, 0.0F, 1.0F);
  return t * t * (3 - 2 * t);
}

/// How both feet of a body lie by the recorded rotations alone.
struct Feet {
  std::array<std::vector<motion::Foot>, 2> foot;
  std::array<std::vector<Vec3>, 2> ankle;

  Vec3 toe(Side side, std::size_t frame) const { return foot[docent::index_of(side)][frame].toe; }
};

Feet feet_of(const Skeleton& skeleton, const motion::Legs& legs, MotionClip& clip) {
  Feet feet;
  for (const Side side : both_sides)
    for (std::size_t f = 0; f < clip.root.size(); ++f) {
      const motion::Foot foot = motion::foot_of(skeleton, legs[side], pose_at(clip, f));
      feet.foot[docent::index_of(side)].push_back(foot);
      feet.ankle[docent::index_of(side)].push_back(motion::ankle_of(legs[side], foot));
    }
  return feet;
}

/// Where each plant is: each step begins where the body, carried by the foot before it, puts it.
void lay_out(const Feet& feet, std::vector<Plant>& plants) {
  for (std::size_t i = 0; i < plants.size(); ++i) {
    Plant& plant = plants[i];
    Vec3 sum{0};
    float count = 0;
    const Plant* before = nullptr;
    for (std::size_t k = 0; k < i; ++k)
      if (plants[k].side != plant.side && (before == nullptr || plants[k].end > before->end))
        before = &plants[k];
    if (before != nullptr) {
      // Carried to its last frame where the two do not meet.
      const std::size_t end = std::max(std::min(before->end, plant.end), plant.begin + 1);
      for (std::size_t f = plant.begin; f < end; ++f) {
        const std::size_t carried = std::min(f, before->end - 1);
        sum += feet.toe(plant.side, f) + before->place - feet.toe(before->side, carried);
        ++count;
      }
    } else {
      for (std::size_t f = plant.begin; f < plant.end; ++f, ++count) sum += feet.toe(plant.side, f);
    }
    plant.place.x = sum.x / count;
    plant.place.z = sum.z / count;
  }
}

/// How far the hips must move for planted feet to stay: what carries the weight decides, and
/// hands over while both feet are down.
std::vector<Vec3> carried(const Feet& feet, const std::vector<Plant>& plants, std::size_t frames,
                          double rate) {
  const auto ramp = static_cast<float>(std::max(0.12 * rate, 1.0));
  std::vector<Vec3> off(frames, Vec3{0});
  std::vector<float> weight(frames, 0);
  for (const Plant& plant : plants)
    for (std::size_t f = plant.begin; f < plant.end; ++f) {
      // A clip's ends cut plants short, and are not where weight passes on.
      const float since = plant.begin == 0 ? ramp : static_cast<float>(f - plant.begin) + 0.5F;
      const float left = plant.end == frames ? ramp : static_cast<float>(plant.end - f) - 0.5F;
      const float share = std::max(smooth_step(std::min(since, left) / ramp), 1e-4F);
      off[f] += share * (plant.place - feet.toe(plant.side, f));
      weight[f] += share;
    }
  std::optional<std::size_t> before;
  for (std::size_t f = 0; f <= frames; ++f) {
    if (f < frames && weight[f] == 0) continue;
    if (f < frames) off[f] /= weight[f];
    const std::size_t first = before ? *before + 1 : 0;
    for (std::size_t g = first; g < f; ++g) {
      const Vec3 from = before ? off[*before] : f < frames ? off[f] : Vec3{0};
      const Vec3 to = f < frames ? off[f] : from;
      off[g] = glm::mix(
          from, to,
          smooth_step(static_cast<float>(g + 1 - first) / static_cast<float>(f + 1 - first)));
    }
    before = f;
  }
  return off;
}

/// What a foot is turned, and its ankle moved, beyond the recording.
struct Correction {
  Quat turn{1, 0, 0, 0};
  Vec3 shift{0};
};

Quat shortest_arc(Vec3 from, Vec3 to) {
  from = glm::normalize(from);
  to = glm::normalize(to);
  const Vec3 axis = glm::cross(from, to);
  return glm::normalize(Quat{1 + glm::dot(from, to), axis.x, axis.y, axis.z});
}

/// A planted foot turns about its ankle towards its place; only what is then missing beyond a few
/// millimetres moves the leg.
Correction correct(Vec3 ankle, Vec3 toe, Vec3 place) {
  constexpr float slack = 0.003F;
  const Vec3 foot = toe - ankle, wanted = place - ankle;
  const float length = glm::length(foot), distance = glm::length(wanted);
  if (length < 1e-4F || distance < 1e-4F) return {};
  const float missing = distance - length;
  const float moved = std::abs(missing) <= slack ? 0 : missing - std::copysign(slack, missing);
  return {.turn = shortest_arc(foot, wanted), .shift = moved / distance * wanted};
}

/// The corrections of one foot: while it is planted, and fading out of and into plants.
std::vector<Correction> corrections(const Feet& feet, const std::vector<Plant>& plants,
                                    const std::vector<Vec3>& carried_by, Side side, double rate) {
  const std::size_t frames = carried_by.size();
  const auto fade = static_cast<float>(std::max(0.15 * rate, 1.0));
  std::vector<Correction> out(frames);
  std::vector<const Plant*> own;
  for (const Plant& plant : plants)
    if (plant.side == side) own.push_back(&plant);
  for (const Plant* plant : own)
    for (std::size_t f = plant->begin; f < plant->end; ++f)
      out[f] = correct(feet.ankle[docent::index_of(side)][f] + carried_by[f],
                       feet.toe(side, f) + carried_by[f], plant->place);
  const auto add = [&](std::size_t f, const Correction& end, float share) {
    out[f].turn = glm::normalize(glm::slerp(Quat{1, 0, 0, 0}, end.turn, share) * out[f].turn);
    out[f].shift += share * end.shift;
  };
  for (std::size_t i = 0; i < own.size(); ++i) {
    const std::size_t next = i + 1 < own.size() ? own[i + 1]->begin : frames;
    const std::size_t last = i == 0 ? 0 : own[i - 1]->end;
    for (std::size_t f = own[i]->end; f < next; ++f)
      add(f, out[own[i]->end - 1], 1 - smooth_step(static_cast<float>(f + 1 - own[i]->end) / fade));
    for (std::size_t f = last; f < own[i]->begin; ++f)
      add(f, out[own[i]->begin], 1 - smooth_step(static_cast<float>(own[i]->begin - f) / fade));
  }
  return out;
}

/// Smooths by the gait's rhythm: a mean over about a stride, twice.
std::vector<float> over_a_stride(std::vector<float> value, double rate) {
  const auto reach = static_cast<std::size_t>(std::max(0.27 * rate, 1.0));
  for (int pass = 0; pass < 2; ++pass) {
    std::vector<float> mean(value.size());
    for (std::size_t f = 0; f < value.size(); ++f) {
      const std::size_t near = std::min({reach, f, value.size() - 1 - f});
      float sum = 0;
      for (std::size_t g = f - near; g <= f + near; ++g) sum += value[g];
      mean[f] = sum / static_cast<float>(2 * near + 1);
    }
    value = std::move(mean);
  }
  return value;
}

/// Keeps so much of the pelvis' roll and twist about where the body heads. What hangs on it keeps
/// its directions in the world.
void calm_pelvis(const Skeleton& skeleton, float keep, MotionClip& clip) {
  if (std::abs(keep - 1) < 0.01F || clip.root.empty()) return;
  std::vector<float> heading;
  for (std::size_t f = 0; f < clip.root.size(); ++f) {
    const Vec3 left = clip.rotation[f * clip.joint_count] * Vec3(1, 0, 0);
    float angle = std::atan2(-left.z, left.x);
    if (f > 0)
      angle += 2 * std::numbers::pi_v<float> *
               std::round((heading.back() - angle) / (2 * std::numbers::pi_v<float>));
    heading.push_back(angle);
  }
  heading = over_a_stride(std::move(heading), clip.frame_rate);
  for (std::size_t f = 0; f < clip.root.size(); ++f) {
    Quat* local = &clip.rotation[f * clip.joint_count];
    const Quat ahead = glm::angleAxis(heading[f], Vec3(0, 1, 0));
    const Vec3 left = glm::inverse(ahead) * (local[0] * Vec3(1, 0, 0));
    const Vec3 calm = glm::normalize(Vec3(left.x, keep * left.y, keep * left.z));
    const Quat turned =
        glm::normalize(ahead * shortest_arc(left, calm) * glm::inverse(ahead) * local[0]);
    const Quat back = glm::inverse(turned) * local[0];
    local[0] = turned;
    for (std::size_t j = 1; j < clip.joint_count; ++j)
      if (skeleton.joint[j].parent == JointIndex{0}) local[j] = glm::normalize(back * local[j]);
  }
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

MotionClip retarget(const Fit& fit, const MotionClip& clip, float spread) {
  MotionClip out = clip;
  for (Vec3& root : out.root)
    root = {fit.legs * root.x, fit.legs * (root.y - fit.recorded_ankle) + fit.ankle,
            fit.legs * root.z};
  spread_arms(fit.skeleton, spread, out);
  calm_pelvis(fit.skeleton, fit.pelvis, out);
  const auto legs = motion::find_legs(fit.skeleton);
  const std::size_t frames = out.root.size();
  if (!legs || out.plants.size() != frames) return out;

  const Feet feet = feet_of(fit.skeleton, *legs, out);
  std::vector<Plant> plants = plants_of(out, fit.toe_rest);
  lay_out(feet, plants);
  const std::vector<Vec3> moved = carried(feet, plants, frames, out.frame_rate);
  std::array<std::vector<Correction>, 2> corrected;
  for (const Side side : both_sides)
    corrected[docent::index_of(side)] = corrections(feet, plants, moved, side, out.frame_rate);
  const float lowest = 0.25F * fit.toe_rest;
  for (std::size_t f = 0; f < frames; ++f) {
    out.root[f] += moved[f];
    motion::PoseView pose = pose_at(out, f);
    for (const Side side : both_sides) {
      const std::size_t i = docent::index_of(side);
      const Correction& by = corrected[i][f];
      motion::Foot foot = feet.foot[i][f];
      const Vec3 ankle = feet.ankle[i][f] + moved[f] + by.shift;
      foot.toe = ankle + by.turn * (foot.toe - feet.ankle[i][f]);
      foot.rotation = glm::normalize(by.turn * foot.rotation);
      foot.toe.y = std::max(foot.toe.y, lowest);
      motion::place_foot(fit.skeleton, (*legs)[side], foot, pose);
    }
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
      for (std::size_t k = 0; k < 4; ++k)
        if (v.joint[k] < is_trunk.size() && is_trunk[v.joint[k]]) share += v.weight[k];
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
      const Vec3 widest =
          *std::ranges::max_element(in[r], {}, [](Vec3 p) { return std::abs(p.x); });
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
  const Vec3 tip =
      skeleton[tip_part] == JointIndex::None ? wrist + 0.5F * (wrist - elbow) : place(tip_part);
  const auto into = [&](BodyPart part) {
    const motion::JointPlace frame = motion::place_of(
        skeleton, skeleton[part] == JointIndex::None ? JointIndex{0} : skeleton[part], pose);
    const std::size_t j = skeleton[part] == JointIndex::None ? 0 : docent::index_of(skeleton[part]);
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

float spread_for(const Fit& fit, const SkinnedMesh& body,
                 std::span<const MotionClip* const> clips) {
  const Trunk trunk(fit.skeleton, body);
  constexpr float step = std::numbers::pi_v<float> / 180, most = 60 * step;
  float spread = 0;
  for (const MotionClip* clip : clips) {
    constexpr std::size_t every = 4;
    MotionClip moved = retarget(fit, *clip, spread);
    while (spread < most && depth_of(fit.skeleton, trunk, body, moved, every) > -0.01F) {
      spread += step;
      spread_arms(fit.skeleton, step, moved);
    }
  }
  return spread;
}

}  // namespace docent::character
