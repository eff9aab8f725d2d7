#include "runtime/motion/cloth.h"

#include <algorithm>
#include <array>
#include <bit>
#include <bitset>
#include <cmath>
#include <cstddef>
#include <cstring>

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
constexpr float longest_bone = 1e6F;      // metres

/// A matrix by its columns.
struct Columns {
  Lanes x, y, z, w;

  Lanes along(Vec3 v) const noexcept { return v.x * x + v.y * y + v.z * z; }
  Lanes at(Vec3 p) const noexcept { return along(p) + w; }
};
Columns columns_of(const Mat4& m) noexcept {
  return {lanes_of(m[0]), lanes_of(m[1]), lanes_of(m[2]), lanes_of(m[3])};
}
void write(const Columns& c, Mat4& m) noexcept {
  std::memcpy(static_cast<void*>(&m), &c, sizeof m);
}

/// The blend of the matrices that carry a node.
Columns carrier(const ClothNode& node, std::span<const Mat4> palette) noexcept {
  Columns sum{};
  for (std::size_t k = 0; k < node.joint.size(); ++k) {
    if (node.weight[k] == 0) continue;
    const float weight = static_cast<float>(node.weight[k]) * (1.0F / 255);
    const Columns it = columns_of(palette[node.joint[k]]);
    sum = {sum.x + weight * it.x, sum.y + weight * it.y, sum.z + weight * it.z,
           sum.w + weight * it.w};
  }
  return sum;
}

/// What is worn over limbs lies on more than the limbs that it is kept out of: it hardly sinks in.
Vec3Lanes not_inward(const ClothBatch& it, const Vec3Lanes& lag) noexcept {
  const Lanes in = -it.most_inward - dot(lag, it.outward);
  return lag + ((in > 0) & it.is_kept_out ? in : Lanes{}) * it.outward;
}

Vec3Lanes at_most(const Vec3Lanes& v, float length) noexcept {
  const Lanes square = dot(v, v);
  const LaneMask longer = square > length * length;
  if (!any(longer)) return v;
  return (longer ? length / root_of(longer ? square : in_all_lanes(1.0F)) : in_all_lanes(1.0F)) * v;
}

/// As long as another, or that one where it has no direction.
Vec3Lanes as_long_as(const Vec3Lanes& length, const Vec3Lanes& v) noexcept {
  const Lanes square = dot(v, v);
  const LaneMask is_sound =
      (square > least_bone * least_bone) & (square < longest_bone * longest_bone);
  const Lanes share = root_of(dot(length, length) / (is_sound ? square : in_all_lanes(1.0F)));
  return choose(is_sound, share * v, length);
}

class HangingCloth {
 public:
  HangingCloth(const ClothView& cloth, std::span<Mat4> palette, ClothMotion& motion) noexcept
      : cloth_{cloth},
        palette_{palette},
        first_{palette.size() - cloth.node.size()},
        motion_{motion} {
    if (motion_.nodes != cloth_.node.size()) motion_.is_placed = false;
    if (!motion_.is_placed) make_batches();
  }

  /// Where joints and limbs are now; the nodes' matrices are how they are carried.
  void carry() noexcept {
    for (ClothBatch& it : batches()) {
      std::array<Lanes, lane_count> length{};
      for (std::size_t lane = 0; lane < it.count; ++lane) {
        const std::uint8_t n = it.node[lane];
        const ClothNode& node = cloth_.node[n];
        const Columns matrix = carrier(node, palette_);
        write(matrix, palette_[first_ + n]);
        motion_.now[n].carried = matrix.at(node.place);
        motion_.now[n].outward = matrix.along(node.outward);
        motion_.carried[n] = first_three(motion_.now[n].carried);
        length[lane] = matrix.along(node.place - node.root);
      }
      it.length = beside_each_other(length[0], length[1], length[2], length[3]).xyz;
      it.carried = looked_up(it.node, &ClothNodeNow::carried);
      it.outward = looked_up(it.node, &ClothNodeNow::outward);
      it.outward =
          (1 / root_of(larger(dot(it.outward, it.outward), in_all_lanes(1e-12F)))) * it.outward;
      put(it, &ClothNodeNow::outward, it.outward);
      it.above_it = it.carried - looked_up(it.above, &ClothNodeNow::carried);
    }
    for (std::size_t c = 0; c < cloth_.collider.size(); ++c) {
      const ClothCollider& limb = cloth_.collider[c];
      const Columns joint = columns_of(palette_[limb.joint]);
      motion_.end[2 * c] = first_three(joint.at(limb.from));
      motion_.end[2 * c + 1] = first_three(joint.at(limb.to));
    }
  }

