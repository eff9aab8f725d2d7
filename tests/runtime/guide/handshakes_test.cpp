#include "runtime/guide/handshakes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "runtime/guide/guide.h"
#include "runtime/guide/stature.h"
#include "runtime/motion/arm.h"
#include "runtime/scene/look.h"
#include "tests/runtime/guide/simulated.h"
#include "tests/support/sample_as_read.h"

namespace docent::guide::handshakes_test {
namespace {

constexpr std::uint32_t seats = 2;

GuideSettings settings() {
  return {.shape = {.width = 1920, .height = 1080, .diagonal_inches = 55},
          .idle_reset = Seconds{300},
          .visitors = seats};
}

/// The middle of a right hand's palm, as the body is posed: half of the hand on from the wrist.
Vec3 palm(const Avatar& avatar) {
  const motion::Arm& arm = *avatar.limbs.arms[Side::Right];
  const Mat4& wrist = avatar.world[arm.joint[arm.wrist]];
  return Vec3(wrist[3]) +
         glm::mat3(wrist) * (arm.rest[2] * Vec3(0.5F * sign_of(arm.side) * arm.hand, 0, 0));
}

/// A shared glass with two visitors, each with a guide.
class TwoVisitors {
 public:
  explicit TwoVisitors(double rate = 60)
      : frame_(1 / rate),
        planner_(test::sample_museum(), {test::boxes, {}},
                 planner_size(test::sample_museum(), settings()).avatars,
                 planner_size(test::sample_museum(), settings()).parts),
        guide_(test::sample_museum(), planner_, settings()) {
    run(0.5);
    sit_down(1, 0);
    sit_down(2, 4);
    run(4);  // greetings
  }

  template <typename Each>
  void run(double seconds, Each each) {
    for (long i = 0; i < std::lround(seconds / frame_); ++i) {
      planner_.wait();
      guide_.step(Seconds{static_cast<float>(frame_)});
      while (guide_.take_pieces() != nullptr) continue;
      guide_.draw_list();
      each();
    }
  }
  void run(double seconds) {
    run(seconds, [] {});
  }
  /// Runs until something is so, for so many seconds at most. False where it never was.
  template <typename Is>
  bool run_until(double most, Is is) {
    for (double seconds = 0; seconds < most && !is(); seconds += frame_) run(frame_);
    return is();
  }
  void tap(float x, float y) {
    guide_.touch({.kind = input::InputEvent::Kind::Down, .contact = {1, x, y}});
    run(0.05);
    guide_.touch({.kind = input::InputEvent::Kind::Up, .contact = {1, x, y}});
    run(0.05);
  }
  void tap(std::uint32_t seat, std::string_view name) {
    const auto& controls = guide_.view(guide_.part_of(seat))->controls;
    const auto it = std::ranges::find(controls, name, &interface::Control::name);
    ASSERT_NE(it, controls.end()) << name;
    tap(it->rect.x + it->rect.width / 2, it->rect.y + it->rect.height / 2);
  }
  /// The first exhibit on a card's page of the list.
  void choose(std::uint32_t seat) {
    for (const interface::Control& control : guide_.view(guide_.part_of(seat))->controls)
      if (control.name.starts_with("exhibit:") && control.rect.width > 0)
        return tap(seat, control.name);
    FAIL() << "no exhibit";
  }
  void sit_down(std::uint32_t seat, std::uint32_t look) {
    tap((static_cast<float>(seat) - 0.5F) / seats, 0.95F);
    tap(seat, "look:" + std::string(scene::looks[look].name));
  }
  /// The visitor at a seat touches a guide on the model, half way up.
  void touch_guide(std::uint32_t seat, std::uint32_t who) {
    tap((static_cast<float>(seat) - 0.5F) / seats, 0.99F);  // their card: they stand there
    const Avatar& it = guide_.crowd()[who].avatar;
    const Vec3 ground = to_world(it.body.position, it.height + 0.4);
    const auto at = scene::project(guide_.draw_list().camera, ground);
    ASSERT_TRUE(at);
    tap(at->x, at->y);
  }
  /// Where that palm is drawn, metres of life: bodies are drawn larger from where they stand, and
  /// those of different people are differently tall.
  Vec3 drawn_palm(std::uint32_t who) {
    const Avatar& it = avatar(who);
    const Vec3 ground = to_world(it.body.position, it.height);
    const float scale = stature_scale(guide_.draw_list().camera, settings().shape, ground);
    const float build = scene::looks[it.look].height;
    largest_ = std::max(largest_, scale);
    return ground + scale * Vec3{1, build, 1} * (palm(it) - ground);
  }
  float largest() const { return largest_; }
  bool both_hold() { return holds(avatar(0).manner) && holds(avatar(4).manner); }
  /// Does any card say that the goal is nearly reached?
  bool says_nearly_there() const {
    const std::string_view words = interface::word(guide_.museum(), 0, "nearly_there");
    return std::ranges::any_of(guide_.on_glass(),
                               [&](const auto& item) { return item.label == words; });
  }
  const Avatar& avatar(std::uint32_t who) { return guide_.crowd()[who].avatar; }
  Guide& guide() { return guide_; }
  double frame() const { return frame_; }

