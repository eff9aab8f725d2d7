#include "runtime/guide/touches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "content/compile/compile_touch.h"
#include "content/motion/find_touch.h"
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

/// The sample museum with a block in place of what stands on a pedestal, in the middle of it; or
/// with a picture on a wall that may be touched.
struct MuseumToTouch {
  Museum museum = test::sample_museum();
  std::uint32_t exhibit = 0;

  MuseumToTouch(Vec3 size, double base) {
    const auto stone = std::ranges::find(museum.exhibits, "boundary-stone", &Exhibit::id);
    exhibit = static_cast<std::uint32_t>(stone - museum.exhibits.begin());
    Exhibit& it = museum.exhibits[exhibit];
    for (Scenery& scenery : museum.scenery)
      std::erase_if(scenery.parts, [&](const SceneryPart& part) {
        return part.exhibit == static_cast<std::int32_t>(exhibit);
      });
    it.place = ExhibitPlace::ToTouch;
    it.object = static_cast<std::int32_t>(museum.objects.size());
    it.stand = {.position = it.placement.position, .base = base, .scale = 1};
    museum.objects.push_back(block(size));
    find();
  }
  MuseumToTouch() {
    const auto hung = std::ranges::find_if(museum.exhibits, [&](const Exhibit& one) {
      return one.place == ExhibitPlace::OnWall && one.floor == museum.kiosk_floor;
    });
    exhibit = static_cast<std::uint32_t>(hung - museum.exhibits.begin());
    hung->place = ExhibitPlace::OnWallToTouch;
    find();
  }
  void find() {
    Exhibit& it = museum.exhibits[exhibit];
    it.touches = compile::find_touches(museum, compile::standing_body(museum).value(), exhibit,
                                       path::FloorMap(museum.floors[it.floor]));
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

/// By how much an upper arm is raised, or turned, further than people's shoulders allow: radians.
float shoulder_hurts(const Avatar& avatar, const motion::Arm& arm) {
  namespace most = motion::arm_limits;
  constexpr float hangs = 0.35F;  // an arm that does may swing anywhere
  const auto place = [&](std::size_t joint) { return Vec3(avatar.world[arm.joint[joint]][3]); };
  const Quat trunk = glm::normalize(glm::quat_cast(avatar.world[index_of(arm.trunk)]));
  const Vec3 upper = glm::inverse(trunk) * glm::normalize(place(arm.elbow) - place(arm.shoulder));
  const float raised = std::acos(std::clamp(-upper.y, -1.0F, 1.0F));
  const float azimuth = std::atan2(sign_of(arm.side) * upper.x, upper.z);
  if (raised < hangs) return 0;
  const float aside = std::max(azimuth - most::outwards, -most::inwards - azimuth);
  return std::max(raised - most::elevation, std::min(aside, raised - most::extension));
}

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
  float deepest = -1, slid = 0, wrist = 0, elbow = 0, shoulder = 0;
  bool gestures = true;
};

Seen watch(Visit& visit, std::uint32_t exhibit) {
  const Museum& museum = visit.museum();
  const Exhibit& it = museum.exhibits[exhibit];
  const auto surface = motion::offline::touch_surface(museum, exhibit);
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
        if (it.object >= 0) seen.deepest = std::max(seen.deepest, depth_in(museum, it, point));
      toe[index_of(side)] = Vec3(visit.avatar().world[index_of(
          skeleton[side == Side::Left ? BodyPart::LeftToe : BodyPart::RightToe])][3]);
      const auto& held = manner.held[index_of(side)];
      if (!held) continue;
      if (held->since > motion::longest_change)
        seen.shoulder = std::max(seen.shoulder, shoulder_hurts(visit.avatar(), arm));
      const Vec3 upper = glm::normalize(elbow - shoulder), fore = glm::normalize(wrist - elbow);
      seen.elbow = std::max(seen.elbow, std::acos(std::clamp(glm::dot(upper, fore), -1.0F, 1.0F)));
      const Vec3 hand = glm::normalize(palm - wrist);
      seen.wrist = std::max(seen.wrist, std::acos(std::clamp(glm::dot(fore, hand), -1.0F, 1.0F)));
      together = motion::offline::distance_to(surface, palm) < motion::offline::touches_within
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
    EXPECT_LT(seen.shoulder, rounding);
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

TEST(Touches, AreOfWhatHangsOnAWallToo) {
  const MuseumToTouch hung;
  ASSERT_FALSE(hung.museum.exhibits[hung.exhibit].touches.empty());
  Visit visit(hung, 60);
  ASSERT_TRUE(visit.guide().state().arrived);

  const Seen seen = watch(visit, hung.exhibit);

  EXPECT_GT(seen.touched, 1.0);
  EXPECT_LT(seen.slid, 0.005F);
  EXPECT_LT(seen.shoulder, 1e-3F);
  EXPECT_EQ(visit.guide().counters().collisions, 0U);
}

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

TEST(Touches, FromOneSideOnlyAreShownFromThatSide) {
  for (const Side side : both_sides) {
    MuseumToTouch to_touch({0.45F, 1.0F, 0.4F}, 0.364);
    std::vector<Touch>& touches = to_touch.museum.exhibits[to_touch.exhibit].touches;
    ASSERT_EQ(touches.size(), 2U);
    std::erase_if(touches, [&](const Touch& touch) { return touch.beside != side; });
    Visit visit(to_touch, 60);
    ASSERT_TRUE(visit.guide().state().arrived);
    bool has_touched = false;
    visit.run(20, [&] { has_touched |= holds(visit.avatar().manner); });

    EXPECT_TRUE(has_touched) << "from the " << (side == Side::Left ? "left" : "right");
  }
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
        guide_(of.museum, planner_, settings_),
        exhibit_(of.exhibit) {
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
  /// Metres from the nearer hand, as it is drawn, to what is touched.
  float off_surface() {
    const Museum& museum = guide_.museum();
    const auto surface = motion::offline::touch_surface(museum, exhibit_);
    float least = 1e9F;
    for (const Side side : both_sides) {
      const motion::Arm& arm = *avatar().limbs.arms[side];
      const Mat4& wrist = avatar().world[arm.joint[arm.wrist]];
      const Vec3 ground = to_world(avatar().body.position, avatar().height);
      const Vec3 palm =
          Vec3(wrist[3]) +
          glm::mat3(wrist) * (arm.rest[2] * Vec3(0.5F * sign_of(side) * arm.hand, 0, 0));
      const Vec3 drawn =
          ground + size() * Vec3{1, scene::looks[avatar().look].height, 1} * (palm - ground);
      least = std::min(least, motion::offline::distance_to(surface, drawn));
    }
    return least;
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
  std::uint32_t exhibit_;
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
    touched += visit.off_surface() < motion::offline::touches_within ? 1.0 / 60 : 0;
    EXPECT_EQ(visit.count(scene::MarkerDraw::Kind::SelectedExhibit), 1);
  });

  EXPECT_GT(touched, 1) << "seconds, as it is drawn";
}

}  // namespace
}  // namespace docent::guide::touches_test
