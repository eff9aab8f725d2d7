#include "tests/bench/naturalness.h"

#include <gtest/gtest.h>

#include <map>
#include <memory>

#include "content/motion/compile_motion.h"
#include "platform/sqlite/content_reader.h"
#include "runtime/motion/make_foresight.h"
#include "tests/bench/measure.h"
#include "tests/bench/naturalness_table.h"
#include "tests/bench/zero_moment_point.h"
#include "tests/support/sample_database.h"
#include "tests/support/sanitized.h"

namespace docent::bench::naturalness_test {
namespace {

/// A motion graph and what walks on it.
struct Walkers {
  MotionGraph motion;
  motion::WalkGraph graph;
  std::vector<TrackedMotion> clips;
};

const Walkers& walkers_of(const std::filesystem::path& folder) {
  static std::map<std::filesystem::path, std::unique_ptr<Walkers>> known;
  std::unique_ptr<Walkers>& made = known[folder];
  if (made) return *made;
  made = std::make_unique<Walkers>();
  std::vector<Diagnostic> problems;
  made->motion = motion::offline::compile_motion(folder, {}, problems);
  made->graph = *motion::make_walk_graph(made->motion);
  made->motion.foresight = motion::make_foresight(made->graph);
  made->clips = track_clips(made->graph);
  return *made;
}
/// Measured once, for the tests that ask for it.
const Naturalness& look_of(const Walkers& walkers) {
  static std::map<const Walkers*, Naturalness> known;
  if (const auto found = known.find(&walkers); found != known.end()) return found->second;
  const Result<Museum> museum = sqlite::load_museum(test::sample_database());
  return known[&walkers] = measure_naturalness(walkers.graph, museum_routes(*museum));
}
const Walkers& shipped() {
  return walkers_of(test::source_dir() / "content/clips");
}
const Walkers& recorded() {
  return walkers_of(test::reference_data() / "mocap/cmu-walk");
}

/// The same motion at another speed: every frame twice.
TrackedMotion at_half_speed(const TrackedMotion& motion) {
  TrackedMotion slow;
  slow.rate = motion.rate;
  for (std::size_t f = 0; f < 2 * motion.frames(); ++f) {
    slow.part.push_back(motion.part[f / 2]);
    slow.body.push_back(motion.body[f / 2]);
    slow.plants.push_back(motion.plants[f / 2]);
    slow.is_walking.push_back(motion.is_walking[f / 2]);
  }
  return slow;
}

TEST(RecordedPoses, AreNearThemselvesAndFarFromSlowMotion) {
  const std::vector<TrackedMotion>& clips = shipped().clips;
  const RecordedPoses poses(clips);

  EXPECT_LT(quantile(poses.distances(clips.back()), 0.95), 1e-3);
  EXPECT_GT(quantile(poses.distances(at_half_speed(clips.back())), 0.95), 0.05);
}

TEST(StepSeconds, DoubleInSlowMotion) {
  const TrackedMotion& walk = shipped().clips.back();

  EXPECT_NEAR(median(step_seconds(at_half_speed(walk))), 2 * median(step_seconds(walk)), 0.01);
}

TEST(NearestOtherStride, IsTheSameOneWhereAMotionRepeatsItself) {
  const std::vector<TrackedMotion> twice(2, shipped().clips.back());

  EXPECT_LT(median(nearest_other_stride(twice)), 1e-6);
  EXPECT_GT(median(nearest_other_stride(shipped().clips)), 0.005);
}

TEST(HeadBend, FindsAHeadThatJumps) {
  TrackedMotion walk = shipped().clips.back();
  const double before = head_bend(walk);
  for (std::size_t f = 200; f < walk.frames(); ++f)
    walk.part[f][static_cast<std::size_t>(BodyPart::Head)] += Vec3(0, 0.03F, 0);

  EXPECT_LT(before, 0.015);
  EXPECT_GT(head_bend(walk), 0.025);
  EXPECT_NEAR(head_bend_time(walk), 200 / walk.rate, 0.05);
}

TEST(ZeroMomentPoint, LeavesTheFeetOfABodyThatIsThrown) {
  TrackedMotion walk = shipped().clips.back();
  const double before = quantile(outside_the_feet(walk), 0.95);
  for (std::size_t f = 0; f < walk.frames(); ++f)  // 5 cm to and fro, twice a second
    for (Vec3& part : walk.part[f])
      part.x += 0.05F * std::sin(12.6F * static_cast<float>(f) / static_cast<float>(walk.rate));

  EXPECT_LT(before, 0.08);
  EXPECT_GT(quantile(outside_the_feet(walk), 0.95), 0.2);
}

/// What holds of walks on any good clips.
void expect_natural(const Naturalness& look) {
  EXPECT_LE(look.worst_head_bend(), 1);
  EXPECT_GE(look.other_stride, 0.019) << "strides repeat themselves";
  EXPECT_LT(look.knee_jolt, 284);
  for (const double swing : look.arm_swing) EXPECT_NEAR(swing, 0.20, 0.07);
  for (const double varies : look.arm_variation) EXPECT_GT(varies, 0.08);
  for (const RoutesLook& routes : look.routes) {
    EXPECT_LT(routes.drift, 0.0016) << routes.kind;
    EXPECT_LT(routes.deviation_mean, 0.008) << routes.kind;
  }
}

TEST(ShippedWalks, LookAsNaturalAsIsPromised) {
  NEEDS_SPEED();
  const Naturalness& look = look_of(shipped());

  expect_natural(look);
  for (const RoutesLook& routes : std::span(look.routes).first(3)) {
    EXPECT_LE(routes.long_steps, 0.03) << routes.kind;
    EXPECT_LT(routes.nearest_pose, 0.07) << routes.kind;
    EXPECT_LT(routes.outside_feet, 0.09) << routes.kind;
  }
  EXPECT_LT(look.routes.back().step_median, 0.66) << "corners in slow motion";
}

TEST(RecordedWalks, LookAsNaturalAsIsPromised) {
  NEEDS_SPEED();
  NEEDS_REFERENCE_DATA("mocap/cmu-walk");
  const Naturalness& look = look_of(recorded());

  expect_natural(look);
  for (const RoutesLook& routes : std::span(look.routes).first(3)) {
    EXPECT_LE(routes.long_steps, 0.06) << routes.kind;
    EXPECT_LT(routes.nearest_pose, 0.08) << routes.kind;
    EXPECT_LT(routes.outside_feet, 1.2 * look.outside_feet_of_clips) << routes.kind;
  }
}

}  // namespace
}  // namespace docent::bench::naturalness_test
