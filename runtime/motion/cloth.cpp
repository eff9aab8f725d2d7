#include "runtime/motion/cloth.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <cstddef>

#include "runtime/motion/cloth_limb.h"

namespace docent::motion {
namespace {

constexpr double cloth_step = 1.0 / 120;  // seconds
constexpr auto step_seconds = static_cast<float>(cloth_step);
/// Longer than that without a call, and the cloth hangs still: seconds.
constexpr double longest_frame = 0.25;
/// Quicker than that from one call to the next, and the body has been placed anew.
constexpr double most_speed = 8;   // metres a second
constexpr double most_jump = 0.2;  // metres, at any speed
/// No cloth is further from where it is carried, or quicker about that.
constexpr float most_lag = 0.25F;         // metres
constexpr float most_inward = 0.006F;     // metres
constexpr float most_swing_speed = 4.0F;  // metres a second
constexpr float taken_along = 0.3F;       // share of a limb's push that cloth keeps as motion
constexpr float firm_length = 0.15F;      // metres of firm cloth above the highest nodes
constexpr float least_bone = 1e-4F;       // metres

/// The blend of the matrices that carry a node.
Mat4 carrier(const ClothNode& node, std::span<const Mat4> palette) noexcept {
  Mat4 sum(0);
  for (std::size_t k = 0; k < node.joint.size(); ++k)
    if (node.weight[k] != 0)
      sum += (static_cast<float>(node.weight[k]) / 255) * palette[node.joint[k]];
  return sum;
}

/// What is worn over limbs lies on more than the limbs that it is kept out of: it hardly sinks in.
Vec3 not_inward(Vec3 lag, Vec3 outward, float most) noexcept {
  const float in = -most - glm::dot(lag, outward);
  return in > 0 ? lag + in * outward : lag;
}

Vec3 at_most(Vec3 v, float length) noexcept {
  const float square = glm::dot(v, v);
  return square > length * length ? v * (length / std::sqrt(square)) : v;
}

/// As long as another, or that one where it has no direction.
Vec3 as_long_as(Vec3 length, Vec3 v) noexcept {
  const float square = glm::dot(v, v);
  if (!(square > least_bone * least_bone && square < 1e12F)) return length;
  return v * std::sqrt(glm::dot(length, length) / square);
}

class HangingCloth {
 public:
  HangingCloth(const ClothView& cloth, std::span<Mat4> palette, ClothMotion& motion) noexcept
      : cloth_{cloth},
        palette_{palette},
        first_{palette.size() - cloth.node.size()},
        motion_{motion} {}

  /// Where joints and limbs are now; the nodes' matrices are how they are carried.
  void carry() noexcept {
    for (std::size_t n = 0; n < size(); ++n) {
      const ClothNode& node = cloth_.node[n];
      Mat4& matrix = palette_[first_ + n];
      matrix = carrier(node, palette_);
      motion_.carried[n] = Vec3(matrix * Vec4(node.place, 1));
      const Vec3 outward = glm::mat3(matrix) * node.outward;
      motion_.outward[n] = outward / std::sqrt(std::max(glm::dot(outward, outward), 1e-12F));
      motion_.root[n] = Vec3(matrix * Vec4(node.root, 1));
    }
    for (std::size_t c = 0; c < cloth_.collider.size(); ++c) {
      const ClothCollider& limb = cloth_.collider[c];
      motion_.end[2 * c] = Vec3(palette_[limb.joint] * Vec4(limb.from, 1));
      motion_.end[2 * c + 1] = Vec3(palette_[limb.joint] * Vec4(limb.to, 1));
    }
  }

  bool is_placed_anew(double seconds) const noexcept {
    if (!motion_.is_placed || seconds > longest_frame) return true;
    const auto most = static_cast<float>(most_jump + most_speed * seconds);
    const Vec3 moved = motion_.carried[0] - motion_.carried_before[0];
    return !(glm::dot(moved, moved) < most * most);
  }

  void rest() noexcept {
    keep();
    place_limbs(1);
    for (std::size_t n = 0; n < size(); ++n) {
      motion_.lag[n] = motion_.velocity[n] = Vec3{};
      if (is_bone(n)) hang_bone(n);
      motion_.lag_before[n] = motion_.lag[n];
    }
    motion_.ahead = 0;
    motion_.is_placed = motion_.is_at_rest = true;
  }

