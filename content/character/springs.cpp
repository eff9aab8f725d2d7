#include "content/character/springs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include <glm/geometric.hpp>

namespace docent::character {
namespace {

using import::gltf::entry;
using import::gltf::Model;
using import::gltf::none;

/// VRM's programs add forces once a frame, at 60 frames a second.
constexpr float vrm_rate = 60;
/// UniVRM: a last joint of VRM 0.x reaches so far beyond itself, metres.
constexpr float reach_of_last = 0.07F;
/// Nobody's drag is stronger: of a drag of 1, after which nothing moves on.
constexpr float most_kept_drag = 0.85F;
/// Of the body's height: shorter bones do not turn, further ones are no part of the body.
constexpr float shortest_spring = 0.002F, farthest_spring = 3;
/// How many nodes may lie between two joints of a chain.
constexpr int most_between = 64;

/// Which sentences were said, and of how many.
struct Told {
  std::size_t body = 0, twice = 0, apart = 0, far = 0, limp = 0, enclosed = 0;
  std::string apart_first, body_first;
};

class Taking {
 public:
  Taking(const Model& model, const Standing& standing)
      : model_{model},
        standing_{standing},
        is_body_(model.nodes.size()),
        body_of_(model.nodes.size(), -1) {
    height_ =
        glm::distance(standing.at_bind(HumanBone::Head), standing.at_bind(HumanBone::LeftFoot));
    for (std::size_t b = 0; b < bone_count; ++b) {
      const std::int32_t node = standing.bones.node[b];
      if (node < 0) continue;
      body_of_[entry(node)] = static_cast<std::int32_t>(b);
      for (std::int32_t n = node; n != none && !is_body_[entry(n)]; n = parent_of(n))
        is_body_[entry(n)] = true;
    }
    for (const std::int32_t n : model.order)
      if (body_of_[entry(n)] < 0 && parent_of(n) != none)
        body_of_[entry(n)] = body_of_[entry(parent_of(n))];
    springs_.bone_of_node.assign(model.nodes.size(), -1);
  }

  void take_balls() {
    for (const import::gltf::SpringCollider& it : model_.vrm.colliders) {
      const Mat4& node = standing_.bind[entry(it.node)];
      springs_.ball.push_back({.body = body_of(it.node),
                               .from = Vec3(node * Vec4(it.from, 1)),
                               .to = Vec3(node * Vec4(it.to, 1)),
                               .radius = size_of(it.node) * it.radius});
    }
  }

  void take(const import::gltf::Spring& spring) {
    if (spring.joints.empty()) return;
    if (spring.takes_all_below)
      take_all_below(spring, spring.joints.front());
    else
      take_chain(spring);
  }

  Springs made() { return std::move(springs_); }
  const Told& told() const { return told_; }

 private:
  std::int32_t parent_of(std::int32_t node) const { return model_.nodes[entry(node)].parent; }
  HumanBone body_of(std::int32_t node) const {
    const std::int32_t bone = body_of_[entry(node)];
    return bone < 0 ? HumanBone::Hips : static_cast<HumanBone>(bone);
  }
  Vec3 place_of(std::int32_t node) const { return Vec3(standing_.bind[entry(node)][3]); }
  /// How much larger a node makes what hangs on it.
  float size_of(std::int32_t node) const {
    const Mat4& m = standing_.rest[entry(node)];
    return std::max({glm::length(Vec3(m[0])), glm::length(Vec3(m[1])), glm::length(Vec3(m[2]))});
  }
  bool hangs_below(std::int32_t node, std::int32_t above) const {
    for (int k = 0; k < most_between && node != none; ++k) {
      node = parent_of(node);
      if (node == above) return true;
    }
    return false;
  }
  /// Can a node swing? Why not is told.
  bool can_swing(std::int32_t node) {
    if (is_body_[entry(node)]) {
      if (told_.body++ == 0) told_.body_first = model_.nodes[entry(node)].name;
      return false;
    }
    if (is_taken_.contains(node)) {
      ++told_.twice;
      return false;
    }
    return true;
  }

  void take_chain(const import::gltf::Spring& spring) {
    std::int32_t above = -1;
    for (std::size_t k = 0; k + 1 < spring.joints.size(); ++k) {
      const std::int32_t node = spring.joints[k].node, next = spring.joints[k + 1].node;
      if (!hangs_below(next, node)) {
        if (told_.apart++ == 0)
          told_.apart_first = fmt::format("{}.joints[{}]", spring.part, k + 1);
        return;
      }
      if (!can_swing(node) || is_body_[entry(next)]) return;
      above = add(spring, spring.joints[k], node, place_of(next), above);
    }
    // What hangs on the last goes with the bone of which it is the end.
    if (above >= 0) is_taken_.insert(spring.joints.back().node);
  }

