#include "content/avatar/skin_weights.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "content/avatar/head.h"

namespace docent::avatar {
namespace {

std::vector<std::size_t> path_down_to(const Skeleton& skeleton, std::size_t joint) {
  std::vector<std::size_t> path{joint};
  while (skeleton.joint[path.back()].parent != JointIndex::None)
    path.push_back(index_of(skeleton.joint[path.back()].parent));
  std::ranges::reverse(path);
  return path;
}

/// The last joint that two paths from the root share.
std::size_t fork_of(const std::vector<std::size_t>& a, const std::vector<std::size_t>& b) {
  std::size_t k = 0;
  while (k + 1 < std::min(a.size(), b.size()) && a[k + 1] == b[k + 1]) ++k;
  return a[k];
}

JointShares rounded(const std::vector<float>& shares) {
  std::vector<std::size_t> order(shares.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](auto a, auto b) { return shares[a] > shares[b]; });
  float total = 0;
  for (std::size_t k = 0; k < 4; ++k) total += shares[order[k]];
  JointShares result;
  int left = 255;
  for (std::size_t k = 4; k-- > 1;) {
    const int weight =
        std::min(left, static_cast<int>(std::lround(shares[order[k]] / total * 255)));
    result.joint[k] = static_cast<std::uint8_t>(weight > 0 ? order[k] : order[0]);
    result.weight[k] = static_cast<std::uint8_t>(weight);
    left -= weight;
  }
  result.joint[0] = static_cast<std::uint8_t>(order[0]);
  result.weight[0] = static_cast<std::uint8_t>(left);
  return result;
}

}  // namespace

// Lengths with `s` or `scale` are metres on a person of 1.70 m.
SkinWeights::SkinWeights(const Skeleton& skeleton, const BodyShape& body)
    : body_{body}, joint_count_{skeleton.joint.size()} {
  const auto place = [&](std::size_t joint) { return Vec3(body.stance.world[joint][3]); };
  const auto joint_of = [&](BodyPart part) { return index_of(skeleton[part]); };
  head_ = joint_of(BodyPart::Head);
  const auto to_head = path_down_to(skeleton, head_);
  const auto to_arm = path_down_to(skeleton, joint_of(BodyPart::LeftShoulder));
  chest_ = fork_of(to_head, to_arm);

  // A joint of the back owns what is above it; one that lies on its parent takes the parent's part.
  bool above_chest = false;
  for (std::size_t k = 0; k + 1 < to_head.size(); ++k) {
    const std::size_t joint = to_head[k];
    Chain& chain = above_chest ? neck_ : spine_;
    chain.push_back({joint, place(joint), {0, 1, 0}, (above_chest ? 0.02F : 0.06F) * body.scale});
    above_chest = above_chest || joint == chest_;
  }
  neck_.insert(neck_.begin(), {chest_, place(chest_), {0, 1, 0}, 0.05F});

  for (const Side side : {Side::Left, Side::Right}) {
    const auto i = static_cast<std::size_t>(side);
    const bool left = side == Side::Left;
    const LimbPoints& limb = body.limb(side);
    const auto bisector = [](Vec3 a, Vec3 joint, Vec3 b) {
      return glm::normalize(glm::normalize(joint - a) + glm::normalize(b - joint));
    };
    thigh_[i] = joint_of(left ? BodyPart::LeftHip : BodyPart::RightHip);
    const std::size_t shoulder = joint_of(left ? BodyPart::LeftShoulder : BodyPart::RightShoulder);
    const auto to_shoulder = path_down_to(skeleton, shoulder);
    const auto above = std::ranges::find(to_shoulder, chest_);
    clavicle_[i] = above + 1 == to_shoulder.end() ? chest_ : *(above + 1);
    if (clavicle_[i] == shoulder) clavicle_[i] = chest_;

    const float s = body.scale;
    const Vec3 outward{sign_of(side), 0, 0};
    arm_[i] = {{shoulder, limb.shoulder, outward, 0.05F * s},
               {joint_of(left ? BodyPart::LeftElbow : BodyPart::RightElbow), limb.elbow,
                bisector(limb.shoulder, limb.elbow, limb.wrist), 0.045F * s},
               {joint_of(left ? BodyPart::LeftWrist : BodyPart::RightWrist), limb.wrist,
                limb.hand_axis, 0.025F * s}};
    leg_[i] = {{thigh_[i], limb.hip, {0, -1, 0}, 0.05F * s},
               {joint_of(left ? BodyPart::LeftKnee : BodyPart::RightKnee), limb.knee,
                bisector(limb.hip, limb.knee, limb.ankle), 0.05F * s},
               // Below the trouser's hem the shoe turns as one with the foot.
               {joint_of(left ? BodyPart::LeftAnkle : BodyPart::RightAnkle),
                limb.ankle + Vec3{0, 0.035F * s, 0},
                {0, -1, 0},
                0.03F * s},
               {joint_of(left ? BodyPart::LeftToe : BodyPart::RightToe), limb.toe,
                limb.foot_forward, 0.022F * s}};
  }
  hang_cloth(skeleton);
}