  bool is_placed_anew(double seconds) const noexcept {
    if (!motion_.is_placed || seconds > longest_frame) return true;
    const auto most = static_cast<float>(most_jump + most_speed * seconds);
    const ClothBatch& first = motion_.batch[0];
    const Vec3 moved = first.carried[0] - first.carried_before[0];
    return !(glm::dot(moved, moved) < most * most);
  }

  void rest() noexcept {
    keep();
    place_limbs(1);
    for (ClothBatch& it : batches()) {
      it.lag = it.velocity = {};
      if (it.kind == ClothKind::Bone) hang_bones(it);
      it.lag_before = it.lag;
      put(it, &ClothNodeNow::lag, it.lag);
    }
    motion_.ahead = 0;
    motion_.is_placed = motion_.is_at_rest = true;
  }

  void swing(double seconds) noexcept {
    double at = -motion_.ahead;  // since the last call
    motion_.ahead += seconds;
    const auto frame = static_cast<float>(seconds);
    while (motion_.ahead >= cloth_step) {
      motion_.ahead -= cloth_step;
      at += cloth_step;
      take_step(frame, static_cast<float>(at / seconds));
    }
    keep();
  }

  /// Places the nodes, between the last two steps as the frame is, and turns them as they hang.
  void draw() noexcept {
    const auto share = static_cast<float>(motion_.ahead / cloth_step);
    place_limbs(1);
    for (ClothBatch& it : batches()) {
      const Vec3Lanes place = it.carried + mix(it.lag_before, it.lag, share);
      if (it.kind == ClothKind::Bone) {
        const Bones bones = bones_of(it, 1);
        const Vec3Lanes right = bones.root + as_long_as(bones.carried, place - bones.root);
        put_bones(it, out_of_limbs(it, bones, right), 1);
      } else {
        put(it, &ClothNodeNow::place, pushed_out(it, place));
      }
    }
    push_between();
    for (ClothBatch& it : batches())
      if (std::ranges::any_of(it.node, [&](std::uint8_t n) { return has_moved_[n]; }))
        put(it, &ClothNodeNow::place, pushed_out(it, places(it.node)));
    for (ClothBatch& it : batches())
      if (it.kind == ClothKind::Bone)
        turn_bones(it);
      else
        turn(it);
    for (std::size_t n = 0; n < motion_.nodes; ++n)
      motion_.place[n] = first_three(motion_.now[n].place);
  }

 private:
  using Nodes = std::array<std::uint8_t, lane_count>;

  std::span<ClothBatch> batches() const noexcept {
    return std::span(motion_.batch).first(motion_.batches);
  }

  /// Nodes from the top down, four and four.
  void make_batches() noexcept {
    std::array<std::uint8_t, 256> depth{};
    std::uint8_t deepest = 0;
    for (std::size_t n = 0; n < cloth_.node.size(); ++n) {
      const std::uint8_t above = cloth_.node[n].above;
      if (above != ClothNode::none) depth[n] = static_cast<std::uint8_t>(depth[above] + 1);
      deepest = std::max(deepest, depth[n]);
    }
    motion_.nodes = cloth_.node.size();
    motion_.batches = 0;
    for (std::size_t level = 0; level <= deepest; ++level) {
      ClothBatch* it = nullptr;
      for (std::size_t n = 0; n < cloth_.node.size(); ++n) {
        if (depth[n] != level) continue;
        if (it == nullptr || it->count == lane_count || it->kind != cloth_.node[n].kind) {
          it = &motion_.batch[motion_.batches++];
          *it = {.kind = cloth_.node[n].kind};
        }
        it->node[it->count++] = static_cast<std::uint8_t>(n);
      }
    }
    for (ClothBatch& it : batches()) prepare(it);
  }

