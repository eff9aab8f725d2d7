#include "runtime/guide/manner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include "runtime/guide/avatar.h"
#include "runtime/motion/leg.h"
#include "tests/support/sample_as_read.h"

namespace docent::guide::manner_test {
namespace {

constexpr double frame = 1.0 / 60;

std::unique_ptr<plan::Plan> walk_ahead(const Placement& from, double metres) {
  auto plan = std::make_unique<plan::Plan>();
  plan->points = {from.position,
                  from.position + metres * Vec2{std::cos(from.heading), std::sin(from.heading)}};
  plan->reach = {0, metres};
  plan->status = path::RouteStatus::Ok;
  motion::WalkRequest request;
  request.path = plan->points;
  request.start = from;
  plan->walk = motion::make_walk(test::sample_museum().motion, request).value();
  return plan;
}

/// One guide, without a crowd.
struct Body {
  explicit Body(std::uint64_t who = 1)
      : avatar(make_avatar(test::sample_museum(), 0,
                           plan::make_standing(test::sample_museum(), test::sample_museum().kiosk),
                           who)) {}

  void run(double seconds) {
    for (long i = 0; i < std::lround(seconds / frame); ++i)
      advance(test::sample_museum(), avatar, frame);
  }
  void set_out(double metres) {
    avatar.plan = walk_ahead(avatar.body, metres);
    avatar.seconds = 0;
  }
  Vec3 beside(double angle, double metres, double height) const {
    const double heading = avatar.body.heading + angle;
    return to_world(avatar.body.position + metres * Vec2{std::cos(heading), std::sin(heading)},
                    height);
  }
  Vec3 joint(BodyPart part) const {
    return Vec3(avatar.world[index_of(test::sample_museum().motion.skeleton[part])][3]);
  }
  /// Where the face looks.
  Vec3 face() const {
    return Vec3(avatar.world[index_of(test::sample_museum().motion.skeleton[BodyPart::Head])] *
                Vec4(0, 0, 1, 0));
  }
  double highest_hand() const {
    return std::max(joint(BodyPart::LeftHandTip).y, joint(BodyPart::RightHandTip).y);
  }
  Avatar avatar;
};

/// Degrees between where the face looks and a point, seen from above.
double degrees_aside(const Body& body, Vec3 target) {
  const Vec2 face = to_floor(body.face()), line = to_floor(target - body.joint(BodyPart::Head));
  return std::abs(std::atan2(cross(face, line), dot(face, line))) * 180 / std::numbers::pi;
}

float distance_to_ray(Vec3 point, Vec3 from, Vec3 through) {
  return glm::length(glm::cross(point - from, glm::normalize(through - from)));
}

TEST(Manner, GreetsWithAHandAboveTheShoulderAndTheFaceTowardsTheCameraWithinASecond) {
  for (const double angle : {0.4, -1.0, 1.3}) {
    Body body;
    body.avatar.company.visitor = body.beside(angle, 5, 5);
    body.run(2);
    greet(body.avatar.manner);
    body.run(0.75);
    EXPECT_GT(body.highest_hand(), body.joint(BodyPart::LeftShoulder).y + 0.15) << angle;
    body.run(0.25);
    EXPECT_LT(degrees_aside(body, *body.avatar.company.visitor), 8) << angle;
    EXPECT_GT(body.face().y, 0.3) << "up to where the camera is";
    body.run(2);
    EXPECT_LT(body.highest_hand(), body.joint(BodyPart::Hips).y) << angle;
  }
}

TEST(Manner, LiftsTheHandInTheNextFrameAndDoesNotDelayTheWalk) {
  Body greeting, plain;
  for (Body* body : {&greeting, &plain}) {
    body->avatar.company.visitor = body->beside(std::numbers::pi, 6, 7);
    body->run(1);
    body->set_out(6);
  }
  greet(greeting.avatar.manner);
  EXPECT_EQ(greeting.avatar.manner.gesture, motion::Gesture::None);
  greeting.run(frame);
  EXPECT_EQ(greeting.avatar.manner.gesture, motion::Gesture::Wave);
  plain.run(frame);
  for (int i = 0; i < 120; ++i) {
    greeting.run(frame);
    plain.run(frame);
    ASSERT_EQ(greeting.avatar.body.position, plain.avatar.body.position);
    ASSERT_LT(glm::distance(greeting.joint(BodyPart::LeftToe), plain.joint(BodyPart::LeftToe)),
              1e-5F)
        << "the feet know nothing of it";
  }
}

TEST(Manner, LooksRoundNowAndThenToSeeThatTheVisitorFollows) {
  int walks = 0, seen = 0;
  for (std::uint64_t who = 0; who < 10; ++who) {
    Body body(who);
    body.avatar.company = {.visitor = Vec3{}, .is_used = true};
    body.set_out(12);
    bool looked = false;
    while (!has_finished(body.avatar)) {
      body.avatar.company.visitor = body.beside(std::numbers::pi, 6, 7);
      body.run(frame);
      looked = looked || std::abs(body.avatar.manner.gaze.yaw) > 1.2;
      EXPECT_LE(std::abs(body.avatar.manner.gaze.yaw), motion::most_gaze_yaw);
    }
    ++walks;
    seen += looked ? 1 : 0;
  }
  EXPECT_GE(seen, walks - 1);
}

TEST(Manner, PointsAtWhatItShowsWithinFiveCentimetresAndLooksThere) {
  std::mt19937 chance(17);
  std::uniform_real_distribution<double> aside(-1.3, 1.3), away(1.1, 3), height(0.6, 1.9);
  for (int i = 0; i < 100; ++i) {
    Body body(static_cast<std::uint64_t>(i));
    const double angle = aside(chance);
    const Vec3 target = body.beside(angle, away(chance), height(chance));
    body.avatar.company = {
        .visitor = body.beside(-angle, 6, 6), .is_used = true, .exhibit = target};
    body.run(1.25);
    EXPECT_LT(degrees_aside(body, target), 10) << i;
    body.run(1.5);  // it looks at the visitor meanwhile
    const bool left = body.avatar.manner.side == Side::Left;
    const Vec3 tip = body.joint(left ? BodyPart::LeftHandTip : BodyPart::RightHandTip);
    EXPECT_LT(
        distance_to_ray(target, body.joint(left ? BodyPart::LeftWrist : BodyPart::RightWrist), tip),
        0.05F)
        << i;
    EXPECT_LT(distance_to_ray(
                  target, body.joint(left ? BodyPart::LeftShoulder : BodyPart::RightShoulder), tip),
              0.05F)
        << i;
  }
}

TEST(Manner, KeepsTheFeetWhereTheyAreWhateverItDoesStanding) {
  Body body;
  body.avatar.company = {
      .visitor = body.beside(-0.8, 6, 6), .is_used = true, .exhibit = body.beside(0.9, 1.6, 1.2)};
  const Vec3 left = body.joint(BodyPart::LeftToe), right = body.joint(BodyPart::RightToe);
  const Vec3 heel = body.joint(BodyPart::LeftAnkle);
  for (int i = 0; i < 60 * 120; ++i) {
    body.run(frame);
    if (i % 700 == 0) greet(body.avatar.manner);
    ASSERT_LT(glm::distance(body.joint(BodyPart::LeftToe), left), 0.005F) << i;
    ASSERT_LT(glm::distance(body.joint(BodyPart::RightToe), right), 0.005F) << i;
    ASSERT_LT(glm::distance(body.joint(BodyPart::LeftAnkle), heel), 0.005F) << i;
  }
}

TEST(Manner, NeverShowsTheSameTwentySecondsTwiceInAnHour) {
  Body body;
  body.avatar.company = {
      .visitor = body.beside(-0.8, 6, 6), .is_used = true, .exhibit = body.beside(0.9, 1.6, 1.2)};
  body.run(10);
  std::vector<std::vector<Vec3>> films;
  for (int window = 0; window < 3600 / 20; ++window) {
    std::vector<Vec3>& film = films.emplace_back();
    for (int second = 0; second < 20; ++second) {
      body.run(1);
      for (const Mat4& joint : body.avatar.world) film.emplace_back(joint[3]);
    }
  }
  float nearest = 1;
  for (std::size_t i = 0; i < films.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      float most = 0;
      for (std::size_t k = 0; k < films[i].size(); ++k)
        most = std::max(most, glm::distance(films[i][k], films[j][k]));
      nearest = std::min(nearest, most);
    }
  EXPECT_GT(nearest, 0.05F) << "metres by which some joint is elsewhere at some second";
}

TEST(Manner, MovesNoJointQuickerThanTheClipsMoveTheirQuickestHoweverItIsInterrupted) {
  float quickest = 0;  // metres a second
  for (const MotionClip& clip : test::sample_museum().motion.clips) {
    const Skeleton& skeleton = test::sample_museum().motion.skeleton;
    std::vector<Quat> rotation(skeleton.joint.size());
    std::vector<Mat4> world(rotation.size()), last;
    for (double t = 0; t * clip.frame_rate < frame_count(clip); t += frame) {
      motion::PoseView pose{{}, rotation};
      motion::sample(clip, t, pose);
      motion::to_world_space(skeleton, pose, world);
      for (std::size_t j = 0; j < last.size(); ++j)
        quickest = std::max(quickest, glm::distance(Vec3(world[j][3]), Vec3(last[j][3])) /
                                          static_cast<float>(frame));
      last = world;
    }
  }
  Body body;
  std::mt19937 chance(17);
  float worst = 0;
  for (int walk = 0; walk < 12; ++walk) {
    body.set_out(2 + walk % 3);
    if (walk % 4 == 3) body.avatar.plan = walk_ahead(test::sample_museum().kiosk, 1), body.run(0);
    for (int i = 0, wait = 0; i < 60 * 14; ++i, --wait) {
      Company& company = body.avatar.company;
      if (wait <= 0) {
        wait = std::uniform_int_distribution(3, 150)(chance);
        const int what = std::uniform_int_distribution(0, 3)(chance);
        company.visitor = body.beside(-0.9, 6, 6);
        company.exhibit.reset();
        if (what == 0) greet(body.avatar.manner);
        if (what == 1) company.exhibit = body.beside(0.8, 1.5, 1.2);
        if (what == 2) wave_to(body.beside(-0.7, 2, 1.6), body.avatar.manner);
      }
      const std::vector<Mat4> last = body.avatar.world;
      body.run(frame);
      if (i == 0) continue;  // it was set down elsewhere
      for (std::size_t j = 0; j < last.size(); ++j)
        worst = std::max(worst, glm::distance(Vec3(body.avatar.world[j][3]), Vec3(last[j][3])) /
                                    static_cast<float>(frame));
    }
  }
  EXPECT_LT(worst, 1.15F * quickest) << quickest;
}

TEST(Manner, WavesToSomeWhoPassAndNotToAllNorToTheSameTwice) {
  int waved = 0;
  constexpr int passers = 40;
  Body body;
  for (int i = 0; i < passers; ++i) {
    body.avatar.company.passer = body.beside(0.5, 2, 1.6);
    const double before = body.avatar.manner.waved;
    body.run(3);
    waved += body.avatar.manner.waved != before ? 1 : 0;
    body.avatar.company.passer.reset();
    body.run(25);
  }
  EXPECT_GT(waved, passers / 3);
  EXPECT_LT(waved, passers);
}

TEST(Manner, IsCalmWhereItIsToldToBe) {
  Body body;
  body.avatar.breathes = false;
  body.avatar.company = {.visitor = body.beside(0, 5, 5), .is_used = true, .calm = true};
  greet(body.avatar.manner);
  body.avatar.company.passer = body.beside(0.5, 2, 1.6);
  const std::vector<Mat4> before = body.avatar.world;
  body.run(20);
  EXPECT_EQ(body.avatar.world, before);
}

TEST(Manner, IsThatOfABodyWithoutArmsOrHead) {
  Museum bare = test::sample_museum();
  for (const BodyPart part : {BodyPart::LeftElbow, BodyPart::RightWrist, BodyPart::Head,
                              BodyPart::Neck, BodyPart::LeftKnee})
    bare.motion.skeleton.part[static_cast<std::size_t>(part)] = JointIndex::None;
  Avatar avatar = make_avatar(bare, 0, plan::make_standing(bare, bare.kiosk));
  avatar.company.visitor = avatar.company.exhibit = Vec3(1, 1, 1);
  greet(avatar.manner);
  for (int i = 0; i < 600; ++i) advance(bare, avatar, frame);
  for (const Mat4& joint : avatar.world) EXPECT_TRUE(std::isfinite(joint[3].x));
}

TEST(Manner, IsAsSmoothAfterAMonth) {
  Body young(3), old(3);
  for (int hour = 0; hour < 30 * 24; ++hour) advance(test::sample_museum(), old.avatar, 3600);
  const auto most_moved = [](Body& body) {
    float most = 0;
    for (int i = 0; i < 60 * 30; ++i) {
      const std::vector<Mat4> last = body.avatar.world;
      body.run(frame);
      for (std::size_t j = 0; j < last.size(); ++j)
        most = std::max(most, glm::distance(Vec3(body.avatar.world[j][3]), Vec3(last[j][3])));
    }
    return most;
  };
  young.run(5);
  old.run(5);
  const float first = most_moved(young), later = most_moved(old);
  EXPECT_GT(later, first / 3);
  EXPECT_LT(later, first * 3);
}

}  // namespace
}  // namespace docent::guide::manner_test
