#include "runtime/motion/cloth.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <cstddef>

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
constexpr int most_parts = 4;             // of a way out of a limb
constexpr float least_room = 0.0002F;     // metres: then it is out
constexpr float most_turn = 0.999F;       // cosine: below it a node turns with its cloth

/// The blend of the matrices that carry a node.
Mat4 carrier(const ClothNode& node, std::span<const Mat4> palette) noexcept {
  Mat4 sum(0);
  for (std::size_t k = 0; k < node.joint.size(); ++k)
    if (node.weight[k] != 0)
      sum += (static_cast<float>(node.weight[k]) / 255) * palette[node.joint[k]];
  return sum;
}

/// A limb at one moment.
struct Limb {
  Vec3 from, along;
  float from_radius, more_radius;
  float inverse_length;  ///< Of its square; 0: a ball.
};

/// How far along `outward` a ball has to go to be out of a limb, as the part of the limb that is
/// nearest now has it: metres.
float way_out_of_nearest(const Limb& limb, Vec3 point, float around, Vec3 outward) noexcept {
  const Vec3 off = point - limb.from;
  const float share = std::clamp(glm::dot(off, limb.along) * limb.inverse_length, 0.0F, 1.0F);
  const float radius = limb.from_radius + share * limb.more_radius + around;
  const Vec3 across = off - share * limb.along;
  const float inside = radius * radius - glm::dot(across, across);
  if (inside <= 0) return 0;
  // Beside the limb only what leads across its axis leads out of it; past its end all does.
  const bool beside = share > 0 && share < 1;
  const Vec3 way =
      beside ? outward - (glm::dot(outward, limb.along) * limb.inverse_length) * limb.along
             : outward;
  const float quick = std::max(glm::dot(way, way), 0.04F);
  const float toward = glm::dot(across, way);
  return (std::sqrt(toward * toward + quick * inside) - toward) / quick;
}

/// The same, out of all of the limb.
float way_out(const Limb& limb, Vec3 point, float around, Vec3 outward) noexcept {
  float whole = 0;
  for (int part = 0; part < most_parts; ++part) {
    const float more = way_out_of_nearest(limb, point + whole * outward, around, outward);
    if (more <= 0) break;
    whole += more + least_room;
  }
  return whole;
}

/// The turn that takes one direction to another by the shortest way.
glm::mat3 shortest_turn(Vec3 from, Vec3 to) noexcept {
  const float lengths = std::sqrt(glm::dot(from, from) * glm::dot(to, to));
  if (lengths < 1e-9F) return glm::mat3(1);
  const float cosine = glm::dot(from, to) / lengths;
  if (cosine < -most_turn) return glm::mat3(1);
  const Vec3 a = glm::cross(from, to) / lengths;
  const float b = 1 / (1 + cosine);
  return {Vec3{cosine + b * a.x * a.x, b * a.x * a.y + a.z, b * a.x * a.z - a.y},
          Vec3{b * a.x * a.y - a.z, cosine + b * a.y * a.y, b * a.y * a.z + a.x},
          Vec3{b * a.x * a.z + a.y, b * a.y * a.z - a.x, cosine + b * a.z * a.z}};
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
    for (std::size_t n = 0; n < size(); ++n)
      motion_.lag[n] = motion_.lag_before[n] = motion_.velocity[n] = Vec3{};
    motion_.ahead = 0;
    motion_.is_placed = motion_.is_at_rest = true;
    keep();
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
      motion_.place[n] = pushed_out(n, motion_.carried[n] + lag);
    }
    for (std::size_t n = 0; n < size(); ++n) push_between(n);
    for (std::size_t n = 0; n < size(); ++n)
      if (has_moved_[n]) motion_.place[n] = pushed_out(n, motion_.place[n]);
    for (std::size_t n = 0; n < size(); ++n) turn(n);
  }

 private:
  std::size_t size() const noexcept { return cloth_.node.size(); }

  void keep() noexcept {
    std::copy_n(motion_.carried.begin(), size(), motion_.carried_before.begin());
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
    if (node.keeps_out == 0) return;
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
        shortest_turn(carried - motion_.carried[below], place - motion_.place[below]) *
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
        &motion.outward, &motion.place})
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
