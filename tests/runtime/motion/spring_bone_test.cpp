#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include "runtime/motion/cloth.h"
#include "tests/runtime/motion/allocation_count.h"

namespace docent::motion::spring_bone_test {
namespace {

constexpr float bone_length = 0.12F;

/// A plait of bones down the back of a head, which is one joint; the shoulders are another, and a
/// capsule lies along them.
struct Plait {
  std::vector<ClothNode> node;
  std::vector<ClothCollider> collider{{.joint = 1,
                                       .from = {-0.2F, 1.40F, 0},
                                       .to = {0.2F, 1.40F, 0},
                                       .from_radius = 0.07F,
                                       .to_radius = 0.07F}};
  std::vector<Mat4> palette;
  ClothMotion motion;

  explicit Plait(std::size_t bones = 4, float stiffness = 80, Vec3 gravity = {0, -5, 0})
      : palette(2 + bones, Mat4(1)), motion(make_cloth_motion(bones)) {
    for (std::size_t n = 0; n < bones; ++n) {
      const Vec3 root{0, 1.65F - bone_length * static_cast<float>(n), -0.1F};
      node.push_back({.kind = ClothKind::Bone,
                      .joint = {0, 0, 0, 0},
                      .weight = {255, 0, 0, 0},
                      .place = root - Vec3{0, bone_length, 0},
                      .above = n == 0 ? ClothNode::none : static_cast<std::uint8_t>(n - 1),
                      .radius = 0.02F,
                      .keeps_out = 1,
                      .stiffness = stiffness,
                      .damping = 15,
                      .drag = 5,
                      .root = root,
                      .gravity = gravity});
    }
  }
  ClothView view() const { return {node, collider}; }