 private:
  double frame_;
  plan::Planner planner_;
  Guide guide_;
  float largest_ = 1;
};

class AHandshake : public ::testing::TestWithParam<int> {};

TEST_P(AHandshake, IsOfHandsThatMeetOverFeetThatStay) {
  TwoVisitors two(GetParam());
  const std::array before{two.avatar(0).body, two.avatar(4).body};

  two.touch_guide(1, 4);
  double together = 0, longest = 0;
  float slid = 0;
  std::array<Vec3, 4> foot{};
  bool stood = false;
  two.run(30, [&] {
    const bool hold = holds(two.avatar(0).manner) && holds(two.avatar(4).manner);
    const float apart = glm::distance(two.drawn_palm(0), two.drawn_palm(4));
    together = hold && apart < 0.01F ? together + two.frame() : 0;
    longest = std::max(longest, together);
    if (hold) {
      EXPECT_EQ(two.guide().state_of(0), AvatarState::Gesture);
      EXPECT_EQ(two.guide().state_of(4), AvatarState::Gesture);
      const Skeleton& skeleton = two.guide().museum().motion.skeleton;
      std::size_t f = 0;
      for (const std::uint32_t who : {0U, 4U})
        for (const BodyPart part : {BodyPart::LeftToe, BodyPart::RightToe}) {
          const Vec3 at = Vec3(two.avatar(who).world[index_of(skeleton[part])][3]);
          if (stood) slid = std::max(slid, glm::distance(at, foot[f]));
          if (!stood) foot[f] = at;
          ++f;
        }
    }
    stood = hold;
  });

  EXPECT_GT(longest, 0.6) << "seconds together";
  EXPECT_LT(slid, 0.005F);
  EXPECT_EQ(two.guide().counters().collisions, 0U);
  // Both have gone back to where they waited.
  EXPECT_LT(glm::distance(two.avatar(0).body.position, before[0].position), 0.05);
  EXPECT_LT(glm::distance(two.avatar(4).body.position, before[1].position), 0.05);
  EXPECT_FALSE(holds(two.avatar(0).manner));
}
INSTANTIATE_TEST_SUITE_P(AtAnyFrameRate, AHandshake, ::testing::Values(30, 60, 120));

TEST(Handshakes, WaitForTheVisitorWhoseGuideLeadsThemSomewhere) {
  TwoVisitors two;
  two.choose(2);
  two.run(1.5);
  ASSERT_TRUE(two.guide().state_of(4) == AvatarState::Walk ||
              two.guide().state_of(4) == AvatarState::Turn);

  two.touch_guide(1, 4);
  two.run(0.3);
  EXPECT_EQ(two.guide().state_of(0), AvatarState::Gesture);  // it waves
  EXPECT_FALSE(holds(two.avatar(0).manner));
  two.touch_guide(2, 0);
  bool has_shaken = false;
  two.run(40, [&] { has_shaken |= holds(two.avatar(0).manner) && holds(two.avatar(4).manner); });

  EXPECT_TRUE(has_shaken);
  two.run(60);
  EXPECT_TRUE(two.guide().state(two.guide().part_of(2)).arrived);  // and it went on
}

TEST(Handshakes, AreGivenUpByWhoIsToldSomethingElse) {
  TwoVisitors two;
  two.touch_guide(1, 4);
  two.run(0.5);
  two.choose(2);
  bool has_shaken = false;
  two.run(60, [&] { has_shaken |= holds(two.avatar(0).manner); });

  EXPECT_FALSE(has_shaken);
  EXPECT_TRUE(two.guide().state(two.guide().part_of(2)).arrived);
  EXPECT_FALSE(holds(two.avatar(4).manner));
}

TEST(Handshakes, LeaveTheCardAtWhatIsLeftOfTheWay) {
  TwoVisitors two;
  two.choose(2);
  two.run(1.5);
  two.touch_guide(1, 4);
  two.touch_guide(2, 0);
  bool is_near = two.says_nearly_there();
  ASSERT_TRUE(
      two.run_until(40, [&] { return is_near |= two.says_nearly_there(), two.both_hold(); }));
  two.run(4, [&] { is_near |= two.says_nearly_there(); });  // and sets out again

  EXPECT_FALSE(is_near);
  EXPECT_TRUE(two.run_until(60, [&] { return two.says_nearly_there(); }));
}

TEST(Handshakes, AreNotWishedByWhoTakesTheSeatOfSomebodyWhoWishedOne) {
  TwoVisitors two;
  two.choose(2);
  two.run(1.5);
  two.touch_guide(1, 4);
  two.tap(1, "home");
  two.run(1);
  two.sit_down(1, 2);
  two.choose(1);
  two.run(1.5);
  two.touch_guide(2, 2);
  bool has_shaken = false;
  two.run(60, [&] { has_shaken |= holds(two.avatar(2).manner) || holds(two.avatar(4).manner); });

  EXPECT_FALSE(has_shaken);
  EXPECT_TRUE(two.guide().state(two.guide().part_of(1)).arrived);
}

TEST(Handshakes, EndWhenAVisitorLeavesAndTheOtherGuideWalksOn) {
  TwoVisitors two;
  two.choose(2);
  two.run(1.5);
  two.touch_guide(1, 4);
  two.touch_guide(2, 0);
  ASSERT_TRUE(two.run_until(40, [&] { return two.both_hold(); }));
  two.tap(1, "home");
  two.run(1);

  EXPECT_FALSE(holds(two.avatar(0).manner));
  EXPECT_FALSE(holds(two.avatar(4).manner));
  EXPECT_TRUE(two.run_until(60, [&] { return two.guide().state(two.guide().part_of(2)).arrived; }));
  EXPECT_FALSE(holds(two.avatar(4).manner));
}

/// Two visitors' guides, three metres apart and face to face, and a body that makes room for nobody
/// and is not there yet.
class TwoGuides {
 public:
  static constexpr std::uint32_t obstinate = 2;