  void prepare(ClothBatch& it) noexcept {
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      if (lane >= it.count) it.node[lane] = it.node[0];
      const ClothNode& node = cloth_.node[it.node[lane]];
      const bool hangs = node.above != ClothNode::none;
      const bool has_neighbours = node.left != ClothNode::none && node.right != ClothNode::none;
      // Those who have none are their own.
      it.above[lane] = hangs ? node.above : it.node[lane];
      const std::size_t next = it.node[lane] + std::size_t{1};
      const bool bears = next < cloth_.node.size() && cloth_.node[next].above == it.node[lane];
      it.below[lane] = bears ? static_cast<std::uint8_t>(next) : it.node[lane];
      it.beside[lane] = node.left != ClothNode::none ? node.left : it.node[lane];
      it.left[lane] = has_neighbours ? node.left : it.node[lane];
      it.right[lane] = has_neighbours ? node.right : it.node[lane];
      it.hangs[lane] = hangs ? -1 : 0;
      it.is_kept_out[lane] = node.keeps_out != 0 ? -1 : 0;
      it.keeps_out |= node.keeps_out;
      it.radius[lane] = node.radius;
      it.stiffness[lane] = node.stiffness;
      it.damping[lane] = node.damping;
      it.drag[lane] = node.drag;
      it.tension[lane] = has_neighbours ? node.tension : 0;
      it.most_inward[lane] = hangs ? most_inward : 0;
    }
    const auto gravity = [&](std::size_t lane) {
      return lanes_of(Vec4(cloth_.node[it.node[lane]].gravity, 0));
    };
    it.gravity = beside_each_other(gravity(0), gravity(1), gravity(2), gravity(3)).xyz;
  }

  Vec4Lanes looked_up_whole(const Nodes& nodes, Lanes ClothNodeNow::* what) const noexcept {
    const std::vector<ClothNodeNow>& now = motion_.now;
    return beside_each_other(now[nodes[0]].*what, now[nodes[1]].*what, now[nodes[2]].*what,
                             now[nodes[3]].*what);
  }
  Vec3Lanes looked_up(const Nodes& nodes, Lanes ClothNodeNow::* what) const noexcept {
    return looked_up_whole(nodes, what).xyz;
  }
  Vec3Lanes places(const Nodes& nodes) const noexcept {
    return looked_up(nodes, &ClothNodeNow::place);
  }
  void put(const ClothBatch& it, Lanes ClothNodeNow::* what, const Vec3Lanes& v,
           Lanes w = Lanes{}) noexcept {
    const std::array<Lanes, lane_count> each = one_by_one(v, w);
    for (std::size_t lane = 0; lane < it.count; ++lane)
      motion_.now[it.node[lane]].*what = each[lane];
  }

  void keep() noexcept {
    for (ClothBatch& it : batches()) {
      it.carried_before = it.carried;
      it.above_it_before = it.above_it;
      it.length_before = it.length;
    }
    std::copy_n(motion_.end.begin(), 2 * cloth_.collider.size(), motion_.end_before.begin());
  }

  void place_limbs(float share) noexcept {
    for (std::size_t c = 0; c < cloth_.collider.size(); ++c) {
      const ClothCollider& limb = cloth_.collider[c];
      const Vec3 from = glm::mix(motion_.end_before[2 * c], motion_.end[2 * c], share);
      const Vec3 to = glm::mix(motion_.end_before[2 * c + 1], motion_.end[2 * c + 1], share);
      const float square = glm::dot(to - from, to - from);
      limb_[c] = {in_all_lanes(from), in_all_lanes(to - from), limb.from_radius,
                  limb.to_radius - limb.from_radius, square > 1e-8F ? 1 / square : 0.0F};
    }
  }

  LaneMask keeps_out_of(const ClothBatch& it, std::size_t collider) const noexcept {
    const auto is_kept_out = [&](std::size_t lane) {
      return -static_cast<std::int32_t>(cloth_.node[it.node[lane]].keeps_out >> collider & 1U);
    };
    return LaneMask{is_kept_out(0), is_kept_out(1), is_kept_out(2), is_kept_out(3)};
  }

  /// How far along `outward` places have to go to be out of all limbs that nodes keep out of.
  Lanes way_out(const ClothBatch& it, const Vec3Lanes& place, Lanes around,
                const Vec3Lanes& outward) const noexcept {
    Lanes furthest{};
    for (std::uint32_t bits = it.keeps_out; bits != 0; bits &= bits - 1) {
      const auto c = static_cast<std::size_t>(std::countr_zero(bits));
      const Lanes way = motion::way_out(limb_[c], place, around, outward);
      if (any(way > furthest)) furthest = larger(furthest, keeps_out_of(it, c) ? way : Lanes{});
    }
    return smaller(furthest, in_all_lanes(most_lag));
  }
  Vec3Lanes pushed_out(const ClothBatch& it, const Vec3Lanes& place) const noexcept {
    return place + way_out(it, place, it.radius, it.outward) * it.outward;
  }

  /// Between nodes and others: the way of the cloth's middle there out of limbs, and in which
  /// direction.
  struct Push {
    Lanes way;
    Vec3Lanes outward;
  };
  Push push_of(const ClothBatch& it, const Nodes& others) const noexcept {
    const Vec3Lanes outward_of_others = looked_up(others, &ClothNodeNow::outward);
    const Vec3Lanes sum = it.outward + outward_of_others;
    const Lanes square = dot(sum, sum);
    const LaneMask agree = square >= 0.25F;
    const Vec3Lanes outward = (1 / root_of(agree ? square : in_all_lanes(1.0F))) * sum;
    const Vec3Lanes place = places(it.node), off = places(others) - place;
    const Vec3Lanes bent = outward_of_others - it.outward;
    // What lies between them on a circle bulges by an eighth of their distance for each radian.
    const Lanes bulge = 0.125F * root_of(dot(off, off) * dot(bent, bent));
    const auto radius = [&](std::size_t lane) { return cloth_.node[others[lane]].radius; };
    const Lanes around = 0.5F * (it.radius + Lanes{radius(0), radius(1), radius(2), radius(3)});
    const Lanes way = way_out(it, place + 0.5F * off + bulge * outward, around, outward);
    return {agree ? way : Lanes{}, outward};
  }

  /// Where cloth between nodes and others is in a limb, both give way, one after another.
  void push_apart(const ClothBatch& it, const Nodes& others) noexcept {
    Push push = push_of(it, others);
    for (std::size_t lane = 0; lane < it.count; ++lane) {
      if (!(push.way[lane] > 0) || others[lane] == it.node[lane]) continue;
      const Lanes out = push.way[lane] * one_by_one(push.outward, Lanes{})[lane];
      for (const std::uint8_t n : {it.node[lane], others[lane]}) {
        motion_.now[n].place += out;
        has_moved_[n] = true;
      }
      if (any(push.way > 0)) push = push_of(it, others);
    }
  }

  void push_between() noexcept {
    for (const ClothBatch& it : batches()) {
      if (it.keeps_out == 0 || it.kind == ClothKind::Bone) continue;
      push_apart(it, it.beside);
      push_apart(it, it.above);
    }
  }

  /// Nodes hang from those above them at the length at which the joints carry both.
  Vec3Lanes at_length(const ClothBatch& it, const Vec3Lanes& lag, float share) const noexcept {
    const Vec3Lanes length = mix(it.above_it_before, it.above_it, share);
    const Vec3Lanes lag_above = looked_up(it.above, &ClothNodeNow::lag);
    const Vec3Lanes off = length + lag - lag_above;
    const Lanes square = dot(off, off);
    const LaneMask is_long = it.hangs & (square >= 1e-9F);
    const Lanes whole = root_of(dot(length, length) / (is_long ? square : in_all_lanes(1.0F)));
    return choose(is_long, lag_above + whole * off - length, lag);
  }

  void take_step(float frame, float now) noexcept {
    place_limbs(now);
    for (ClothBatch& it : batches()) {
      it.lag_before = it.lag;
      put(it, &ClothNodeNow::lag_before, it.lag);
    }
    for (ClothBatch& it : batches()) {
      const Vec3Lanes here = mix(it.carried_before, it.carried, now);
      const Vec3Lanes speed = (1 / frame) * (it.carried - it.carried_before);
      if (motion_.is_at_rest) it.velocity = speed;
      if (it.kind == ClothKind::Bone)
        step_bones(it, here, speed, now);
      else
        step_cloth(it, here, speed, now);
    }
    motion_.is_at_rest = false;
  }

  void step_cloth(ClothBatch& it, const Vec3Lanes& here, const Vec3Lanes& speed,
                  float now) noexcept {
    const Vec3Lanes& lag = it.lag_before;
    const Vec3Lanes beside = 0.5F * (looked_up(it.left, &ClothNodeNow::lag_before) +
                                     looked_up(it.right, &ClothNodeNow::lag_before));
    const Vec3Lanes pull = it.tension * (beside - lag) - it.stiffness * lag -
                           it.damping * (it.velocity - speed) - it.drag * it.velocity;
    Vec3Lanes next = lag + step_seconds * (it.velocity + step_seconds * pull - speed);
    if (any(it.hangs)) next = at_length(it, next, now);
    next = not_inward(it, next);
    it.lag = at_most(pushed_out(it, here + next) - here, most_lag);
    put(it, &ClothNodeNow::lag, it.lag);
    // A limb takes cloth along; it does not throw it.
    const Vec3Lanes taken = mix(next, it.lag, taken_along) - lag;
    it.velocity = speed + at_most((1 / step_seconds) * taken, most_swing_speed);
  }

  /// Bones at a moment: where they begin, and how they would point if they did not swing
  /// themselves, but only as those above them do, from which they hang.
  struct Bones {
    Vec3Lanes root, carried;
  };
  /// Of bones of which those above hang already.
  Bones bones_of(ClothBatch& it, float share) noexcept {
    const Vec3Lanes end = mix(it.carried_before, it.carried, share);
    const Vec3Lanes length = mix(it.length_before, it.length, share);
    Bones bones{end - length, length};
    if (any(it.hangs)) {
      const ShortestTurn turned = turn_of(it.above);
      const Vec3Lanes begins = mix(it.above_it_before, it.above_it, share) - length;
      bones.root = choose(it.hangs, places(it.above) + turned * begins, bones.root);
      bones.carried = choose(it.hangs, turned * length, length);
    }
    it.begin = bones.root;
    return bones;
  }
  ShortestTurn turn_of(const Nodes& nodes) const noexcept {
    const Vec4Lanes turn = looked_up_whole(nodes, &ClothNodeNow::turn);
    return {turn.xyz, turn.w};
  }

  /// Bones that are as long as they are, out of limbs.
  Vec3Lanes out_of_limbs(const ClothBatch& it, const Bones& bones, Vec3Lanes place) const noexcept {
    for (std::uint32_t bits = it.keeps_out; bits != 0; bits &= bits - 1) {
      const auto c = static_cast<std::size_t>(std::countr_zero(bits));
      Vec3Lanes out = place;
      LaneMask moved = is_moved_out_of(limb_[c], out, it.radius);
      if (!any(moved)) continue;
      moved &= keeps_out_of(it, c);
      place = choose(moved, bones.root + as_long_as(bones.carried, out - bones.root), place);
    }
    return place;
  }

  /// Bones hang there, and what hangs from them goes with them.
  void put_bones(ClothBatch& it, const Vec3Lanes& place, float share) noexcept {
    put(it, &ClothNodeNow::place, place);
    const ShortestTurn turned(mix(it.length_before, it.length, share), place - it.begin);
    put(it, &ClothNodeNow::turn, turned.axis(), turned.cosine());
  }

  /// Where bones hang that have come to rest: spring and weight hold each other.
  void hang_bones(ClothBatch& it) noexcept {
    const Bones bones = bones_of(it, 1);
    const Vec3Lanes pull = it.stiffness * bones.carried + it.gravity;
    const Vec3Lanes place = out_of_limbs(it, bones, bones.root + as_long_as(bones.carried, pull));
    put_bones(it, place, 1);
    it.lag = place - it.carried;
  }

  void step_bones(ClothBatch& it, const Vec3Lanes& here, const Vec3Lanes& speed,
                  float now) noexcept {
    const Bones bones = bones_of(it, now);
    const Vec3Lanes along = here + it.lag_before;  // had it not swung
    const Vec3Lanes pull = it.stiffness * (bones.root + bones.carried - along) -
                           it.damping * (it.velocity - speed) - it.drag * it.velocity + it.gravity;
    const Vec3Lanes free =
        along + step_seconds * (it.velocity - speed + step_seconds * pull) - bones.root;
    const Vec3Lanes next = bones.root + as_long_as(bones.carried, free);
    const Vec3Lanes place = out_of_limbs(it, bones, next);
    put_bones(it, place, now);
    it.lag = place - here;
    const Vec3Lanes taken = mix(next, place, taken_along) - along;
    const Vec3Lanes swings = at_most((1 / step_seconds) * taken, most_swing_speed);
    it.velocity = speed + choose(dot(swings, swings) < 1e6F, swings, Vec3Lanes{});
  }

  /// Turns nodes' matrices as they have turned; then what was at a point of each node is at
  /// `place`.
  void turn_about(const ClothBatch& it, const ShortestTurn& turn, const Vec3Lanes& place,
                  Vec3 ClothNode::* point) noexcept {
    const std::array<Vec3Lanes, 3> axes = turn.axes();
    const auto x = one_by_one(axes[0], Lanes{}), y = one_by_one(axes[1], Lanes{}),
               z = one_by_one(axes[2], Lanes{});
    const auto to = one_by_one(place, in_all_lanes(1.0F));
    for (std::size_t lane = 0; lane < it.count; ++lane) {
      Mat4& m = palette_[first_ + it.node[lane]];
      const auto turned = [&](const Vec4& v) {
        return v.x * x[lane] + v.y * y[lane] + v.z * z[lane];
      };
      Columns c{turned(m[0]), turned(m[1]), turned(m[2]), to[lane]};
      c.w -= c.along(cloth_.node[it.node[lane]].*point);
      write(c, m);
    }
  }

  void turn_bones(const ClothBatch& it) noexcept {
    turn_about(it, turn_of(it.node), it.begin, &ClothNode::root);
  }

  /// Nodes turn as the cloth between those above and below them does. Above the highest it is
  /// firm.
  void turn(const ClothBatch& it) noexcept {
    const Vec3Lanes carried_here = it.carried, place_here = places(it.node);
    const auto up = [&](std::size_t lane) { return lanes_of(palette_[first_ + it.node[lane]][1]); };
    const Vec3Lanes firm = firm_length * beside_each_other(up(0), up(1), up(2), up(3)).xyz;
    const Vec3Lanes carried =
        choose(it.hangs, looked_up(it.above, &ClothNodeNow::carried), carried_here + firm) -
        looked_up(it.below, &ClothNodeNow::carried);
    const Vec3Lanes place =
        choose(it.hangs, places(it.above), carried_here + firm) - places(it.below);
    turn_about(it, ShortestTurn(carried, place), place_here, &ClothNode::place);
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
  motion.carried.resize(nodes);
  motion.place.resize(nodes);
  motion.batch.resize(nodes);
  motion.now.resize(nodes);
  motion.end.resize(2 * most_cloth_colliders);
  motion.end_before.resize(2 * most_cloth_colliders);
  return motion;
}

void hang(const ClothView& cloth, std::span<Mat4> palette, ClothMotion& motion) noexcept {
  if (cloth.node.empty()) return;
  motion.is_placed = false;
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