  /// Someone who walks, sways and looks about.
  void pose(double time) {
    const auto t = static_cast<float>(time);
    palette[1] =
        glm::translate(Mat4(1), {0.05F * std::sin(7 * t), 0.02F * std::sin(11 * t), 1.2F * t});
    palette[0] = palette[1] * glm::translate(Mat4(1), {0, 1.5F, 0}) *
                 glm::rotate(Mat4(1), std::sin(3 * t), {0, 1, 0}) *
                 glm::rotate(Mat4(1), 0.4F * std::sin(5 * t), {1, 0, 0}) *
                 glm::translate(Mat4(1), {0, -1.5F, 0});
  }
  void swing_for(double seconds, double frame) {
    const auto frames = static_cast<int>(std::lround(seconds / frame));
    for (int f = 1; f <= frames; ++f) {
      pose(f * frame);
      swing(view(), frame, palette, motion);
    }
  }
  void stand_for(double seconds) {
    for (int f = 0; f < std::lround(60 * seconds); ++f) swing(view(), 1.0 / 60, palette, motion);
  }
  /// A bone as its joint carries it.
  Vec3 carried(std::size_t n) const {
    return glm::mat3(palette[node[n].joint[0]]) * (node[n].place - node[n].root);
  }
  Vec3 off(std::size_t n) const { return motion.place[n] - motion.carried[n]; }
  /// How deep the end of a bone is in the shoulders: metres.
  float depth(std::size_t n) const {
    const Vec3 from = Vec3(palette[1] * Vec4(collider[0].from, 1)),
               to = Vec3(palette[1] * Vec4(collider[0].to, 1));
    const Vec3 way = motion.place[n] - from, along = to - from;
    const float share = std::clamp(glm::dot(way, along) / glm::dot(along, along), 0.0F, 1.0F);
    return 0.07F + node[n].radius - glm::length(way - share * along);
  }
};

/// Whatever springs, frames and jerks: bones are as long as they are, turned and not stretched, and
/// hang where the one above ends.
RC_GTEST_PROP(SpringBones, KeepTheirLengthsAndHangTogether, ()) {
  const auto number = [](int low, int high) {
    return static_cast<float>(*rc::gen::inRange(low, high + 1));
  };
  Plait plait(static_cast<std::size_t>(*rc::gen::inRange(1, 9)));
  for (ClothNode& n : plait.node) {
    n.stiffness = number(0, 2000);
    n.damping = number(0, 100);
    n.drag = number(0, 100);
    n.gravity = {number(-280, 280), number(-280, 280), number(-280, 280)};
    n.radius = 0.01F * number(0, 50);
    n.keeps_out = static_cast<std::uint32_t>(*rc::gen::inRange(0, 2));
    if (n.above != ClothNode::none && *rc::gen::inRange(0, 4) == 0)
      n.above = static_cast<std::uint8_t>(*rc::gen::inRange(0, static_cast<int>(n.above) + 1));
  }
  plait.collider[0].from_radius = plait.collider[0].to_radius = 0.01F * number(0, 300);
  double time = 0;
  for (int f = 0; f < 60; ++f) {
    const double frame = 0.001 * *rc::gen::inRange(0, 200);
    time += frame;
    plait.pose(time);
    swing(plait.view(), frame, plait.palette, plait.motion);
    for (std::size_t n = 0; n < plait.node.size(); ++n) {
      const Mat4& m = plait.palette[2 + n];
      const Vec3 root = Vec3(m * Vec4(plait.node[n].root, 1));
      const Vec3 end = Vec3(m * Vec4(plait.node[n].place, 1));
      RC_ASSERT(std::abs(glm::distance(root, plait.motion.place[n]) - bone_length) < 1e-3F);
      // A bone that points straight back keeps its turn instead of taking any.
      const Vec3 carried = plait.carried(n);
      const Vec3 hangs = plait.motion.place[n] - root;
      if (glm::dot(carried, hangs) > -0.99F * bone_length * bone_length)
        RC_ASSERT(glm::distance(end, plait.motion.place[n]) < 1e-3F);
      RC_ASSERT(std::abs(glm::determinant(glm::mat3(m)) - 1) < 1e-3F);
      if (n > 0 && plait.node[n].above == n - 1)
        RC_ASSERT(glm::distance(root, plait.motion.place[n - 1]) < 1e-3F);
    }
  }
}

TEST(SpringBones, SwingAndComeToRestWhereSpringAndWeightHoldEachOther) {
  Plait plait(1, 50, {0, 0, 6});
  plait.collider.clear();
  plait.node[0].keeps_out = 0;
  plait.swing_for(1, 1.0 / 60);
  EXPECT_GT(glm::length(plait.off(0)), 0.01F);

  plait.palette[0] = plait.palette[1];
  plait.stand_for(5);

  const Vec3 begins(plait.palette[2] * Vec4(plait.node[0].root, 1));
  const Vec3 hangs = glm::normalize(plait.motion.place[0] - begins);
  EXPECT_LT(glm::distance(hangs, Vec3(0, -1, 1) / std::sqrt(2.0F)), 0.01F);  // 50 * 0.12 = 6
}

TEST(SpringBones, AreTheSameAtAnyFrameRate) {
  Plait smooth;
  smooth.swing_for(3, 1.0 / 960);
  for (const double rate : {24.0, 30.0, 47.0, 59.94, 60.0, 75.0, 120.0, 144.0, 240.0}) {
    Plait plait;
    plait.swing_for(3, 3 / std::round(3 * rate));
    for (std::size_t n = 0; n < plait.node.size(); ++n)
      EXPECT_LT(glm::distance(plait.motion.place[n], smooth.motion.place[n]), 0.008F)
          << rate << " frames a second, bone " << n;
  }
}

TEST(SpringBones, AreNeverInALimb) {
  for (const double frame : {1.0 / 30, 1.0 / 60, 1.0 / 113}) {
    Plait plait;
    for (int f = 1; f * frame < 5; ++f) {
      plait.pose(f * frame);
      swing(plait.view(), frame, plait.palette, plait.motion);
      for (std::size_t n = 1; n < plait.node.size(); ++n)
        ASSERT_LT(plait.depth(n), 0.005F) << f << " " << n;
    }
  }
}

TEST(SpringBones, HangStillAtOnceWhereTheirBodyIsPlacedAnew) {
  Plait plait(4, 30, {0, -3, 4});
  plait.swing_for(1, 1.0 / 60);

  plait.palette[0] = plait.palette[1] = glm::translate(Mat4(1), {20, 0, 5});
  swing(plait.view(), 1.0 / 60, plait.palette, plait.motion);
  const std::vector<Vec3> placed = plait.motion.place;
  plait.stand_for(1);

  for (std::size_t n = 0; n < placed.size(); ++n)
    EXPECT_LT(glm::distance(plait.motion.place[n], placed[n]), 0.002F) << n;
}

/// The steps that VRM 1.0 describes ("Update Verlet integration"), for one bone of a body that
/// stands still.
struct VrmSpring {
  Vec3 root, rest, tail, before;
  void step(float stiffness, Vec3 gravity, float drag) {
    constexpr float dt = 1.0F / 60;
    const Vec3 next =
        tail + (1 - drag) * (tail - before) + dt * stiffness * glm::normalize(rest) + dt * gravity;
    before = tail;
    tail = root + glm::length(rest) * glm::normalize(next - root);
  }
};

TEST(SpringBones, SwingAsVrmDescribesIt) {
  constexpr float stiffness = 0.2F, drag = 0.1F;
  Plait plait(1, 60 * stiffness / bone_length, {0, 0, 0});
  ClothNode& node = plait.node[0];
  node.keeps_out = 0;
  node.damping = -60 * std::log(1 - drag);
  node.drag = 0;
  hang(plait.view(), plait.palette, plait.motion);
  // Held aside and let go.
  const Vec3 aside = node.root + bone_length * Vec3(std::sin(0.5F), -std::cos(0.5F), 0);
  ClothBatch& bone = plait.motion.batch[0];
  bone.lag = bone.lag_before = in_all_lanes(aside - node.place);
  VrmSpring vrm{node.root, node.place - node.root, aside, aside};
  float most = 0, off = 0;
  for (int f = 0; f < 90; ++f) {
    swing(plait.view(), 1.0 / 60, plait.palette, plait.motion);
    vrm.step(stiffness, {0, 0, 0}, drag);
    most = std::max(most, std::abs(vrm.tail.x));
    off = std::max(off, glm::distance(vrm.tail, plait.motion.place[0]));
  }
  EXPECT_GT(most, 0.05F);
  EXPECT_LT(off, 0.2F * most);  // VRM's own steps of 60 a second differ that much from ones of 240
}

TEST(SpringBones, StayFiniteWhateverHappens) {
  Plait plait;
  for (int f = 0; f < 400; ++f) {
    plait.pose(f % 3 == 0 ? 0.4 * f : 0.01 * f);
    if (f == 100) plait.palette[0] = Mat4(0);
    if (f == 200) plait.palette[1][3].x = NAN;
    if (f == 300) plait.palette[0][1].y = NAN;
    swing(plait.view(), f % 7 == 0 ? 1.9 : 0.0137, plait.palette, plait.motion);
  }
  plait.pose(1);
  swing(plait.view(), 1.0 / 60, plait.palette, plait.motion);
  plait.stand_for(0.5);
  for (std::size_t n = 0; n < plait.node.size(); ++n)
    EXPECT_LT(glm::length(plait.off(n)), 0.3F) << n;
}

TEST(SpringBones, DoNotAllocate) {
  Plait plait;
  const std::size_t before = test::allocation_count();

  plait.swing_for(1, 1.0 / 60);
  hang(plait.view(), plait.palette, plait.motion);

  EXPECT_EQ(test::allocation_count(), before);
}

}  // namespace
}  // namespace docent::motion::spring_bone_test