/// What the skeleton leaves no room for does not swing: the head's first, then all.
void SkinWeights::hang_cloth(const Skeleton& skeleton) {
  Drapery drapery = drapery_of(body_);
  if (joint_count_ + drapery.size() > most_joints) {
    drapery.behind = drapery.before = {};
    drapery.beard = drapery.curls = {};
  }
  std::vector<ClothNode> nodes = nodes_of(body_, drapery);
  if (joint_count_ + nodes.size() > most_joints) return;
  const auto carry = [&](const auto& part, BodyRegion region) {
    for (ClothNode& node : std::span(nodes).subspan(part.first, part.size())) {
      const JointShares by = at(node.place, region);
      node.joint = by.joint;
      node.weight = by.weight;
    }
  };
  carry(drapery.skirt, BodyRegion::Coat);
  carry(drapery.behind, BodyRegion::Coat);
  carry(drapery.before, BodyRegion::Coat);
  carry(drapery.hair, BodyRegion::Head);
  carry(drapery.beard, BodyRegion::Head);
  carry(drapery.curls, BodyRegion::Head);
  const ClothJoints joints{.thigh = thigh_,
                           .shin = {leg_[0][1].joint, leg_[1][1].joint},
                           .chest = chest_,
                           .neck = index_of(skeleton[BodyPart::Neck]),
                           .head = head_};
  if (!nodes.empty()) cloth_.collider = colliders_of(body_, joints);
  cloth_.node = std::move(nodes);
  drapery_ = std::move(drapery);
}

/// From the tip inwards, each joint takes its part of what is left; the first takes the rest.
void SkinWeights::add_chain(const Chain& chain, Vec3 p, float share, Shares& shares) const {
  for (std::size_t k = chain.size(); k-- > 1;) {
    const Boundary& b = chain[k];
    const float beyond =
        share * smoothstep(-b.softness, b.softness, glm::dot(p - b.point, b.normal));
    shares[b.joint] += beyond;
    share -= beyond;
  }
  shares[chain.front().joint] += share;
}

void SkinWeights::add_coat(Vec3 p, Shares& shares) const {
  const float s = body_.scale;
  const Side side = p.x > 0 ? Side::Left : Side::Right;
  const auto i = static_cast<std::size_t>(side);
  const LimbPoints& limb = body_.limb(side);

  // Sleeve or flank: by which is nearer, and beyond the shoulder joint.
  const Vec3 off_shoulder = p - limb.shoulder;
  const Vec3 outward = glm::normalize(Vec3{sign_of(side), -1.1F, 0});
  const float nearer = coat_trunk(body_, p, 0) - coat_sleeve(body_, p, side);
  const float below = smoothstep(0.0F, 0.16F * s, limb.shoulder.y - p.y);
  const float sleeve = smoothstep(-0.075F * s, 0.060F * s, glm::dot(off_shoulder, outward)) *
                       glm::mix(1.0F, smoothstep(-0.02F * s, 0.03F * s, nearer), below);
  add_chain(arm_[i], p, sleeve, shares);
  const float trunk = 1 - sleeve;

  // The shoulder's cap follows the collar bone.
  const float cap = smoothstep(0.04F * s, body_.shoulder_half, std::abs(p.x)) *
                    smoothstep(-0.15F * s, 0.0F, p.y - body_.shoulder_height);
  shares[clavicle_[i]] += trunk * cap;

  // The front is pushed by the thigh that comes forward; the back hangs freely and follows less.
  const float drop = body_.hip_height + 0.02F * s - p.y;
  const float follows = 0.80F + 0.10F * smoothstep(-0.11F * s, 0.09F * s, p.z);
  const float skirt = follows * smoothstep(-0.02F * s, 0.23F * s, drop);
  if (swings()) {
    const float swinging = trunk * (1 - cap) * swinging_share(drapery_.skirt, p);
    share_out(drapery_.skirt, p, swinging, nodes(drapery_.skirt, shares));
    add_chain(spine_, p, trunk * (1 - cap) - swinging, shares);
    return;
  }
  // Front and back panels, across the middle, go with both legs.
  const float left = smoothstep(-0.10F * s, 0.10F * s, p.x);
  // What hangs below the knees goes with the shins, though not as far.
  const float below_knee = 0.75F * smoothstep(0.04F * s, -0.14F * s, p.y - limb.knee.y);
  for (const auto& [leg, part] : {std::pair{0U, left}, std::pair{1U, 1 - left}}) {
    const float share = trunk * (1 - cap) * skirt * part;
    shares[thigh_[leg]] += share * (1 - below_knee);
    shares[leg_[leg][1].joint] += share * below_knee;
  }
  add_chain(spine_, p, trunk * (1 - cap) * (1 - skirt), shares);
}

