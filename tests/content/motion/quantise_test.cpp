#include "content/motion/quantise.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "content/import/motion/motion_folder.h"
#include "runtime/schema/motion_blob.h"
#include "tests/content/motion/shipped_clips.h"
#include "tests/support/reference_data.h"

namespace docent::test::quantise_test {
namespace {

/// What a database may take for a second of motion.
constexpr double most_bytes_a_second = 12000;

double seconds_of(const MotionClip& clip) {
  return static_cast<double>(clip.root.size()) / clip.frame_rate;
}

/// Does the database take no more than it may, and show the motion as it was?
void expect_small_and_close(const Skeleton& skeleton, MotionClip clip) {
  clip.plants.resize(clip.root.size());
  MotionClip quantised = clip;
  motion::offline::quantise(skeleton, quantised);
  const std::vector<std::byte> bytes = schema::encode(quantised);
  MotionClip read;

  ASSERT_TRUE(schema::decode(bytes, read)) << clip.name;

  EXPECT_LE(static_cast<double>(bytes.size()), most_bytes_a_second * seconds_of(clip)) << clip.name;
  EXPECT_LE(motion::offline::largest_difference(skeleton, clip, read), 0.001) << clip.name;
  EXPECT_EQ(read.root, quantised.root) << clip.name;
  EXPECT_EQ(read.rotation, quantised.rotation) << clip.name;
}

void expect_small_and_close(const std::filesystem::path& folder) {
  std::vector<Diagnostic> problems;
  for (const import::FolderMotion& file : import::read_motion_folder(folder, problems))
    expect_small_and_close(file.motion.skeleton, file.motion.clip);
}

TEST(QuantisedMotion, IsSmallAndCloseForTheShippedClips) {
  expect_small_and_close(source_dir() / "content/clips");
}

TEST(QuantisedMotion, IsSmallAndCloseForTheRecordedWalks) {
  NEEDS_REFERENCE_DATA("mocap/cmu-walk");
  expect_small_and_close(reference_data() / "mocap/cmu-walk");
}

TEST(QuantisedMotion, IsSmallAndCloseForRecordingsOfAllKinds) {
  NEEDS_REFERENCE_DATA("mocap/cmu-varied");
  expect_small_and_close(reference_data() / "mocap/cmu-varied");
}

TEST(QuantisedMotion, IsWhatAMotionGraphIsMadeOf) {
  for (const MotionClip& clip : shipped_graph().clips) {
    const std::vector<std::byte> bytes = schema::encode(clip);

    EXPECT_NE(bytes[0], std::byte{0}) << clip.name << " is stored as plain floats";
    EXPECT_LE(static_cast<double>(bytes.size()), most_bytes_a_second * seconds_of(clip))
        << clip.name;
  }
}

float number(int low, int high, float unit) {
  return static_cast<float>(*rc::gen::inRange(low, high)) * unit;
}
Vec3 direction() {
  const float x = number(-100, 101, 1), y = number(-100, 101, 1), z = number(-100, 101, 1);
  const Vec3 some(x, y, z);
  return some == Vec3{} ? Vec3(0, 1, 0) : glm::normalize(some);
}

/// Any tree of joints with bones of up to 2 m.
Skeleton some_skeleton() {
  Skeleton skeleton;
  const int joints = *rc::gen::inRange(1, 12);
  for (int j = 0; j < joints; ++j) {
    const int parent = j == 0 ? -1 : *rc::gen::inRange(0, j);
    skeleton.joint.push_back(
        {.name = {}, .parent = JointIndex{parent}, .offset = number(0, 200, 0.01F) * direction()});
  }
  skeleton.has_rotation.assign(skeleton.joint.size(), true);
  return skeleton;
}

/// Every joint turns about an axis at a speed of its own, up to 19 rad/s, at times all the way
/// round; some leap to another rotation; quaternions need not be of quite unit length.
MotionClip some_motion(const Skeleton& skeleton) {
  MotionClip clip;
  clip.joint_count = static_cast<std::uint32_t>(skeleton.joint.size());
  const int frames = *rc::gen::inRange(1, 60);
  clip.rotation.resize(static_cast<std::size_t>(frames) * clip.joint_count);
  clip.plants.resize(static_cast<std::size_t>(frames));
  const Vec3 speed = number(0, 100, 0.001F) * direction();
  for (int f = 0; f < frames; ++f) clip.root.push_back(static_cast<float>(f) * speed);
  for (std::size_t j = 0; j < clip.joint_count; ++j) {
    Vec3 axis = direction();
    const float step = number(-160, 161, 0.001F), scale = number(90, 111, 0.01F);
    float angle = number(-314, 315, 0.02F);
    for (std::size_t f = 0; f < clip.root.size(); ++f) {
      if (*rc::gen::inRange(0, 40) == 0) axis = direction();
      clip.rotation[f * clip.joint_count + j] = scale * glm::angleAxis(angle, axis);
      angle += step;
    }
  }
  return clip;
}

/// The motion with quaternions of unit length, which is what it means.
MotionClip made_whole(MotionClip clip) {
  for (Quat& q : clip.rotation) q = glm::normalize(q);
  return clip;
}

TEST(QuantisedMotion, KeepsTheEndOfEveryJointOfAnyBodyInAnyMotion) {
  EXPECT_TRUE(rc::check("at most a millimetre", [] {
    const Skeleton skeleton = some_skeleton();
    const MotionClip clip = made_whole(some_motion(skeleton));
    MotionClip quantised = clip;

    motion::offline::quantise(skeleton, quantised);

    RC_ASSERT(motion::offline::largest_difference(skeleton, clip, quantised) <= 0.001);
  }));
}

TEST(QuantisedMotion, IsReadAsItWasWritten) {
  EXPECT_TRUE(rc::check("on a grid", [] {
    const Skeleton skeleton = some_skeleton();
    MotionClip quantised = some_motion(skeleton);

    motion::offline::quantise(skeleton, quantised);

    const std::vector<std::byte> bytes = schema::encode(quantised);
    MotionClip read;
    RC_ASSERT(bytes[0] != std::byte{0});  // no plain floats
    RC_ASSERT(schema::decode(bytes, read));
    RC_ASSERT(read.root == quantised.root);
    RC_ASSERT(read.rotation == quantised.rotation);
    RC_ASSERT(schema::encode(read) == bytes);
  }));
}

TEST(QuantisedMotion, IsCoarserForASmallerBody) {
  Skeleton skeleton{.joint = {{.name = "hips", .parent = JointIndex::None, .offset = {}},
                              {.name = "hand", .parent = JointIndex{0}, .offset = {0, 1, 0}}},
                    .has_rotation = {true, false}};
  MotionClip clip;
  clip.joint_count = 2;
  for (int f = 0; f < 500; ++f) {
    clip.root.emplace_back(0, 1, 0);
    clip.rotation.push_back(glm::angleAxis(0.013F * static_cast<float>(f), Vec3(1, 0, 0)));
    clip.rotation.emplace_back(1, 0, 0, 0);
    clip.plants.push_back({});
  }
  const auto bits = [&](float length) {
    skeleton.joint[1].offset.y = length;
    MotionClip quantised = clip;
    motion::offline::quantise(skeleton, quantised);
    return std::to_integer<int>(schema::encode(quantised)[0]);
  };

  EXPECT_LT(bits(0.25F), bits(1));
  EXPECT_LT(bits(1), bits(8));
}

}  // namespace
}  // namespace docent::test::quantise_test