  /// VRM 0.x: every node turns about itself, towards its first child.
  void take_all_below(const import::gltf::Spring& spring, const import::gltf::SpringJoint& joint) {
    std::vector<std::pair<std::int32_t, std::int32_t>> open{{joint.node, -1}};
    while (!open.empty()) {
      const auto [node, above] = open.back();
      open.pop_back();
      if (!can_swing(node)) continue;
      const auto& children = model_.nodes[entry(node)].children;
      Vec3 end{0};
      if (!children.empty()) {
        end = place_of(children.front());
      } else {
        const Vec3 along =
            parent_of(node) == none ? Vec3{0} : place_of(node) - place_of(parent_of(node));
        const float length = glm::length(along);
        end = place_of(node) + (length > 0 ? reach_of_last / length : 0.0F) * along;
      }
      const std::int32_t bone = add(spring, joint, node, end, above);
      for (const std::int32_t child : children) open.emplace_back(child, bone);
    }
  }

  /// Adds a bone; the one that its node goes with then, which is the one above where it is too
  /// short to turn.
  std::int32_t add(const import::gltf::Spring& spring, const import::gltf::SpringJoint& joint,
                   std::int32_t node, Vec3 end, std::int32_t above) {
    is_taken_.insert(node);
    SpringBone bone{.body = body_of(node), .above = above, .root = place_of(node), .end = end};
    springs_.bone_of_node[entry(node)] = above;
    const float length = glm::distance(bone.root, bone.end);
    const Vec3 hips = standing_.at_bind(HumanBone::Hips);
    const float off = std::max(glm::distance(bone.root, hips), glm::distance(bone.end, hips));
    if (!(off < farthest_spring * height_) || !std::isfinite(length)) return ++told_.far, above;
    if (!(length > shortest_spring * height_)) return above;
    bone.pull = vrm_rate * joint.stiffness;
    bone.gravity = vrm_rate * Vec3(standing_.turn * Vec4(joint.gravity, 0));
    bone.drag = -vrm_rate * std::log(1 - std::min(joint.drag, most_kept_drag));
    bone.radius = size_of(node) * joint.hit_radius;
    if (!(bone.pull + glm::length(bone.gravity) > 0) || !std::isfinite(bone.pull) ||
        !std::isfinite(glm::length(bone.gravity)) || !std::isfinite(bone.radius))
      return ++told_.limp, above;
    for (const std::uint32_t c : spring.colliders)
      if (is_free_of(springs_.ball[c], bone, length))
        bone.colliders.push_back(c);
      else
        ++told_.enclosed;
    springs_.bone.push_back(std::move(bone));
    return springs_.bone_of_node[entry(node)] = static_cast<std::int32_t>(springs_.bone.size()) - 1;
  }

  /// Can the bone's end be out of a collider at all?
  bool is_free_of(const SpringBall& ball, const SpringBone& bone, float length) const {
    const Vec3 along = ball.to - ball.from;
    const float square = glm::dot(along, along);
    const float share =
        square > 0 ? std::clamp(glm::dot(bone.root - ball.from, along) / square, 0.0F, 1.0F) : 0.0F;
    const float off = glm::distance(bone.root, ball.from + share * along);
    return off + length > ball.radius + bone.radius && ball.radius < farthest_spring * height_;
  }

  const Model& model_;
  const Standing& standing_;
  std::vector<bool> is_body_;          ///< A bone of the body, or above one.
  std::vector<std::int32_t> body_of_;  ///< HumanBone that each node goes with; -1: none.
  std::set<std::int32_t> is_taken_;
  float height_ = 0;
  Springs springs_;
  Told told_;
};

/// Counts the vertices that go with each bone.
void weigh(const Model& model, Springs& springs) {
  std::vector<std::int32_t> of_node = springs.bone_of_node;
  for (const std::int32_t n : model.order)
    if (const std::int32_t parent = model.nodes[entry(n)].parent;
        of_node[entry(n)] < 0 && parent != none)
      of_node[entry(n)] = of_node[entry(parent)];
  const auto add = [&](std::int32_t node, double share) {
    if (const std::int32_t bone = of_node[entry(node)]; bone >= 0)
      springs.bone[entry(bone)].skin += share;
  };
  for (const std::int32_t n : model.order) {
    const import::gltf::Node& node = model.nodes[entry(n)];
    if (!node.in_scene || node.mesh < 0) continue;
    for (const import::gltf::Primitive& primitive : model.meshes[entry(node.mesh)].primitives) {
      if (node.skin < 0 || primitive.joint.empty()) {
        add(n, static_cast<double>(primitive.position.size()));
        continue;
      }
      const auto& joints = model.skins[entry(node.skin)].joints;
      for (std::size_t v = 0; v < primitive.joint.size(); ++v)
        for (std::size_t k = 0; k < 4; ++k)
          add(joints[std::min<std::size_t>(primitive.joint[v][k], joints.size() - 1)],
              static_cast<double>(primitive.weight[v][static_cast<int>(k)]));
    }
  }
}

/// What makes bones fewer.
class Thinning {
 public:
  explicit Thinning(const Springs& springs) : springs_{springs}, became_(size()), hanging_(size()) {
    for (std::size_t b = 0; b < size(); ++b) {
      became_[b] = static_cast<std::int32_t>(b);
      if (const std::int32_t above = springs_.bone[b].above; above >= 0) ++hanging_[entry(above)];
    }
    for (std::size_t b = 0; b < size(); ++b)
      if (hanging_[b] == 0) ends_.insert({burden(b), b});
    left_ = size();
  }

