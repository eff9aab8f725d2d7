#include "content/motion/fewer_joints.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "content/import/motion/bvh_write.h"
#include "content/import/motion/motion_file.h"
#include "content/motion/compile_motion.h"
#include "tests/content/motion/shipped_clips.h"
#include "tests/support/temporary_folder.h"

namespace docent::test::fewer_joints_test {
namespace {

/// A skeleton and its clips.
struct Body {
  Skeleton skeleton;
  std::vector<MotionClip> clips;
};

/// The shipped ones with short bones more on a hand.
Body with_fingers(std::size_t count) {
  Body body{shipped_graph().skeleton, shipped_graph().clips};
  const JointIndex wrist = body.skeleton[BodyPart::LeftWrist];
  for (std::size_t i = 0; i < count; ++i) {
    body.skeleton.joint.push_back(
        {"LeftFinger" + std::to_string(i), wrist, Vec3{0.001F * static_cast<float>(i % 9), 0, 0}});
    body.skeleton.has_rotation.push_back(true);
  }
  for (MotionClip& clip : body.clips) {
    std::vector<Quat> rotation;
    for (std::size_t f = 0; f < clip.root.size(); ++f) {
      const auto first = clip.rotation.begin() + static_cast<std::ptrdiff_t>(f * clip.joint_count);
      rotation.insert(rotation.end(), first, first + clip.joint_count);
      rotation.insert(rotation.end(), count, Quat(1, 0, 0, 0));
    }
    clip.rotation = std::move(rotation);
    clip.joint_count += static_cast<std::uint32_t>(count);
  }
  return body;
}

TEST(FewerJoints, KeepWhatIsAPartOfTheBodyWhereItWas) {
  const Body many = with_fingers(100);
  const auto kept = motion::offline::joints_of_parts(many.skeleton);
  const Skeleton fewer = motion::offline::with_joints(many.skeleton, kept);

  ASSERT_LE(fewer.joint.size(), shipped_graph().skeleton.joint.size());
  for (std::size_t p = 0; p < fewer.part.size(); ++p) {
    const JointIndex before = many.skeleton.part[p], after = fewer.part[p];
    ASSERT_EQ(before == JointIndex::None, after == JointIndex::None) << p;
    if (after == JointIndex::None) continue;
    EXPECT_EQ(fewer.joint[index_of(after)].name, many.skeleton.joint[index_of(before)].name);
  }
  for (const MotionClip& clip : many.clips) {
    const MotionClip plain = motion::offline::with_joints(clip, kept);
    std::vector<Vec3> places, places_before;
    for (std::size_t f = 0; f < clip.root.size(); f += 20) {
      import::place_joints(many.skeleton, clip, f, places_before);
      import::place_joints(fewer, plain, f, places);
      for (std::size_t j = 0; j < kept.size(); ++j) EXPECT_EQ(places[j], places_before[kept[j]]);
    }
  }
}

TEST(FewerJoints, AreWhatIsCompiledOfAHandWithAHundredFingers) {
  const TemporaryFolder folder;
  const Body many = with_fingers(100);
  for (const MotionClip& clip : many.clips)
    import::write_bvh(many.skeleton, {clip.frame_rate, clip.root, clip.rotation},
                      folder.path() / (clip.name + ".bvh"));
  std::vector<Diagnostic> problems;
  const MotionGraph graph = motion::offline::compile_motion(folder.path(), {}, problems);

  EXPECT_LE(graph.skeleton.joint.size(), most_joints);
  EXPECT_THAT(problems, testing::Contains(testing::Field(&Diagnostic::code, "joints-left-out")));
  EXPECT_EQ(graph.clips.size(), many.clips.size());
}

}  // namespace
}  // namespace docent::test::fewer_joints_test
