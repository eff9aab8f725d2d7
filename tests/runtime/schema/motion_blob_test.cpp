#include "runtime/schema/motion_blob.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "runtime/model/motion/motion_grid.h"
#include "tests/runtime/schema/bytes.h"

namespace docent::schema::motion_blob_test {
namespace {

using testing::ElementsAreArray;

/// Fails where a part of one is not the same float in the other.
void assert_same(const MotionClip& a, const MotionClip& b) {
  const auto same = [](float x, float y) {
    return std::bit_cast<std::uint32_t>(x) == std::bit_cast<std::uint32_t>(y);
  };
  RC_ASSERT(a.joint_count == b.joint_count);
  RC_ASSERT(std::ranges::equal(a.root, b.root, [&](const Vec3& p, const Vec3& q) {
    return same(p.x, q.x) && same(p.y, q.y) && same(p.z, q.z);
  }));
  RC_ASSERT(std::ranges::equal(a.rotation, b.rotation, [&](const Quat& p, const Quat& q) {
    return same(p.x, q.x) && same(p.y, q.y) && same(p.z, q.z) && same(p.w, q.w);
  }));
  RC_ASSERT(std::ranges::equal(a.plants, b.plants, [](const FootPlants& p, const FootPlants& q) {
    return p.left == q.left && p.right == q.right;
  }));
}

MotionClip after_a_round_trip(const MotionClip& clip) {
  MotionClip read;
  RC_ASSERT(schema::decode(schema::encode(clip), read));
  return read;
}

/// A rotation on the grid, any part of it derived: first a leap to anywhere, then mostly small
/// steps, or none.
class GridTurns {
 public:
  explicit GridTurns(int bits) : bits_(bits) {}

  Quat next() {
    const std::int64_t whole = motion_grid::steps_of(bits_);
    if (*rc::gen::inRange(0, 12) == 0) {
      derived_ = *rc::gen::inRange<std::size_t>(0, 4);
      negative_ = *rc::gen::arbitrary<bool>();
      for (auto& step : steps_) step = *rc::gen::inRange<std::int64_t>(-whole / 2, whole / 2);
    }
    const bool still = *rc::gen::inRange(0, 3) != 0;
    for (auto& step : steps_)
      if (!still)
        step = std::clamp(step + *rc::gen::inRange<std::int64_t>(-9, 10), -whole / 2, whole / 2);
    std::array<float, 4> part{};
    for (std::size_t i = 0; i < 4; ++i) part[i] = motion_grid::part_at(steps_[i], bits_);
    const double size = motion_grid::derived_steps(steps_, derived_, bits_);
    part[derived_] = motion_grid::derived_at(negative_ ? -size : size, bits_);
    return motion_grid::from_parts(part);
  }

