#include "content/motion/classify.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "content/import/motion/bvh.h"
#include "content/motion/foot_plants.h"
#include "tests/support/reference_data.h"

namespace docent::test::classify_test {
namespace {

motion::offline::ClipMeasures measures_of(const std::string& recording) {
  import::RecordedMotion motion =
      import::read_bvh(reference_data() / "mocap/cmu-varied" / recording, {});
  const auto track = motion::offline::joint_positions(motion.skeleton, motion.clip);
  motion::offline::find_foot_plants(motion.skeleton, track, motion.clip);
  return motion::offline::measure_clip(motion.skeleton, motion.clip, track);
}

/// Who walks briskly lands on the heel, and the toe comes down after the other toe has left.
TEST(BriskWalks, AreOnTheGroundThroughout) {
  NEEDS_REFERENCE_DATA("mocap/cmu-varied");
  for (const char* walk :
       {"16_21-brisk-walk.bvh", "16_24-brisk-veer-left.bvh", "16_26-brisk-veer-right.bvh",
        "16_27-brisk-turn-left-90.bvh", "16_30-brisk-turn-right-90.bvh", "49_01-walk.bvh"})
    EXPECT_LT(measures_of(walk).airborne, 0.06) << walk;
}

TEST(Runs, AreInTheAirForAThirdOfTheTimeAndMore) {
  NEEDS_REFERENCE_DATA("mocap/cmu-varied");
  for (const char* run : {"02_03-jog.bvh", "09_01-run.bvh", "16_37-jog-veer-left.bvh",
                          "16_43-jog-turn-right-90.bvh", "16_55-run-from-walk.bvh"})
    EXPECT_GT(measures_of(run).airborne, 0.33) << run;
}

}  // namespace
}  // namespace docent::test::classify_test
