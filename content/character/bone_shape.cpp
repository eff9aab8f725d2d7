#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "content/character/find_bones.h"

namespace docent::character {
namespace {

using import::gltf::Model;
using Path = std::vector<std::int32_t>;

/// A tree of joints seen from its ends.
class JointTree {
 public:
  JointTree(const Model& model, std::span<const Vec3> place)
      : model_{model}, place_{place}, is_joint_{skin_joints(model)} {
    for (const std::int32_t n : model.order) {
      if (!is_joint_[index(n)]) continue;
      const auto& children = model.nodes[index(n)].children;
      if (std::ranges::none_of(children, [&](std::int32_t c) { return is_joint_[index(c)]; }))
        ends_.push_back(n);
    }
  }

  const Path& ends() const { return ends_; }
  Vec3 at(std::int32_t node) const { return place_[index(node)]; }

  /// From the root down.
  Path path_to(std::int32_t node) const {
    Path path;
    for (; node >= 0 && is_joint_[index(node)]; node = model_.nodes[index(node)].parent)
      path.push_back(node);
    std::ranges::reverse(path);
    return path;
  }
  std::size_t joints_on(std::int32_t node) const {
    const auto& children = model_.nodes[index(node)].children;
    return static_cast<std::size_t>(
        std::ranges::count_if(children, [&](std::int32_t c) { return is_joint_[index(c)]; }));
  }

 private:
  static std::size_t index(std::int32_t node) { return static_cast<std::size_t>(node); }

  const Model& model_;
  std::span<const Vec3> place_;
  std::vector<bool> is_joint_;
  Path ends_;
};

/// How many joints two paths from the root share.
std::size_t shared(const Path& a, const Path& b) {
  std::size_t n = 0;
  while (n < std::min(a.size(), b.size()) && a[n] == b[n]) ++n;
  return n;
}

struct Pair {
  Path left, right;  ///< Below the joint that they hang on.
  Path above;        ///< From the root to that joint.
};

/// The two ends that are the most to one side and the other, mirrored about the middle, by a
/// measure that tells the wanted ends from the others.
template <typename Measure>
Pair pair_of(const JointTree& tree, float middle, Measure measure) {
  std::int32_t left = -1, right = -1;
  for (const std::int32_t end : tree.ends()) {
    const float x = tree.at(end).x - middle;
    std::int32_t& best = x > 0 ? left : right;
    if (best < 0 || measure(end) > measure(best)) best = end;
  }
  if (left < 0 || right < 0) return {};
  Path a = tree.path_to(left), b = tree.path_to(right);
  const std::size_t n = shared(a, b);
  if (n == 0 || n == a.size() || n == b.size()) return {};
  Pair pair;
  pair.above.assign(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(n));
  pair.left.assign(a.begin() + static_cast<std::ptrdiff_t>(n), a.end());
  pair.right.assign(b.begin() + static_cast<std::ptrdiff_t>(n), b.end());
  return pair;
}

/// The joints of an arm without fingers: up to where it branches, or so many.
void cut_fingers(const JointTree& tree, Path& arm) {
  for (std::size_t i = 2; i < arm.size(); ++i)
    if (tree.joints_on(arm[i]) > 1) return arm.resize(i + 1);
}

/// Is the first bone of an arm a collar bone: much shorter than the next?
bool begins_with_collar(const JointTree& tree, const Path& arm) {
  return arm.size() >= 4 && glm::distance(tree.at(arm[0]), tree.at(arm[1])) <
                                0.75F * glm::distance(tree.at(arm[1]), tree.at(arm[2]));
}

void name_arm(const JointTree& tree, Path arm, HumanBone shoulder, BoneMap& bones) {
  cut_fingers(tree, arm);
  std::size_t first = 0;
  if (begins_with_collar(tree, arm)) bones[shoulder] = arm[first++];
  if (arm.size() < first + 3) return;
  for (std::size_t k = 0; k < 3; ++k) bones.node[index_of(shoulder) + 1 + k] = arm[first + k];
}

void name_leg(const Path& leg, HumanBone upper, BoneMap& bones) {
  if (leg.size() < 3) return;
  for (std::size_t k = 0; k < std::min<std::size_t>(leg.size(), 4); ++k)
    bones.node[index_of(upper) + k] = leg[k];
}

}  // namespace

BoneMap bones_by_shape(const Model& model, std::span<const Vec3> place) {
  BoneMap bones;
  const JointTree tree(model, place);
  if (tree.ends().size() < 5) return bones;
  std::int32_t top = tree.ends().front();
  for (const std::int32_t end : tree.ends())
    if (tree.at(end).y > tree.at(top).y) top = end;
  const float middle = tree.at(top).x;
  const Pair legs = pair_of(tree, middle, [&](std::int32_t end) { return -tree.at(end).y; });
  if (legs.left.size() < 3 || legs.right.size() < 3) return bones;
  const float hips = tree.at(legs.above.back()).y;
  const Pair arms = pair_of(tree, middle, [&](std::int32_t end) {
    const bool is_leg = tree.at(end).y < 0.5F * (hips + tree.at(legs.left.back()).y);
    return is_leg ? -1.0F : std::abs(tree.at(end).x - middle);
  });
  const Path head = tree.path_to(top);
  const std::size_t fork = std::min(shared(head, arms.above), arms.above.size());
  if (arms.left.size() < 3 || arms.right.size() < 3 || head.size() <= fork) return bones;

  bones[HumanBone::Hips] = legs.above.back();
  name_leg(legs.left, HumanBone::LeftUpperLeg, bones);
  name_leg(legs.right, HumanBone::RightUpperLeg, bones);
  name_arm(tree, arms.left, HumanBone::LeftShoulder, bones);
  name_arm(tree, arms.right, HumanBone::RightShoulder, bones);
  const std::size_t above = head.size() - fork;
  bones[HumanBone::Head] = above >= 2 ? head[fork + 1] : head[fork];
  if (above >= 2) bones[HumanBone::Neck] = head[fork];
  return bones;
}

}  // namespace docent::character