  void swing(double seconds) noexcept {
    double at = -motion_.ahead;  // since the last call
    motion_.ahead += seconds;
    while (motion_.ahead >= cloth_step) {
      motion_.ahead -= cloth_step;
      const double before = at;
      at += cloth_step;
      take_step(static_cast<float>(before / seconds), static_cast<float>(at / seconds));
    }
    keep();
  }

  /// Places the nodes, between the last two steps as the frame is, and turns them as they hang.
  void draw() noexcept {
    const auto share = static_cast<float>(motion_.ahead / cloth_step);
    place_limbs(1);
    for (std::size_t n = 0; n < size(); ++n) {
      const Vec3 lag = glm::mix(motion_.lag_before[n], motion_.lag[n], share);
      const Vec3 place = motion_.carried[n] + lag;
      motion_.place[n] = is_bone(n) ? out_of_limbs(n, bone_of(n, 1), place) : pushed_out(n, place);
    }
    for (std::size_t n = 0; n < size(); ++n) push_between(n);
    for (std::size_t n = 0; n < size(); ++n)
      if (has_moved_[n]) motion_.place[n] = pushed_out(n, motion_.place[n]);
    for (std::size_t n = 0; n < size(); ++n)
      if (is_bone(n))
        turn_bone(n);
      else
        turn(n);
  }

 private:
  std::size_t size() const noexcept { return cloth_.node.size(); }
  bool is_bone(std::size_t n) const noexcept { return cloth_.node[n].kind == ClothKind::Bone; }

  void keep() noexcept {
    std::copy_n(motion_.carried.begin(), size(), motion_.carried_before.begin());
    std::copy_n(motion_.root.begin(), size(), motion_.root_before.begin());
    std::copy_n(motion_.end.begin(), 2 * cloth_.collider.size(), motion_.end_before.begin());
  }

  /// Between the last call and this one.
  Vec3 carried(std::size_t n, float share) const noexcept {
    return glm::mix(motion_.carried_before[n], motion_.carried[n], share);
  }

  void place_limbs(float share) noexcept {
    for (std::size_t c = 0; c < cloth_.collider.size(); ++c) {
      const ClothCollider& limb = cloth_.collider[c];
      const Vec3 from = glm::mix(motion_.end_before[2 * c], motion_.end[2 * c], share);
      const Vec3 to = glm::mix(motion_.end_before[2 * c + 1], motion_.end[2 * c + 1], share);
      const float square = glm::dot(to - from, to - from);
      limb_[c] = {from, to - from, limb.from_radius, limb.to_radius - limb.from_radius,
                  square > 1e-8F ? 1 / square : 0.0F};
    }
  }

  /// How far along `outward` a place has to go to be out of all limbs that a node keeps out of.
  float way_out(std::size_t n, Vec3 place, float around, Vec3 outward) const noexcept {
    float furthest = 0;
    for (unsigned c = 0, bits = cloth_.node[n].keeps_out; bits != 0; ++c, bits >>= 1U)
      if ((bits & 1U) != 0)
        furthest = std::max(furthest, motion::way_out(limb_[c], place, around, outward));
    return std::min(furthest, most_lag);
  }
  Vec3 pushed_out(std::size_t n, Vec3 place) const noexcept {
    return place +
           way_out(n, place, cloth_.node[n].radius, motion_.outward[n]) * motion_.outward[n];
  }

  /// Where cloth between two nodes is in a limb, both give way.
  void push_apart(std::size_t a, std::size_t b) noexcept {
    const Vec3 sum = motion_.outward[a] + motion_.outward[b];
    const float square = glm::dot(sum, sum);
    if (square < 0.25F) return;
    const Vec3 outward = sum / std::sqrt(square);
    const Vec3 off = motion_.place[b] - motion_.place[a];
    const Vec3 bent = motion_.outward[b] - motion_.outward[a];
    // What lies between them on a circle bulges by an eighth of their distance for each radian.
    const float bulge = 0.125F * std::sqrt(glm::dot(off, off) * glm::dot(bent, bent));
    const Vec3 middle = motion_.place[a] + 0.5F * off + bulge * outward;
    const float around = 0.5F * (cloth_.node[a].radius + cloth_.node[b].radius);
    const float push = way_out(a, middle, around, outward);
    if (push <= 0) return;
    motion_.place[a] += push * outward;
    motion_.place[b] += push * outward;
    has_moved_[a] = has_moved_[b] = true;
  }

