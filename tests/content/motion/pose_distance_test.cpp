#include "content/motion/pose_distance.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/content/motion/shipped_clips.h"

namespace docent::test::pose_distance_test {
namespace {

/// A cloud of a few points that wander at random.
motion::offline::PoseCloud random_cloud(std::size_t frames) {
  Skeleton skeleton;
  skeleton.part.fill(JointIndex::None);
  for (const BodyPart part :
       {BodyPart::Hips, BodyPart::LeftKnee, BodyPart::RightKnee, BodyPart::Head})
    skeleton.part[static_cast<std::size_t>(part)] = JointIndex{static_cast<int>(
        std::ranges::count_if(skeleton.part, [](JointIndex j) { return j != JointIndex::None; }))};
  motion::offline::JointPositions track{.joints = 4, .place = {}};
  const auto coordinate = [] { return static_cast<float>(*rc::gen::inRange(-200, 200)) / 100.0f; };
  for (std::size_t i = 0; i < 4 * frames; ++i)
    track.place.push_back({coordinate(), coordinate(), coordinate()});
  return motion::offline::make_pose_cloud(skeleton, track);
}

/// The cloud turned and moved on the floor.
motion::offline::PoseCloud moved(motion::offline::PoseCloud cloud, double turn, Vec2 by) {
  const double c = std::cos(turn), s = std::sin(turn);
  for (std::size_t i = 0; i < cloud.x.size(); ++i) {
    const double x = cloud.x[i], y = cloud.y[i];
    cloud.x[i] = static_cast<float>(c * x - s * y);
    cloud.y[i] = static_cast<float>(s * x + c * y);
  }
  for (std::size_t f = 0; f < cloud.sum_x.size(); ++f) {
    const double x = cloud.sum_x[f], y = cloud.sum_y[f];
    cloud.sum_x[f] = c * x - s * y;
    cloud.sum_y[f] = s * x + c * y;
  }
  cloud.origin = {c * cloud.origin.x - s * cloud.origin.y + by.x,
                  s * cloud.origin.x + c * cloud.origin.y + by.y};
  return cloud;
}

/// The distance by its definition, for one alignment: no sums, no closed form.
double distance_under(const motion::offline::PoseCloud& a, std::size_t frame_a,
                      const motion::offline::PoseCloud& b, std::size_t frame_b, int half,
                      const Placement& alignment) {
  double sum = 0, weights = 0;
  for (int k = -half; k <= half; ++k) {
    const int fa = static_cast<int>(frame_a) + k, fb = static_cast<int>(frame_b) + k;
    if (fa < 0 || fb < 0 || fa >= static_cast<int>(a.frames) || fb >= static_cast<int>(b.frames))
      continue;
    for (std::size_t p = 0; p < a.points; ++p) {
      const std::size_t ia = p * a.frames + static_cast<std::size_t>(fa);
      const std::size_t ib = p * b.frames + static_cast<std::size_t>(fb);
      const double c = std::cos(alignment.heading), s = std::sin(alignment.heading);
      const Vec2 pa = Vec2{a.x[ia], a.y[ia]} + a.origin, pb = Vec2{b.x[ib], b.y[ib]} + b.origin;
      const Vec2 laid = Vec2{c * pb.x - s * pb.y, s * pb.x + c * pb.y} + alignment.position;
      const double up = static_cast<double>(a.h[ia]) - static_cast<double>(b.h[ib]);
      sum += static_cast<double>(a.weight[p]) * (dot(pa - laid, pa - laid) + up * up);
      weights += static_cast<double>(a.weight[p]);
    }
  }
  return std::sqrt(sum / weights);
}

constexpr std::size_t frames = 12;

TEST(PoseDistance, IsReachedByItsAlignmentAndBeatenByNoOther) {
  EXPECT_TRUE(rc::check([] {
    const motion::offline::PoseCloud a = random_cloud(frames), b = random_cloud(frames);
    const auto fa = *rc::gen::inRange<std::size_t>(0, frames);
    const auto fb = *rc::gen::inRange<std::size_t>(0, frames);

    const motion::offline::PoseMatch match = motion::offline::compare_poses(a, fa, b, fb, 3);

    RC_ASSERT(std::abs(distance_under(a, fa, b, fb, 3, match.alignment) - match.distance) < 1e-5);
    // All angles in steps of five degrees; for each, small moves off the best translation.
    for (int degrees = 0; degrees < 360; degrees += 5) {
      const double turn = degrees * std::numbers::pi / 180;
      Placement other{match.alignment.position, match.alignment.heading + turn};
      for (int round = 0; round < 60; ++round) {  // descend to this angle's own best place
        const double step = 2.0 * std::pow(0.8, round);
        for (const Vec2 move : {Vec2{step, 0}, {-step, 0}, {0, step}, {0, -step}}) {
          Placement tried = other;
          tried.position += move;
          if (distance_under(a, fa, b, fb, 3, tried) < distance_under(a, fa, b, fb, 3, other))
            other = tried;
        }
      }
      RC_ASSERT(distance_under(a, fa, b, fb, 3, other) > match.distance - 1e-6);
    }
  }));
}

TEST(PoseDistance, DoesNotChangeWhenEitherClipIsMovedOnTheFloor) {
  EXPECT_TRUE(rc::check([] {
    const motion::offline::PoseCloud a = random_cloud(frames), b = random_cloud(frames);
    const double turn = *rc::gen::inRange(-314, 314) / 100.0;
    const Vec2 by{*rc::gen::inRange(-9, 9) * 1.0, *rc::gen::inRange(-9, 9) * 1.0};
    const auto fa = *rc::gen::inRange<std::size_t>(0, frames);

    const double here = motion::offline::compare_poses(a, fa, b, 5, 3).distance;

    RC_ASSERT(std::abs(motion::offline::compare_poses(moved(a, turn, by), fa, b, 5, 3).distance -
                       here) < 1e-5);
    RC_ASSERT(std::abs(motion::offline::compare_poses(a, fa, moved(b, turn, by), 5, 3).distance -
                       here) < 1e-5);
  }));
}

TEST(PoseDistance, FindsTheMoveThatTwoCopiesAreApart) {
  const ShippedClips& shipped = shipped_clips();
  const motion::offline::PoseCloud walk = motion::offline::make_pose_cloud(
      shipped.skeleton, motion::offline::joint_positions(shipped.skeleton, shipped.named("walk")));
  EXPECT_TRUE(rc::check([&] {
    const double turn = *rc::gen::inRange(-300, 300) / 100.0;
    const Vec2 by{*rc::gen::inRange(-9, 9) * 1.0, *rc::gen::inRange(-9, 9) * 1.0};
    const auto frame = *rc::gen::inRange<std::size_t>(0, walk.frames);

    const motion::offline::PoseMatch match =
        motion::offline::compare_poses(moved(walk, turn, by), frame, walk, frame, 18);

    RC_ASSERT(match.distance < 2e-3);
    RC_ASSERT(std::abs(std::remainder(match.alignment.heading - turn, 2 * std::numbers::pi)) <
              1e-4);
    RC_ASSERT(glm::distance(match.alignment.position, by) < 1e-3);
  }));
}

TEST(PoseDistance, IsTheSameBothWaysRound) {
  EXPECT_TRUE(rc::check([] {
    const motion::offline::PoseCloud a = random_cloud(frames), b = random_cloud(frames);
    const auto fa = *rc::gen::inRange<std::size_t>(0, frames);
    const auto fb = *rc::gen::inRange<std::size_t>(0, frames);

    const double there = motion::offline::compare_poses(a, fa, b, fb, 3).distance;

    RC_ASSERT(std::abs(motion::offline::compare_poses(b, fb, a, fa, 3).distance - there) < 1e-9);
  }));
}

TEST(PoseDistance, OfAllPairsAtOnceIsThatOfEachPair) {
  EXPECT_TRUE(rc::check([] {
    // Less than a tile to several.
    const auto rows = *rc::gen::inRange<std::size_t>(1, 150);
    const auto columns = *rc::gen::inRange<std::size_t>(1, 90);
    const auto half = *rc::gen::inRange<std::size_t>(1, 6);
    const motion::offline::PoseCloud a = random_cloud(rows), b = random_cloud(columns);

    const motion::offline::DistanceMatrix matrix = motion::offline::measure_distances(a, b, half);

    for (std::size_t i = 0; i < rows; ++i)
      for (std::size_t j = 0; j < columns; ++j)
        RC_ASSERT(std::abs(static_cast<double>(matrix.at(i, j)) -
                           motion::offline::compare_poses(a, i, b, j, half).distance) < 2e-3);
  }));
}

TEST(PoseDistance, SeesTheNextStrideAsTheSamePose) {
  const ShippedClips& shipped = shipped_clips();
  const motion::offline::PoseCloud cloud = motion::offline::make_pose_cloud(
      shipped.skeleton, motion::offline::joint_positions(shipped.skeleton, shipped.named("walk")));

  const motion::offline::DistanceMatrix matrix =
      motion::offline::measure_distances(cloud, cloud, 18);

  std::size_t alike = 100 + 60;
  for (std::size_t f = alike; f < 100 + 180; ++f)
    if (matrix.at(100, f) < matrix.at(100, alike)) alike = f;
  EXPECT_NEAR(static_cast<double>(alike - 100) / 120, 1.1, 0.2);  // seconds a stride
  EXPECT_LT(matrix.at(100, alike), 0.04f);
  EXPECT_GT(matrix.at(100, 100 + (alike - 100) / 2), 0.15f);  // the other foot's step
}

}  // namespace
}  // namespace docent::test::pose_distance_test