  /// Bones that nothing goes with, at the ends of chains.
  void leave_out_unseen() {
    while (!ends_.empty() && ends_.begin()->first <= 0) leave_out(ends_.begin()->second);
  }
  void leave_out_beyond(std::size_t most) {
    while (left_ > most) leave_out(ends_.begin()->second);
  }

  Springs made(std::vector<std::int32_t>& became) {
    Springs fewer{.bone = {}, .ball = springs_.ball, .bone_of_node = springs_.bone_of_node};
    std::vector<std::int32_t> index(size(), -1);
    for (std::size_t b = 0; b < size(); ++b) {
      // Those above come first, so what they went with is known.
      std::int32_t& it = became_[b];
      if (it >= 0 && entry(it) != b) it = became_[entry(it)];
      if (it < 0 || entry(it) != b) continue;
      index[b] = static_cast<std::int32_t>(fewer.bone.size());
      fewer.bone.push_back(springs_.bone[b]);
      if (std::int32_t& above = fewer.bone.back().above; above >= 0) above = index[entry(above)];
    }
    became.assign(size(), -1);
    for (std::size_t b = 0; b < size(); ++b)
      if (became_[b] >= 0) became[b] = index[entry(became_[b])];
    for (std::int32_t& bone : fewer.bone_of_node)
      if (bone >= 0) bone = became[entry(bone)];
    return fewer;
  }

 private:
  std::size_t size() const { return springs_.bone.size(); }
  double burden(std::size_t b) const {
    const SpringBone& bone = springs_.bone[b];
    return bone.skin * static_cast<double>(glm::distance(bone.root, bone.end));
  }

  void leave_out(std::size_t b) {
    ends_.erase({burden(b), b});
    --left_;
    const std::int32_t above = springs_.bone[b].above;
    became_[b] = above;
    if (above < 0) return;
    SpringBone& upper = springs_.bone[entry(above)];
    const bool was_seen = springs_.bone[b].skin > 0;
    if (--hanging_[entry(above)] > 0) {
      upper.skin += springs_.bone[b].skin;
      return;
    }
    if (was_seen && is_straight(upper, springs_.bone[b])) {
      upper.end = springs_.bone[b].end;
      upper.radius = springs_.bone[b].radius;
    }
    upper.skin += springs_.bone[b].skin;
    ends_.insert({burden(entry(above)), entry(above)});
  }
  static bool is_straight(const SpringBone& upper, const SpringBone& lower) {
    return glm::dot(upper.end - upper.root, lower.end - lower.root) > 0;
  }

  Springs springs_;
  std::vector<std::int32_t> became_;  ///< Itself, or what it hangs from.
  std::vector<int> hanging_;          ///< How many hang from it.
  std::set<std::pair<double, std::size_t>> ends_;
  std::size_t left_ = 0;
};

void tell(const Told& told, std::vector<std::string>& notes) {
  const auto note = [&](std::size_t count, const std::string& what) {
    if (count > 0) notes.push_back(fmt::format("{} {}", count, what));
  };
  note(told.body,
       fmt::format("of its spring joints are bones of the body (\"{}\") and do not swing",
                   told.body_first));
  note(told.twice, "of its spring joints are named twice; the first spring has them");
  note(told.apart, fmt::format("of its springs end early: {} does not hang on the joint before it",
                               told.apart_first));
  note(told.far, "of its spring joints lie far from the body and do not swing");
  note(told.limp, "of its spring joints have neither stiffness nor gravity and go with the body");
  note(told.enclosed, "times a collider encloses what should swing outside of it, and is left out");
}

}  // namespace

Springs springs_of(const Model& model, const Standing& standing, std::vector<std::string>& notes) {
  Taking taking(model, standing);
  taking.take_balls();
  for (const import::gltf::Spring& spring : model.vrm.springs) taking.take(spring);
  tell(taking.told(), notes);
  Springs all = taking.made();
  weigh(model, all);
  Thinning thinning(all);
  thinning.leave_out_unseen();
  thinning.leave_out_beyond(most_spring_bones);
  std::vector<std::int32_t> became;
  return thinning.made(became);
}

std::vector<std::uint32_t> busiest_balls(const Springs& springs, std::size_t most) {
  std::vector<std::uint32_t> ball, uses(springs.ball.size());
  for (const SpringBone& bone : springs.bone)
    for (const std::uint32_t c : bone.colliders)
      if (uses[c]++ == 0) ball.push_back(c);
  std::ranges::sort(ball, [&](std::uint32_t a, std::uint32_t b) {
    return uses[a] != uses[b] ? uses[a] > uses[b] : a < b;
  });
  ball.resize(std::min(ball.size(), most));
  return ball;
}

Springs with_at_most(std::size_t most, const Springs& springs, std::vector<std::int32_t>& became) {
  Thinning thinning(springs);
  thinning.leave_out_beyond(most);
  return thinning.made(became);
}

}  // namespace docent::character