  void push_between(std::size_t n) noexcept {
    const ClothNode& node = cloth_.node[n];
    if (node.keeps_out == 0 || is_bone(n)) return;
    if (node.left != ClothNode::none) push_apart(n, node.left);
    if (node.above != ClothNode::none) push_apart(n, node.above);
  }

  Vec3 neighbours_lag(const ClothNode& node) const noexcept {
    return 0.5F * (motion_.lag_before[node.left] + motion_.lag_before[node.right]);
  }

  /// A node hangs from the one above it at the length at which the joints carry both.
  Vec3 at_length(std::size_t n, Vec3 lag, Vec3 here, float share) const noexcept {
    const std::size_t above = cloth_.node[n].above;
    const Vec3 length = here - carried(above, share);
    const Vec3 off = length + lag - motion_.lag[above];
    const float square = glm::dot(off, off);
    if (square < 1e-9F) return lag;
    return motion_.lag[above] + off * std::sqrt(glm::dot(length, length) / square) - length;
  }

  void take_step(float before, float now) noexcept {
    place_limbs(now);
    std::copy_n(motion_.lag.begin(), size(), motion_.lag_before.begin());
    for (std::size_t n = 0; n < size(); ++n) {
      if (is_bone(n)) {
        step_bone(n, before, now);
        continue;
      }
      const ClothNode& node = cloth_.node[n];
      const Vec3 here = carried(n, now);
      const Vec3 speed = (here - carried(n, before)) / step_seconds;
      if (motion_.is_at_rest) motion_.velocity[n] = speed;
      const Vec3 lag = motion_.lag_before[n];
      Vec3 pull = -node.stiffness * lag - node.damping * (motion_.velocity[n] - speed) -
                  node.drag * motion_.velocity[n];
      if (node.left != ClothNode::none && node.right != ClothNode::none)
        pull += node.tension * (neighbours_lag(node) - lag);
      Vec3 next = lag + (motion_.velocity[n] + step_seconds * pull - speed) * step_seconds;
      const bool is_first = node.above == ClothNode::none;
      if (!is_first) next = at_length(n, next, here, now);
      if (node.keeps_out != 0)
        next = not_inward(next, motion_.outward[n], is_first ? 0 : most_inward);
      const Vec3 pushed = at_most(pushed_out(n, here + next) - here, most_lag);
      // A limb takes cloth along; it does not throw it.
      const Vec3 taken = glm::mix(next, pushed, taken_along) - lag;
      motion_.velocity[n] = speed + at_most(taken / step_seconds, most_swing_speed);
      next = pushed;
      motion_.lag[n] = next;
    }
    motion_.is_at_rest = false;
  }

  /// A bone at a moment: where it begins, and how it would point if it did not swing itself, but
  /// only as the bone above it does, from which it hangs.
  struct Bone {
    Vec3 root, carried;
  };
  Vec3 carried_root(std::size_t n, float share) const noexcept {
    return glm::mix(motion_.root_before[n], motion_.root[n], share);
  }
  /// Of a bone of which the one above hangs already.
  Bone bone_of(std::size_t n, float share) noexcept {
    const Vec3 root = carried_root(n, share), length = carried(n, share) - root;
    const std::size_t above = cloth_.node[n].above;
    Bone bone{root, length};
    if (above != ClothNode::none) {
      const Vec3 end = carried(above, share);
      const ShortestTurn turned(end - carried_root(above, share),
                                motion_.place[above] - motion_.begin[above]);
      bone = {motion_.place[above] + turned * (root - end), turned * length};
    }
    motion_.begin[n] = bone.root;
    return bone;
  }

  Vec3 out_of_limbs(std::size_t n, const Bone& bone, Vec3 place) const noexcept {
    const ClothNode& node = cloth_.node[n];
    place = bone.root + as_long_as(bone.carried, place - bone.root);
    for (unsigned c = 0, bits = node.keeps_out; bits != 0; ++c, bits >>= 1U) {
      if ((bits & 1U) == 0) continue;
      const Vec3 out = out_of(limb_[c], place, node.radius);
      if (out != place) place = bone.root + as_long_as(bone.carried, out - bone.root);
    }
    return place;
  }