  TwoGuides() {
    for (const Placement& home : homes_) crowd_.add(museum_.kiosk_floor, home, 100, 1);
    crowd_.add(museum_.kiosk_floor, museum_.kiosk, 1e9, 1);
    crowd_.leave(obstinate);
    sessions_.reserve(3);
    sessions_.emplace_back(context_, 0, interface::InterfaceState{}, std::nullopt);
    for (const std::uint32_t k : {0U, 1U})
      sessions_.emplace_back(context_, k + 1, interface::InterfaceState{.seat = k + 1}, k);
    for (int frame = 0; frame < 30; ++frame) step();
  }
  ~TwoGuides() { planner_.wait(); }  // till then the worker reads the plans in progress
  TwoGuides(const TwoGuides&) = delete;
  TwoGuides& operator=(const TwoGuides&) = delete;
  void step() {
    planner_.wait();
    handshakes_.step(1.0 / 60, sessions_, {{}, shape_}, planner_, crowd_);
    crowd_.step(1.0 / 60);
  }
  /// Where they will meet, as far as anybody knows.
  std::array<Placement, 2> meeting_place() const {
    return guide::meeting_place(*planner_.maps()[museum_.kiosk_floor], museum_.body_radius, 0.72,
                                {crowd_[0].avatar.body, crowd_[1].avatar.body}, {})
        .value();
  }
  void wish() { handshakes_.wish(1, 1, sessions_, {{}, shape_}, planner_, crowd_); }
  bool are_shaking_hands() const { return !handshakes_.all().empty(); }
  Session& session(std::uint32_t who) { return sessions_[1 + who]; }
  void appear(const Placement& place) { crowd_.appear(obstinate, museum_.kiosk_floor, place); }
  const Agent& operator[](std::uint32_t who) const { return crowd_[who]; }

