#include "runtime/guide/touches.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "runtime/guide/guide.h"
#include "runtime/guide/stature.h"
#include "runtime/scene/look.h"
#include "tests/runtime/guide/simulated.h"
#include "tests/support/sample_as_read.h"

namespace docent::guide::touches_test {
namespace {

/// A block, as the compiler makes objects.
ExhibitObject block(Vec3 size) {
  ExhibitObject object{.name = "block", .size = size, .distant = {}, .detail = {}};
  constexpr std::uint16_t all = 65535;
  for (const std::uint16_t x : {std::uint16_t{0}, all})
    for (const std::uint16_t y : {std::uint16_t{0}, all})
      for (const std::uint16_t z : {std::uint16_t{0}, all})
        object.distant.vertices.push_back({.position = {x, y, z}});
  object.distant.triangles = {0, 1, 3, 0, 3, 2, 4, 6, 7, 4, 7, 5, 0, 4, 5, 0, 5, 1,
                              2, 3, 7, 2, 7, 6, 0, 2, 6, 0, 6, 4, 1, 5, 7, 1, 7, 3};
  return object;
}

/// The sample museum with a block in place of what stands on a pedestal, in the middle of it.
struct MuseumToTouch {
  Museum museum = test::sample_museum();
  std::uint32_t exhibit = 0;