  /// Where a bone hangs that has come to rest: its spring and its weight hold each other.
  void hang_bone(std::size_t n) noexcept {
    const Bone bone = bone_of(n, 1);
    const Vec3 pull = cloth_.node[n].stiffness * bone.carried + cloth_.node[n].gravity;
    motion_.place[n] = out_of_limbs(n, bone, bone.root + as_long_as(bone.carried, pull));
    motion_.lag[n] = motion_.place[n] - motion_.carried[n];
  }

  void step_bone(std::size_t n, float before, float now) noexcept {
    const ClothNode& node = cloth_.node[n];
    const Bone bone = bone_of(n, now);
    const Vec3 here = carried(n, now);
    const Vec3 last = carried(n, before) + motion_.lag_before[n];
    const Vec3 speed = (here - carried(n, before)) / step_seconds;
    Vec3& velocity = motion_.velocity[n];
    if (motion_.is_at_rest) velocity = speed;
    const Vec3 along = last + step_seconds * speed;  // had it not swung
    const Vec3 pull = node.stiffness * (bone.root + bone.carried - along) -
                      node.damping * (velocity - speed) - node.drag * velocity + node.gravity;
    Vec3 next = last + step_seconds * (velocity + step_seconds * pull);
    next = bone.root + as_long_as(bone.carried, next - bone.root);
    motion_.place[n] = out_of_limbs(n, bone, next);
    motion_.lag[n] = motion_.place[n] - here;
    const Vec3 taken = glm::mix(next, motion_.place[n], taken_along) - along;
    const Vec3 swings = at_most(taken / step_seconds, most_swing_speed);
    velocity = speed + (glm::dot(swings, swings) < 1e6F ? swings : Vec3{});
  }

  void turn_bone(std::size_t n) noexcept {
    Mat4& matrix = palette_[first_ + n];
    const glm::mat3 turned =
        ShortestTurn(motion_.carried[n] - motion_.root[n], motion_.place[n] - motion_.begin[n]) *
        glm::mat3(matrix);
    matrix = Mat4(turned);
    matrix[3] = Vec4(motion_.begin[n] - turned * cloth_.node[n].root, 1);
  }

  /// A node turns as the cloth between those above and below it does. Above the highest it is
  /// firm.
  void turn(std::size_t n) noexcept {
    const ClothNode& node = cloth_.node[n];
    Mat4& matrix = palette_[first_ + n];
    const std::size_t below = n + 1 < size() && cloth_.node[n + 1].above == n ? n + 1 : n;
    const Vec3 firm = motion_.carried[n] + firm_length * Vec3(matrix[1]);
    const bool hangs = node.above != ClothNode::none;
    const Vec3 carried = hangs ? motion_.carried[node.above] : firm;
    const Vec3 place = hangs ? motion_.place[node.above] : firm;
    const glm::mat3 turned =
        ShortestTurn(carried - motion_.carried[below], place - motion_.place[below]) *
        glm::mat3(matrix);
    matrix = Mat4(turned);
    matrix[3] = Vec4(motion_.place[n] - turned * node.place, 1);
  }

  const ClothView& cloth_;
  std::span<Mat4> palette_;
  std::size_t first_;
  ClothMotion& motion_;
  std::array<Limb, most_cloth_colliders> limb_;
  std::bitset<256> has_moved_;  ///< By what is between it and others.
};

}  // namespace

ClothMotion make_cloth_motion(std::size_t nodes) {
  ClothMotion motion;
  for (std::vector<Vec3>* each :
       {&motion.lag, &motion.lag_before, &motion.velocity, &motion.carried, &motion.carried_before,
        &motion.root, &motion.root_before, &motion.begin, &motion.outward, &motion.place})
    each->resize(nodes);
  motion.end.resize(2 * most_cloth_colliders);
  motion.end_before.resize(2 * most_cloth_colliders);
  return motion;
}

void hang(const ClothView& cloth, std::span<Mat4> palette, ClothMotion& motion) noexcept {
  if (cloth.node.empty()) return;
  HangingCloth hanging(cloth, palette, motion);
  hanging.carry();
  hanging.rest();
  hanging.draw();
}

void swing(const ClothView& cloth, double seconds, std::span<Mat4> palette,
           ClothMotion& motion) noexcept {
  if (cloth.node.empty()) return;
  HangingCloth hanging(cloth, palette, motion);
  hanging.carry();
  if (hanging.is_placed_anew(seconds))
    hanging.rest();
  else if (seconds > 0)
    hanging.swing(seconds);
  hanging.draw();
}

}  // namespace docent::motion