 private:
  int bits_;
  motion_grid::RotationSteps steps_{};
  std::size_t derived_ = 3;
  bool negative_ = false;
};

MotionClip some_clip_on_a_grid(int bits) {
  MotionClip clip;
  clip.joint_count = *rc::gen::inRange(0U, 5U);
  const std::size_t frames = *rc::gen::inRange<std::size_t>(0, 50);
  std::vector<GridTurns> joints(clip.joint_count, GridTurns(bits));
  for (std::size_t f = 0; f < frames; ++f) {
    const auto coordinate = [] {
      return motion_grid::root_at(*rc::gen::inRange<std::int64_t>(-100000, 100000));
    };
    const float x = coordinate(), y = coordinate(), z = coordinate();
    clip.root.emplace_back(x, y, z);
    for (GridTurns& joint : joints) clip.rotation.push_back(joint.next());
    const bool left = *rc::gen::arbitrary<bool>(), right = *rc::gen::arbitrary<bool>();
    clip.plants.push_back({.left = left, .right = right});
  }
  return clip;
}

TEST(MotionBlob, GivesBackAnyMotionOnAGridBitForBit) {
  EXPECT_TRUE(rc::check("grids survive", [] {
    const int bits = *rc::gen::inRange(motion_grid::least_bits, motion_grid::most_bits + 1);
    const MotionClip clip = some_clip_on_a_grid(bits);

    const std::vector<std::byte> written = schema::encode(clip);

    RC_ASSERT(std::to_integer<int>(written[0]) >= motion_grid::least_bits);
    RC_ASSERT(std::to_integer<int>(written[0]) <= bits);
    assert_same(after_a_round_trip(clip), clip);
  }));
}

TEST(MotionBlob, GivesBackAnyFloatsBitForBit) {
  EXPECT_TRUE(rc::check("floats survive", [](const std::vector<std::uint32_t>& numbers) {
    MotionClip clip;
    clip.joint_count = 2;
    const auto number = [&](std::size_t i) { return std::bit_cast<float>(numbers[i]); };
    for (std::size_t i = 0; i + 11 <= numbers.size(); i += 11) {
      clip.root.emplace_back(number(i), number(i + 1), number(i + 2));
      clip.rotation.emplace_back(number(i + 3), number(i + 4), number(i + 5), number(i + 6));
      clip.rotation.emplace_back(number(i + 7), number(i + 8), number(i + 9), number(i + 10));
      clip.plants.push_back({.left = numbers[i] % 2 == 0, .right = numbers[i] % 3 == 0});
    }

    assert_same(after_a_round_trip(clip), clip);
  }));
}

TEST(MotionBlob, GivesBackPlacesThatAreNearlyTooLargeOrNoNumbers) {
  for (const float far : {0x1p46F, 0x1p47F, 1e38F, std::numeric_limits<float>::infinity(), NAN,
                          -0.0F, std::numeric_limits<float>::denorm_min()}) {
    MotionClip clip{.name = {},
                    .motion_class = {},
                    .joint_count = 1,
                    .root = {{0, far, 0}, {-far, 0, 0}, {far, far, -far}},
                    .rotation = std::vector<Quat>(3, Quat(1, 0, 0, 0)),
                    .plants = std::vector<FootPlants>(3)};

    assert_same(after_a_round_trip(clip), clip);
  }
}

/// The layout in motion_blob.h, bit by bit: databases are read by other builds than wrote them.
TEST(MotionBlob, LiesInTheBytesAsItsHeaderSays) {
  const auto sine = static_cast<float>(std::sqrt(0.75));
  const MotionClip clip{.name = {},
                        .motion_class = {},
                        .joint_count = 2,
                        .root = {{0, 3 / 16384.0F, 0}, {0, 2 / 16384.0F, 0}},
                        .rotation = {Quat(1, 0, 0, 0), Quat(1, 0, 0, 0),  //
                                     Quat(0.5F, 0, 0, -sine), Quat(1, 0, 0, 0)},
                        .plants = {{.left = true, .right = false}, {.left = true, .right = true}}};

  // Plants: 10 11. Root: 0 3 0 are codes 0 6 0 with k = 5, 000000 000110 000000; their levels are
  // then 224, 230, 224, so k = 4. Of 0 2 0 the 2 was foretold as 6: -4 is code 7, 00000 00111
  // 00000. Joint 0 turns (1). Frame 0 derives w as before (0) and ends early (1) as one frame
  // (0000), three numbers 000000. Frame 1 derives another part (1), z (10), negative (1), to the
  // end (0): x and y 00000, and w, foretold as 128 steps, is 64: -64 is code 127 with k = 5, 1110
  // 11111. Joint 1 keeps still (0), and a 0 fills the byte.
  EXPECT_THAT(schema::encode(clip),
              ElementsAreArray(
                  bytes({8,          2,          0,          0,          0,          2,
                         0,          0,          0,  //
                         0b10110000, 0b00000110, 0b00000000, 0b00000111, 0b00000101, 0b00000000,
                         0b00000000, 0b00000011, 0b01000000, 0b00000111, 0b01111100})));
}

TEST(MotionBlob, NeedsOneBitForSixteenFramesOfAJointThatKeepsStill) {
  MotionClip clip{.name = {},
                  .motion_class = {},
                  .joint_count = 0,
                  .root = std::vector<Vec3>(1600),
                  .rotation = {},
                  .plants = std::vector<FootPlants>(1600)};
  const std::size_t alone = schema::encode(clip).size();
  clip.joint_count = 80;
  clip.rotation.assign(1600 * 80, Quat(1, 0, 0, 0));

  EXPECT_EQ(schema::encode(clip).size(), alone + 1000);
}

/// A whole clip for the tests of damage.
MotionClip swinging() {
  MotionClip clip{
      .name = {}, .motion_class = {}, .joint_count = 3, .root = {}, .rotation = {}, .plants = {}};
  for (int f = 0; f < 100; ++f) {
    clip.root.emplace_back(motion_grid::root_at(90 * f), 1, 0);
    for (int j = 0; j < 3; ++j) {
      const motion_grid::RotationSteps steps{f * j, 40 - f, 7, 0};
      clip.rotation.push_back(motion_grid::from_parts(
          {motion_grid::part_at(steps[0], 13), motion_grid::part_at(steps[1], 13),
           motion_grid::part_at(steps[2], 13),
           motion_grid::derived_at(motion_grid::derived_steps(steps, 3, 13), 13)}));
    }
    clip.plants.push_back({.left = f < 50, .right = f >= 40});
  }
  return clip;
}

TEST(MotionBlob, RefusesBytesThatAreCutShortOrGoOn) {
  const std::vector<std::byte> whole = schema::encode(swinging());
  for (std::size_t size = 0; size < whole.size(); ++size) {
    MotionClip clip;
    EXPECT_FALSE(schema::decode(std::span(whole).first(size), clip)) << size;
  }
  std::vector<std::byte> longer = whole;
  longer.push_back(std::byte{0});
  MotionClip clip;

  EXPECT_FALSE(schema::decode(longer, clip));
  EXPECT_TRUE(schema::decode(whole, clip));
}

TEST(MotionBlob, LeavesTheClipAloneThatItCannotDecode) {
  MotionClip clip = swinging();

  EXPECT_FALSE(schema::decode(bytes({13, 1, 0, 0, 0, 1, 0, 0, 0}), clip));

  EXPECT_EQ(clip.root.size(), 100U);
  EXPECT_EQ(clip.joint_count, 3U);
}

TEST(MotionBlob, TakesNoMoreMemoryThanTheBytesCouldFill) {
  const auto refuses = [](std::uint32_t bits, std::uint32_t frames, std::uint32_t joints) {
    std::vector<std::byte> blob(1009);
    blob[0] = static_cast<std::byte>(bits);
    for (std::size_t i = 0; i < 4; ++i) {
      blob[1 + i] = static_cast<std::byte>(frames >> (8 * i) & 255);
      blob[5 + i] = static_cast<std::byte>(joints >> (8 * i) & 255);
    }
    MotionClip clip;
    return !schema::decode(blob, clip);
  };
  const std::uint32_t most = 0xffffffff;
  for (const std::uint32_t bits : {0U, 7U, 8U, 22U, 23U, 255U}) {
    EXPECT_TRUE(refuses(bits, most, most)) << bits;
    EXPECT_TRUE(refuses(bits, most, 0)) << bits;
    EXPECT_TRUE(refuses(bits, 1, most)) << bits;
    EXPECT_TRUE(refuses(bits, 16, 8001)) << bits;
  }
}

TEST(MotionBlob, SurvivesAnyDamage) {
  EXPECT_TRUE(rc::check("flipped bits are no danger", [] {
    static const std::vector<std::byte> whole = schema::encode(swinging());
    std::vector<std::byte> damaged = whole;
    const int flips = *rc::gen::inRange(1, 5);
    for (int i = 0; i < flips; ++i)
      damaged[*rc::gen::inRange<std::size_t>(0, damaged.size())] ^=
          static_cast<std::byte>(1 << *rc::gen::inRange(0, 8));
    MotionClip clip;

    if (!schema::decode(damaged, clip)) return;

    RC_ASSERT(clip.plants.size() == clip.root.size());
    RC_ASSERT(clip.rotation.size() == clip.root.size() * clip.joint_count);
    if (damaged[0] != std::byte{0})
      for (const Quat& q : clip.rotation) RC_ASSERT(std::abs(glm::length(q) - 1) < 1e-5F);
  }));
}

}  // namespace
}  // namespace docent::schema::motion_blob_test