  MuseumToTouch(Vec3 size, double base) {
    const auto stone = std::ranges::find(museum.exhibits, "boundary-stone", &Exhibit::id);
    exhibit = static_cast<std::uint32_t>(stone - museum.exhibits.begin());
    Exhibit& it = museum.exhibits[exhibit];
    for (Scenery& scenery : museum.scenery)
      for (SceneryPart& part : scenery.parts)
        if (part.exhibit == static_cast<std::int32_t>(exhibit)) part.exhibit = -1;
    it.place = ExhibitPlace::ToTouch;
    it.object = static_cast<std::int32_t>(museum.objects.size());
    it.stand = {.position = it.placement.position, .base = base, .scale = 1};
    museum.objects.push_back(block(size));
  }
};

/// One visitor and their guide, at some frames a second.
class Visit {
 public:
  Visit(const MuseumToTouch& of, double rate)
      : of_(of),
        frame_(1 / rate),
        planner_(of.museum, {test::boxes, {}}),
        guide_(of.museum, planner_,
               {.shape = {.width = 1920, .height = 1080}, .idle_reset = Seconds{300}}) {
    test::run(planner_, guide_, 0.2);
    test::tap(planner_, guide_, "begin");
    test::run(planner_, guide_, 1);
    test::tap(planner_, guide_, "exhibit:" + of.museum.exhibits[of.exhibit].id);
    for (int i = 0; i < 90 * 60 && !guide_.state().arrived; ++i)
      test::run(planner_, guide_, 1.0 / 60);
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
  const Avatar& avatar() const { return guide_.crowd()[0].avatar; }
  /// Where a joint is drawn: people are differently tall.
  Vec3 drawn(Vec3 place) const {
    const auto ground = static_cast<float>(avatar().height);
    return {place.x, ground + scene::looks[avatar().look].height * (place.y - ground), place.z};
  }
  Vec3 joint(std::uint32_t index) const { return drawn(Vec3(avatar().world[index][3])); }
  Vec3 palm(const motion::Arm& arm) const {
    const Mat4& wrist = avatar().world[arm.joint[arm.wrist]];
    return drawn(Vec3(wrist[3]) +
                 glm::mat3(wrist) *
                     (arm.rest[2] * Vec3(0.5F * sign_of(arm.side) * arm.hand, 0, 0)));
  }
  Guide& guide() { return guide_; }
  double frame() const { return frame_; }
  const Museum& museum() const { return of_.museum; }

 private:
  const MuseumToTouch& of_;
  double frame_;
  plan::Planner planner_;
  Guide guide_;
};

/// How deep a point is in the block.
float depth_in(const Museum& museum, const Exhibit& it, Vec3 point) {
  const Vec3 foot =
      to_world(it.stand.position, museum.floors[it.floor].plan.height + it.stand.base);
  const float turn = -static_cast<float>(it.placement.heading) - std::numbers::pi_v<float> / 2;
  const Vec3 at = glm::angleAxis(turn, Vec3(0, 1, 0)) * (point - foot);
  const Vec3 size = museum.objects[static_cast<std::size_t>(it.object)].size;
  return std::min({size.x / 2 - std::abs(at.x), size.z / 2 - std::abs(at.z), at.y, size.y - at.y});
}

struct Seen {
  double touched = 0;  ///< Seconds together.
  float deepest = -1, slid = 0, wrist = 0, elbow = 0;
  bool gestures = true;
};

Seen watch(Visit& visit, std::uint32_t exhibit) {
  const Museum& museum = visit.museum();
  const Exhibit& it = museum.exhibits[exhibit];
  const auto surface = motion::touch_surface(museum, exhibit);
  const Skeleton& skeleton = museum.motion.skeleton;
  Seen seen;
  double together = 0;
  std::optional<std::array<Vec3, 2>> foot;
  visit.run(30, [&] {
    const Manner& manner = visit.avatar().manner;
    std::array<Vec3, 2> toe;
    for (const Side side : both_sides) {
      const motion::Arm& arm = *visit.avatar().limbs.arms[side];
      const Vec3 palm = visit.palm(arm), elbow = visit.joint(arm.joint[arm.elbow]);
      const Vec3 wrist = visit.joint(arm.joint[arm.wrist]);
      const Vec3 shoulder = visit.joint(arm.joint[arm.shoulder]);
      for (const Vec3 point : {palm, elbow, wrist, shoulder, glm::mix(elbow, wrist, 0.5F)})
        seen.deepest = std::max(seen.deepest, depth_in(museum, it, point));
      toe[index_of(side)] = Vec3(visit.avatar().world[index_of(
          skeleton[side == Side::Left ? BodyPart::LeftToe : BodyPart::RightToe])][3]);
      if (!manner.held[index_of(side)]) continue;
      const Vec3 upper = glm::normalize(elbow - shoulder), fore = glm::normalize(wrist - elbow);
      seen.elbow = std::max(seen.elbow, std::acos(std::clamp(glm::dot(upper, fore), -1.0F, 1.0F)));
      const Vec3 hand = glm::normalize(palm - wrist);
      seen.wrist = std::max(seen.wrist, std::acos(std::clamp(glm::dot(fore, hand), -1.0F, 1.0F)));
      together = motion::distance_to(surface, palm) < motion::touches_within
                     ? together + visit.frame()
                     : 0;
      seen.touched = std::max(seen.touched, together);
      seen.gestures &= visit.guide().state_of(0) == AvatarState::Gesture;
    }
    if (holds(manner) && foot)
      for (std::size_t f = 0; f < 2; ++f)
        seen.slid = std::max(seen.slid, glm::distance(toe[f], (*foot)[f]));
    foot.reset();
    if (holds(manner)) foot = toe;
  });
  return seen;
}

class ATouch : public ::testing::TestWithParam<int> {};

TEST_P(ATouch, LaysAHandOnTheObjectOverFeetThatStayAndStepsBack) {
  const std::array<std::pair<Vec3, double>, 3> blocks{
      {{{0.3F, 0.35F, 0.3F}, 0.9}, {{0.45F, 1.0F, 0.4F}, 0.364}, {{0.4F, 1.3F, 0.5F}, 0.034}}};
  for (const auto& [size, base] : blocks) {
    const MuseumToTouch to_touch(size, base);
    Visit visit(to_touch, GetParam());
    ASSERT_TRUE(visit.guide().state().arrived);
    const Placement stood = visit.avatar().body;

    const Seen seen = watch(visit, to_touch.exhibit);

    EXPECT_GT(seen.touched, 1.0) << "seconds together, from " << base;
    EXPECT_LT(seen.deepest, 0.002F);
    EXPECT_LT(seen.slid, 0.005F);
    EXPECT_LT(seen.elbow, motion::arm_limits::flexion + 0.02F);
    constexpr float rounding = 1e-3F;
    EXPECT_LT(seen.wrist,
              rounding + std::hypot(motion::arm_limits::wrist_flexion, motion::arm_limits::ulnar));
    EXPECT_TRUE(seen.gestures);
    EXPECT_LT(glm::distance(visit.avatar().body.position, stood.position), 0.05);
    EXPECT_TRUE(visit.guide().state().arrived);
    EXPECT_EQ(visit.guide().counters().collisions, 0U);
    EXPECT_EQ(visit.guide().counters().routes, 1U);
  }
}
INSTANTIATE_TEST_SUITE_P(AtAnyFrameRate, ATouch, ::testing::Values(30, 60, 120));

TEST(Touches, AreGivenUpByWhoIsSentElsewhereMeanwhile) {
  const MuseumToTouch to_touch({0.45F, 1.0F, 0.4F}, 0.364);
  Visit visit(to_touch, 60);
  bool has_touched = false;
  for (int i = 0; i < 20 * 60 && !has_touched; ++i)
    visit.run(1.0 / 60, [&] { has_touched |= holds(visit.avatar().manner); });
  ASSERT_TRUE(has_touched);
  visit.run(1.5, [] {});
  visit.guide().touch(
      {.kind = input::InputEvent::Kind::KeyDown, .contact = {}, .key = input::Key::Back});
  visit.run(3, [] {});
  const auto& controls = visit.guide().view()->controls;
  const auto another = std::ranges::find_if(controls, [&](const interface::Control& control) {
    return control.name.starts_with("exhibit:") && control.rect.width > 0 &&
           control.name != "exhibit:" + to_touch.museum.exhibits[to_touch.exhibit].id;
  });
  ASSERT_NE(another, controls.end());
  const input::Contact finger{1, another->rect.x + another->rect.width / 2,
                              another->rect.y + another->rect.height / 2};
  for (const auto kind : {input::InputEvent::Kind::Down, input::InputEvent::Kind::Up}) {
    visit.guide().touch({.kind = kind, .contact = finger});
    visit.run(1.0 / 60, [] {});
  }
  visit.run(1, [] {});

  EXPECT_FALSE(holds(visit.avatar().manner));
  for (int i = 0; i < 90 && !visit.guide().state().arrived; ++i) visit.run(1, [] {});
  EXPECT_TRUE(visit.guide().state().arrived);
}

TEST(Touches, AreNotForWhatNobodyReaches) {
  const MuseumToTouch low({0.4F, 0.1F, 0.4F}, 0.364);
  Visit visit(low, 60);
  ASSERT_TRUE(visit.guide().state().arrived);

  const Seen seen = watch(visit, low.exhibit);

  EXPECT_EQ(seen.touched, 0);
}

TEST(Touches, LeaveTheWayAndTheGoalsLightAsTheyWere) {
  const MuseumToTouch to_touch({0.45F, 1.0F, 0.4F}, 0.364);
  Visit visit(to_touch, 60);
  visit.run(2, [] {});
  const scene::DrawList before = visit.guide().draw_list();
  ASSERT_EQ(before.ribbons.size(), 1U);
  ASSERT_GT(before.goal_radius, 0);
  bool has_touched = false;
  visit.run(30, [&] {
    has_touched |= holds(visit.avatar().manner);
    const scene::DrawList& now = visit.guide().draw_list();
    ASSERT_EQ(now.ribbons.size(), 1U);
    EXPECT_EQ(now.ribbons[0].revision, before.ribbons[0].revision);
    EXPECT_EQ(now.ribbons[0].count, before.ribbons[0].count);
    EXPECT_EQ(now.ribbons[0].walked, before.ribbons[0].walked);
    EXPECT_EQ(now.ribbons[0].flow, before.ribbons[0].flow);
    EXPECT_EQ(now.goal, before.goal);
    EXPECT_EQ(now.goal_radius, before.goal_radius);
  });

  EXPECT_TRUE(has_touched);
}

/// Two share a glass of so many inches. One of them is led to what may be touched.
class SharedVisit {
 public:
  SharedVisit(const MuseumToTouch& of, float inches)
      : settings_{.shape = {.width = 1920, .height = 1080, .diagonal_inches = inches},
                  .idle_reset = Seconds{300},
                  .visitors = 2},
        planner_(of.museum, {test::boxes, {}}, planner_size(of.museum, settings_).avatars,
                 planner_size(of.museum, settings_).parts),
        guide_(of.museum, planner_, settings_) {
    run(0.5, [] {});
    tap(0.25F, 0.95F);
    tap("look:" + std::string(scene::looks[0].name));
    run(3, [] {});
    tap("exhibit:" + of.museum.exhibits[of.exhibit].id);
    for (int i = 0; i < 90 && !has_arrived(); ++i) run(1, [] {});
  }
  template <typename Each>
  void run(double seconds, Each each) {
    for (long i = 0; i < std::lround(seconds * 60); ++i) {
      test::run(planner_, guide_, 1.0 / 60);
      each();
    }
  }
  bool has_arrived() const { return guide_.state(guide_.part_of(1)).arrived; }
  const Avatar& avatar() const { return guide_.crowd()[0].avatar; }
  /// How many times as large as life the guide is drawn.
  float size() {
    const Vec3 ground = to_world(avatar().body.position, avatar().height);
    return stature_scale(guide_.draw_list().camera, settings_.shape, ground);
  }
  /// The marks on the model that are this.
  std::ptrdiff_t count(scene::MarkerDraw::Kind kind) {
    return std::ranges::count(guide_.draw_list().markers, kind, &scene::MarkerDraw::kind);
  }

