#include "content/motion/cut_takes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "content/import/motion/bvh_write.h"
#include "content/motion/compile_motion.h"
#include "runtime/motion/walk.h"
#include "tests/content/motion/shipped_clips.h"
#include "tests/support/temporary_folder.h"

namespace docent::test::cut_takes_test {
namespace {

using testing::ElementsAre;

/// A guide sets out, walks and stands again: what somebody records who is asked to.
MotionClip take_of(double metres) {
  const std::vector<Vec2> path{{0, 0}, {metres, 0}};
  motion::WalkRequest request;
  request.path = path;
  const motion::Walk walk = motion::make_walk(shipped_graph(), request).value();
  MotionClip clip;
  clip.name = "take";
  clip.frame_rate = walk.frame_rate;
  clip.joint_count = walk.joint_count;
  clip.root = walk.root;
  clip.rotation = walk.rotation;
  return clip;
}

/// The body stands where it ended, for so long.
void stand(MotionClip& clip, double seconds) {
  const std::vector<Quat> pose(clip.rotation.end() - clip.joint_count, clip.rotation.end());
  for (int f = 0; f < seconds * clip.frame_rate; ++f) {
    clip.root.push_back(clip.root.back());
    clip.rotation.insert(clip.rotation.end(), pose.begin(), pose.end());
  }
}

std::vector<std::string> names_of(const std::vector<MotionClip>& clips) {
  std::vector<std::string> names;
  for (const MotionClip& clip : clips) names.push_back(clip.name);
  return names;
}

TEST(ATake, ThatStandsAtBothEndsHoldsAStartAWalkAndAStop) {
  MotionClip take = take_of(15);
  stand(take, 3);

  const auto clips = motion::offline::cut_take(shipped_graph().skeleton, take);

  ASSERT_THAT(names_of(clips), ElementsAre("take, start", "take, walk", "take, stop"));
  for (const MotionClip& clip : clips) {
    EXPECT_EQ(clip.rotation.size(), clip.root.size() * clip.joint_count) << clip.name;
    EXPECT_LT(clip.root.size() + static_cast<std::size_t>(2 * clip.frame_rate), take.root.size())
        << clip.name;
  }
  EXPECT_EQ(clips[0].root.back(),
            clips[1].root[static_cast<std::size_t>(1.5 * take.frame_rate) - 1])
      << "one goes on in the next";
}

TEST(ATake, TooShortForThreeHoldsAStartAndAStop) {
  MotionClip take = take_of(5);
  stand(take, 2);

  EXPECT_THAT(names_of(motion::offline::cut_take(shipped_graph().skeleton, take)),
              ElementsAre("take, start", "take, stop"));
}

TEST(ATake, InWhichSomebodyStandsForAWhileHoldsEachStretchOfWalking) {
  MotionClip take = take_of(5);
  stand(take, 4);
  const MotionClip again = take_of(5);
  const Vec3 on = take.root.back() - again.root.front();
  for (const Vec3& root : again.root) take.root.push_back(root + Vec3(on.x, 0, on.z));
  take.rotation.insert(take.rotation.end(), again.rotation.begin(), again.rotation.end());
  stand(take, 2);

  EXPECT_THAT(names_of(motion::offline::cut_take(shipped_graph().skeleton, take)),
              ElementsAre("take, start 1", "take, stop 1", "take, start 2", "take, stop 2"));
}

TEST(ATake, ThatBeginsInMidStrideHasNoStartThere) {
  MotionClip take = take_of(12);
  const auto cut = static_cast<std::size_t>(3 * take.frame_rate);
  take.root.erase(take.root.begin(), take.root.begin() + static_cast<std::ptrdiff_t>(cut));
  take.rotation.erase(take.rotation.begin(),
                      take.rotation.begin() + static_cast<std::ptrdiff_t>(cut * take.joint_count));
  stand(take, 4);
  const MotionClip again = take_of(5);
  const Vec3 on = take.root.back() - again.root.front();
  for (const Vec3& root : again.root) take.root.push_back(root + Vec3(on.x, 0, on.z));
  take.rotation.insert(take.rotation.end(), again.rotation.begin(), again.rotation.end());
  stand(take, 2);

  EXPECT_THAT(names_of(motion::offline::cut_take(shipped_graph().skeleton, take)),
              ElementsAre("take, stop 1", "take, start 2", "take, stop 2"));
}

TEST(ATake, ThatIsOneClipStaysWhole) {
  for (const auto& source : shipped_clips().clips)
    EXPECT_THAT(names_of(motion::offline::cut_take(shipped_clips().skeleton, source.clip)),
                ElementsAre(source.clip.name));
}

TEST(ATake, IsAllThatAMotionGraphNeeds) {
  MotionClip take = take_of(30);
  stand(take, 1);
  const TemporaryFolder folder;
  import::write_bvh(shipped_graph().skeleton, {take.frame_rate, take.root, take.rotation},
                    folder.path() / "take.bvh");
  std::vector<Diagnostic> problems;

  const MotionGraph graph = motion::offline::compile_motion(folder.path(), {}, problems);

  EXPECT_EQ(std::ranges::count(problems, "cut-take", &Diagnostic::code), 1);
  EXPECT_EQ(std::ranges::count(problems, "made-clip", &Diagnostic::code), 0);
  const std::vector<Vec2> path{{0, 0}, {8, 0}};
  motion::WalkRequest request;
  request.path = path;
  const Result<motion::Walk> walk = motion::make_walk(graph, request);
  ASSERT_TRUE(walk.has_value()) << walk.error().what;
  EXPECT_LT(glm::distance(walk->body.back().position, path.back()), 0.02);
}

}  // namespace
}  // namespace docent::test::cut_takes_test
