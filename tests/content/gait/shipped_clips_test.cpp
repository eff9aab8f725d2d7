#include <gtest/gtest.h>

#include <filesystem>

#include "content/gait/gait.h"
#include "content/gait/gait_skeleton.h"
#include "content/import/motion/bvh.h"
#include "content/motion/compile_motion.h"
#include "tests/support/reference_data.h"

namespace docent::gait::shipped_clips_test {
namespace {

std::filesystem::path folder() {
  return test::source_dir() / "content" / "clips";
}

TEST(ShippedClips, AreWhatTheGeneratorMakes) {
  for (const GaitRecipe& recipe : default_clips()) {
    const MotionClip made = make_gait_clip(recipe);
    const import::RecordedMotion shipped = import::read_bvh(folder() / (recipe.name + ".bvh"), 1.0);

    ASSERT_EQ(shipped.clip.root.size(), made.root.size()) << recipe.name << ": run ninja clips";
    ASSERT_EQ(shipped.clip.joint_count, made.joint_count);
    for (std::size_t f = 0; f < made.root.size(); ++f) {
      ASSERT_LT(glm::length(shipped.clip.root[f] - made.root[f]), 1e-4F) << recipe.name;
      for (std::size_t j = 0; j < made.joint_count; ++j) {
        const std::size_t at = f * made.joint_count + j;
        ASSERT_GT(std::abs(glm::dot(shipped.clip.rotation[at], made.rotation[at])), 0.999999F)
            << recipe.name << " frame " << f << ": run ninja clips";
      }
    }
  }
}

TEST(ShippedClips, NameEveryPartOfTheBody) {
  const Skeleton made = gait_skeleton();
  const import::RecordedMotion shipped = import::read_bvh(folder() / "walk.bvh", 1.0);

  EXPECT_EQ(shipped.skeleton.part, made.part);
  EXPECT_TRUE(shipped.notes.empty());
}

TEST(ShippedClips, MakeAWellConnectedMotionGraph) {
  std::vector<Diagnostic> problems;
  const MotionGraph graph = motion::offline::compile_motion(folder(), {}, problems);

  EXPECT_TRUE(problems.empty());
  EXPECT_EQ(graph.clips.size(), 9U);
  EXPECT_GT(graph.transitions.size(), 200U);
  std::size_t into_stop = 0;
  for (const Transition& transition : graph.transitions)
    into_stop += graph.clips[transition.to.clip].role == ClipRole::Stop ? 1 : 0;
  EXPECT_GT(into_stop, 10U);
}

}  // namespace
}  // namespace docent::gait::shipped_clips_test