 private:
  void tap(float x, float y) {
    for (const auto kind : {input::InputEvent::Kind::Down, input::InputEvent::Kind::Up}) {
      guide_.touch({.kind = kind, .contact = {1, x, y}});
      run(0.05, [] {});
    }
  }
  void tap(const std::string& name) {
    const auto& controls = guide_.view(guide_.part_of(1))->controls;
    const auto it = std::ranges::find(controls, name, &interface::Control::name);
    ASSERT_NE(it, controls.end()) << name;
    tap(it->rect.x + it->rect.width / 2, it->rect.y + it->rect.height / 2);
  }

  GuideSettings settings_;
  plan::Planner planner_;
  Guide guide_;
};

TEST(Touches, AreOnlyShownByWhoIsDrawnLargerThanLife) {
  const MuseumToTouch to_touch({0.45F, 1.0F, 0.4F}, 0.364);
  SharedVisit visit(to_touch, 55);
  ASSERT_TRUE(visit.has_arrived());
  ASSERT_GT(visit.size(), 1.5F);
  const Placement stood = visit.avatar().body;
  bool points = false;
  visit.run(30, [&] {
    points |= visit.avatar().manner.gesture == motion::Gesture::Point;
    EXPECT_LT(glm::distance(visit.avatar().body.position, stood.position), 0.05);
    EXPECT_FALSE(holds(visit.avatar().manner));
  });

  EXPECT_TRUE(points);
}

TEST(Touches, AreOnASharedGlassWhereBodiesAreAsLargeAsLife) {
  const MuseumToTouch to_touch({0.45F, 1.0F, 0.4F}, 0.364);
  SharedVisit visit(to_touch, 160);
  ASSERT_TRUE(visit.has_arrived());
  ASSERT_LT(visit.size(), 1.01F);
  double touched = 0;
  visit.run(30, [&] {
    touched += holds(visit.avatar().manner) ? 1.0 / 60 : 0;
    EXPECT_EQ(visit.count(scene::MarkerDraw::Kind::SelectedExhibit), 1);
  });

  EXPECT_GT(touched, 3);
}

/// Whatever stands on a plinth of any height: either there is no touch, or the hand of somebody who
/// stands clear of the plinth is on the surface, and their arm nowhere in it.
RC_GTEST_PROP(FindTouch, ReachesTheSurfaceOrSaysThatItDoesNot, ()) {
  const Museum& museum = test::sample_museum();
  static const Avatar standing =
      make_avatar(museum, museum.kiosk_floor, plan::make_standing(museum, museum.kiosk));
  const auto metres = [](int least, int most) {
    return static_cast<float>(*rc::gen::inRange(least, most)) / 100;
  };
  const float wide = metres(8, 90), high = metres(5, 160), deep = metres(8, 90);
  const float base = metres(0, 180);
  const float half = std::max(wide, deep) / 2 + metres(2, 40);
  std::vector<motion::Triangle> surface;
  const ExhibitObject object = block({wide, high, deep});
  for (std::size_t i = 0; i < object.distant.triangles.size(); i += 3) {
    motion::Triangle triangle;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& p = object.distant.vertices[object.distant.triangles[i + k]].position;
      triangle[k] =
          Vec3(-wide / 2, base, -deep / 2) + Vec3(p[0], p[1], p[2]) / 65535.0F * object.size;
    }
    surface.push_back(triangle);
  }
  const motion::Stance stance = stance_of(museum.motion.skeleton, standing);
  const auto has_room = [&](Vec2 at) {
    const Vec2 limit{half, half};
    return glm::distance(at, glm::clamp(at, -limit, limit)) > museum.body_radius;
  };
  const motion::TouchSearch search{.skeleton = museum.motion.skeleton,
                                   .arms = standing.limbs.arms,
                                   .stance = stance,
                                   .surface = surface,
                                   .ground = 0,
                                   .view = {{-2.5, 0}, 0},
                                   .middle = {},
                                   .has_room = has_room};
  for (const Side side : both_sides) {
    const auto touch = motion::find_touch(search, side);
    const bool is_easy = base + high > 1.0F && base < 1.1F &&
                         half - std::max(wide, deep) / 2 < 0.1F &&
                         std::min(wide, deep) > 0.7F * std::max(wide, deep);
    if (is_easy) RC_ASSERT(touch.has_value());
    RC_CLASSIFY(touch.has_value());
    if (!touch) continue;
    RC_ASSERT(has_room(touch->body.position));
    const motion::Arm& arm = *standing.limbs.arms[touch->side];
    const motion::Stance stands = motion::moved_to(stance, touch->body, 0);
    for (double at = motion::longest_change; at < motion::touch_seconds; at += 0.05) {
      const motion::JointPlace trunk =
          motion::leaned(stands, motion::lean_after(*touch, at)).trunk[index_of(touch->side)];
      const motion::ArmPosture posture =
          motion::holding(museum.motion.skeleton, arm, trunk, motion::grip_after(*touch, at));
      const motion::ArmPlaces held = motion::places_of(museum.motion.skeleton, arm, trunk, posture);
      const bool rests = at >= motion::touch_begins && at <= motion::touch_ends;
      if (rests) RC_ASSERT(motion::distance_to(surface, held.palm) < motion::touches_within);
      const Vec3 low(-wide / 2, base, -deep / 2), top = low + Vec3(wide, high, deep);
      for (const Vec3 p :
           {held.elbow, held.wrist, held.palm, held.tip, glm::mix(held.elbow, held.wrist, 0.5F)}) {
        const Vec3 in = glm::min(p - low, top - p);
        RC_ASSERT(std::min({in.x, in.y, in.z}) < 0.004F);
      }
    }
  }
}

}  // namespace
}  // namespace docent::guide::touches_test