 private:
  const Museum& museum_ = test::sample_museum();
  interface::ScreenShape shape_ = settings().shape;
  plan::Planner planner_{museum_, {test::boxes, {}}, 3, 3};
  Crowd crowd_{museum_, planner_};
  Vec2 ahead_{std::cos(museum_.kiosk.heading), std::sin(museum_.kiosk.heading)};
  std::vector<Placement> homes_{
      museum_.kiosk,
      {museum_.kiosk.position + 3.0 * ahead_, museum_.kiosk.heading + std::numbers::pi}};
  std::vector<ExhibitShape> shapes_ = exhibit_shapes(museum_);
  SessionContext context_{museum_, planner_, crowd_, shape_, homes_, shapes_};
  std::vector<Session> sessions_;
  Handshakes handshakes_{museum_};
};

TEST(Handshakes, AreNotHeldOutToAGuideWhoseMeetingPlaceSomebodyElseHas) {
  TwoGuides two;
  const Placement taken = two.meeting_place()[1];
  two.appear(taken);  // in the moment in which they agree on it
  two.wish();
  ASSERT_TRUE(two.are_shaking_hands());
  ASSERT_EQ(two[1].goal->position, taken.position);
  bool have_arrived = false, has_held = false;
  for (int frame = 0; frame < 40 * 60 && two.are_shaking_hands(); ++frame) {
    two.step();
    have_arrived |= two[0].has_arrived && two[1].has_arrived;
    has_held |= holds(two[0].avatar.manner) || holds(two[1].avatar.manner);
  }

  EXPECT_TRUE(have_arrived) << "one of them elsewhere, because it was held up";
  EXPECT_FALSE(two.are_shaking_hands());
  EXPECT_FALSE(has_held);
}

/// A guide that is just then touching what it shows is meeting, as far as its session goes.
TEST(Handshakes, WaitForWhoIsTouchingSomethingAndThenAreShaken) {
  TwoGuides two;
  const Placement stood = two[1].avatar.body;
  two.session(1).meet(
      {stood.position - 0.4 * Vec2{std::cos(stood.heading), std::sin(stood.heading)},
       stood.heading});
  two.wish();
  for (int frame = 0; frame < 5 * 60; ++frame) two.step();
  EXPECT_FALSE(two.are_shaking_hands());
  two.session(1).part();
  bool has_shaken = false;
  for (int frame = 0; frame < 45 * 60; ++frame) {
    two.step();
    has_shaken |= holds(two[0].avatar.manner) && holds(two[1].avatar.manner);
  }

  EXPECT_TRUE(has_shaken);
  EXPECT_FALSE(two.are_shaking_hands()) << "once is enough";
  EXPECT_LT(glm::distance(two[1].avatar.body.position, stood.position), 0.05)
      << "it goes back to where it stood, not to where it was asked";
}

TEST(MeetingPlace, IsFaceToFaceClearOfWallsAndOthersInTheSampleMuseum) {
  const Museum& museum = test::sample_museum();
  const path::FloorMap map(museum.floors[museum.kiosk_floor]);
  std::size_t found = 0;
  for (const Exhibit& a : museum.exhibits)
    for (const Exhibit& b : museum.exhibits) {
      if (&a == &b || a.floor != museum.kiosk_floor || b.floor != museum.kiosk_floor) continue;
      const std::array<Vec2, 1> other{0.5 * (a.viewing_point.position + b.viewing_point.position)};
      const auto it =
          meeting_place(map, museum.body_radius, 0.72, {a.viewing_point, b.viewing_point}, other);
      if (!it) continue;
      ++found;
      const Vec2 one = (*it)[0].position, two = (*it)[1].position;
      EXPECT_GT(glm::distance(one, two), 2 * museum.body_radius);
      EXPECT_LT(glm::distance(one, two), 1);
      EXPECT_TRUE(map.has_room(one, museum.body_radius) && map.has_room(two, museum.body_radius));
      for (const Vec2 place : {one, two})
        EXPECT_GT(glm::distance(place, other[0]), 2 * museum.body_radius);
      const Vec2 line = two - one;
      EXPECT_NEAR(
          std::remainder((*it)[0].heading - std::atan2(line.y, line.x), 2 * std::numbers::pi), 0,
          1e-6);
      EXPECT_NEAR(std::remainder((*it)[1].heading - (*it)[0].heading - std::numbers::pi,
                                 2 * std::numbers::pi),
                  0, 1e-6);
    }
  EXPECT_GT(found, 50U);
}

}  // namespace
}  // namespace docent::guide::handshakes_test
