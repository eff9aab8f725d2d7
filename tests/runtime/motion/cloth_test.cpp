#include "runtime/motion/cloth.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "tests/runtime/motion/allocation_count.h"

namespace docent::motion::cloth_test {
namespace {

/// A strip of cloth of three nodes before a thigh, which is one joint; the hips are another.
struct Apron {
  std::vector<ClothNode> node;
  std::vector<ClothCollider> collider{{.joint = 1,
                                       .from = {0, 0.9F, 0},
                                       .to = {0, 0.5F, 0},
                                       .from_radius = 0.08F,
                                       .to_radius = 0.07F}};
  std::vector<Mat4> palette;
  ClothMotion motion = make_cloth_motion(3);

  Apron() : palette(5, Mat4(1)) {
    for (std::uint8_t n = 0; n < 3; ++n)
      node.push_back({.joint = {0, 0, 0, 0},
                      .weight = {255, 0, 0, 0},
                      .place = {0, 0.8F - 0.15F * static_cast<float>(n), 0.1F},
                      .outward = {0, 0, 1},
                      .above = n == 0 ? ClothNode::none : static_cast<std::uint8_t>(n - 1),
                      .keeps_out = 1,
                      .stiffness = 100,
                      .damping = 5,
                      .drag = 1});
  }
  ClothView view() const { return {node, collider}; }

  /// Someone who sways, walks and lifts a thigh, at that time.
  void pose(double time) {
    const auto t = static_cast<float>(time);
    const Vec3 place{0.05F * std::sin(7 * t), 0.02F * std::sin(11 * t), 1.2F * t};
    palette[0] = glm::translate(Mat4(1), place);
    const Vec3 hip{0, 0.9F, 0};
    palette[1] = palette[0] * glm::translate(Mat4(1), hip) *
                 glm::rotate(Mat4(1), -0.6F * std::max(0.0F, std::sin(6 * t)), {1, 0, 0}) *
                 glm::translate(Mat4(1), -hip);
  }
  void swing_for(double seconds, double frame) {
    const auto frames = static_cast<int>(std::lround(seconds / frame));
    for (int f = 1; f <= frames; ++f) {
      pose(f * frame);
      swing(view(), frame, palette, motion);
    }
  }
  Vec3 hangs_off(std::size_t n) const { return motion.place[n] - motion.carried[n]; }
  /// How deep the place of a node is in the thigh: metres.
  float depth(std::size_t n) const {
    const Vec3 from = Vec3(palette[1] * Vec4(collider[0].from, 1)),
               to = Vec3(palette[1] * Vec4(collider[0].to, 1));
    const Vec3 off = motion.place[n] - from, along = to - from;
    const float share = std::clamp(glm::dot(off, along) / glm::dot(along, along), 0.0F, 1.0F);
    return glm::mix(0.08F, 0.07F, share) - glm::length(off - share * along);
  }
};

TEST(Cloth, SwingsAndComesToRest) {
  Apron apron;
  apron.swing_for(1, 1.0 / 60);
  EXPECT_GT(glm::length(apron.hangs_off(2)), 0.005F);

  const auto standing = apron.palette;
  for (int frame = 0; frame < 300; ++frame) {
    std::copy_n(standing.begin(), 2, apron.palette.begin());
    apron.palette[1] = apron.palette[0];
    swing(apron.view(), 1.0 / 60, apron.palette, apron.motion);
  }

  EXPECT_LT(glm::length(apron.hangs_off(2)), 0.001F);
  EXPECT_NEAR(apron.palette[4][1].y, 1, 1e-3);
}

TEST(Cloth, IsTheSameAtAnyFrameRate) {
  Apron smooth;
  smooth.swing_for(3, 1.0 / 960);
  for (const double rate : {24.0, 30.0, 47.0, 59.94, 60.0, 75.0, 120.0, 144.0, 240.0}) {
    Apron apron;
    const double frame = 3 / std::round(3 * rate);
    apron.swing_for(3, frame);
    for (std::size_t n = 0; n < 3; ++n)
      EXPECT_LT(glm::length(apron.hangs_off(n) - smooth.hangs_off(n)), 0.006F)
          << rate << " frames a second, node " << n;
  }
}

TEST(Cloth, IsNeverInALimb) {
  for (const double frame : {1.0 / 30, 1.0 / 60, 1.0 / 113}) {
    Apron apron;
    for (int f = 1; f * frame < 5; ++f) {
      apron.pose(f * frame);
      swing(apron.view(), frame, apron.palette, apron.motion);
      for (std::size_t n = 0; n < 3; ++n) ASSERT_LT(apron.depth(n), 0.001F) << f << " " << n;
    }
  }
}

TEST(Cloth, HangsStillWhereItsBodyIsPlacedAnew) {
  Apron apron;
  apron.swing_for(1, 1.0 / 60);

  apron.palette[0] = apron.palette[1] = glm::translate(Mat4(1), {20, 0, 5});
  swing(apron.view(), 1.0 / 60, apron.palette, apron.motion);

  for (std::size_t n = 0; n < 3; ++n) EXPECT_LT(glm::length(apron.hangs_off(n)), 1e-5F);
}

TEST(Cloth, StaysFiniteWhateverHappens) {
  Apron apron;
  for (int f = 0; f < 400; ++f) {
    apron.pose(f % 3 == 0 ? 0.4 * f : 0.01 * f);
    if (f == 200) apron.palette[0] = Mat4(0);
    if (f == 300) apron.palette[1][3].x = NAN;
    swing(apron.view(), f % 7 == 0 ? 1.9 : 0.0137, apron.palette, apron.motion);
    hang(apron.view(), apron.palette, apron.motion);
  }
  apron.pose(1);
  swing(apron.view(), 1.0 / 60, apron.palette, apron.motion);
  for (std::size_t n = 0; n < 3; ++n) EXPECT_LT(glm::length(apron.hangs_off(n)), 0.3F);
}

/// Nodes are moved four at a time, from the top down.
TEST(Cloth, SwingsEachStripAsIfItWereAlone) {
  Apron alone, five;
  const std::vector<ClothNode> strip = alone.node;
  for (std::uint8_t more = 1; more < 5; ++more)
    for (ClothNode node : strip) {
      if (node.above != ClothNode::none)
        node.above = static_cast<std::uint8_t>(node.above + 3 * more);
      five.node.push_back(node);
    }
  five.palette.resize(2 + five.node.size(), Mat4(1));
  five.motion = make_cloth_motion(five.node.size());

  alone.swing_for(2, 1.0 / 60);
  five.swing_for(2, 1.0 / 60);

  for (std::size_t n = 0; n < five.node.size(); ++n) {
    EXPECT_EQ(five.hangs_off(n), alone.hangs_off(n % 3)) << n;
    EXPECT_EQ(five.palette[2 + n], alone.palette[2 + n % 3]) << n;
  }
}

TEST(Cloth, DoesNotAllocate) {
  Apron apron;
  const std::size_t before = test::allocation_count();

  apron.swing_for(1, 1.0 / 60);
  hang(apron.view(), apron.palette, apron.motion);

  EXPECT_EQ(test::allocation_count(), before);
}

}  // namespace
}  // namespace docent::motion::cloth_test