void SkinWeights::add_head(Vec3 p, Shares& shares) const {
  const float s = body_.scale;
  // Jaw and nape turn with the head: the boundary falls towards the back of the neck.
  const Vec3 throat = body_.skull + Vec3{0, -0.085F, 0.0F} * s;
  const Vec3 normal = glm::normalize(Vec3{0, 1, 0.55F});
  const float head = smoothstep(-0.035F * s, 0.02F * s, glm::dot(p - throat, normal));
  shares[head_] += head;
  // Inside the collar the neck stays with the chest, wherever the skeleton begins to bend it.
  const float free = smoothstep(0.01F * s, 0.075F * s, p.y - body_.neck_base.y);
  shares[chest_] += (1 - head) * (1 - free);
  add_chain(neck_, p, (1 - head) * free, shares);
}

template <typename Part>
void SkinWeights::let_swing(const Part& part, Vec3 p, float share, Shares& shares) const {
  for (float& had : shares) had *= 1 - share;
  share_out(part, p, share, nodes(part, shares));
}

void SkinWeights::add_hair(Vec3 p, Shares& shares) const {
  add_head(p, shares);
  let_swing(drapery_.hair, p, swinging_share(drapery_.hair, p), shares);
  const float off = head_and_neck(body_, p);
  let_swing(drapery_.curls, p, swinging_share(drapery_.curls, off), shares);
}

void SkinWeights::add_beard(Vec3 p, Shares& shares) const {
  add_head(p, shares);
  const float off = head_and_neck(body_, p);
  let_swing(drapery_.beard, p, swinging_share(drapery_.beard, off), shares);
}

/// About the head it turns with that; what lies on the shoulders goes with the coat, and what hangs
/// from there swings.
void SkinWeights::add_scarf(Vec3 p, Shares& shares) const {
  const float s = body_.scale;
  const float on_coat = smoothstep(0.02F * s, -0.07F * s, p.y - body_.neck_base.y);
  add_coat(p, shares);
  for (float& had : shares) had *= on_coat;
  Shares of_head(shares.size(), 0.0F);
  add_head(p, of_head);
  for (std::size_t k = 0; k < shares.size(); ++k) shares[k] += (1 - on_coat) * of_head[k];
  const float behind = body_.neck_base.z - p.z;
  const Sheet& hangs = behind > 0 ? drapery_.behind : drapery_.before;
  const float beside = smoothstep(0.02F * s, 0.06F * s, std::abs(behind));
  let_swing(hangs, p, beside * swinging_share(hangs, p), shares);
}

JointShares SkinWeights::at(Vec3 p, BodyRegion region) const {
  Shares shares(joint_count_ + cloth_.node.size(), 0.0F);
  switch (region) {
    case BodyRegion::Head:
      add_head(p, shares);
      break;
    case BodyRegion::Hair:
      add_hair(p, shares);
      break;
    case BodyRegion::Beard:
      add_beard(p, shares);
      break;
    case BodyRegion::Scarf:
      add_scarf(p, shares);
      break;
    case BodyRegion::Coat:
      add_coat(p, shares);
      break;
    case BodyRegion::LeftHand:
      add_chain(arm_[0], p, 1, shares);
      break;
    case BodyRegion::RightHand:
      add_chain(arm_[1], p, 1, shares);
      break;
    case BodyRegion::LeftLeg:
      add_chain(leg_[0], p, 1, shares);
      break;
    case BodyRegion::RightLeg:
      add_chain(leg_[1], p, 1, shares);
      break;
  }
  return rounded(shares);
}

}  // namespace docent::avatar
