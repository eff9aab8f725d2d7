#include "runtime/scene/camera.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <array>
#include <numbers>

namespace docent::scene::camera_test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr std::array<Vec2, 4> hall{{{0, 0}, {40, 0}, {40, 30}, {0, 30}}};

double number(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 1001) / 1000.0;
}

Rect any_free() {
  const bool landscape = *rc::gen::arbitrary<bool>();
  return landscape ? Rect{0.37F, 0, 0.63F, 1} : Rect{0, 0, 1, 0.56F};
}

TEST(Overview, ShowsTheWholeFloorInTheFreePartOfTheScreen) {
  EXPECT_TRUE(rc::check("every corner is in it", [] {
    const Rect free = any_free();
    const float aspect = free.height < 1 ? 9.0F / 16 : 16.0F / 9;
    const CameraView view = view_of(overview_of(hall, 0, number(-pi, pi), free, aspect), aspect);
    for (const Vec2 corner : hall) {
      const auto at = project(view, to_world(corner, 0));
      RC_ASSERT(at.has_value());
      RC_ASSERT(at->x >= free.x && at->x <= free.x + free.width);
      RC_ASSERT(at->y >= free.y && at->y <= free.y + free.height);
    }
  }));
}

/// How much of the free part the floor fills, in the direction in which it fills more; nothing
/// where a corner is not in it.
float filled_by(std::span<const Vec2> floor, double height, double yaw, const Rect& free,
                float aspect) {
  const CameraView view = view_of(overview_of(floor, height, yaw, free, aspect), aspect);
  Vec2 low{1, 1}, high{0, 0};
  for (const Vec2 corner : floor) {
    const auto at = project(view, to_world(corner, height));
    if (!at) return 0;
    low = glm::min(low, Vec2{at->x, at->y});
    high = glm::max(high, Vec2{at->x, at->y});
  }
  constexpr double slack = 1e-3;
  const bool is_in = low.x > free.x - slack && low.y > free.y - slack &&
                     high.x < free.x + free.width + slack && high.y < free.y + free.height + slack;
  if (!is_in) return 0;
  return static_cast<float>(
      std::max((high.x - low.x) / free.width, (high.y - low.y) / free.height));
}

TEST(Overview, ShowsBuildingsUpToAKilometreAsLargeAsFits) {
  EXPECT_TRUE(rc::check("all of the floor, and not much air", [] {
    const double size = *rc::gen::element(30.0, 190.0, 200.0, 400.0, 1000.0);
    const double depth = size * number(0.1, 1), height = number(-8, 60);
    const Vec2 origin{number(-2000, 2000), number(-2000, 2000)};
    const bool turned = *rc::gen::arbitrary<bool>();
    const double x = turned ? depth : size, y = turned ? size : depth;
    const std::array<Vec2, 4> floor{origin, origin + Vec2{x, 0}, origin + Vec2{x, y},
                                    origin + Vec2{0, y}};
    const Rect free = any_free();
    const float aspect = free.height < 1 ? 9.0F / 16 : 16.0F / 9;

    RC_ASSERT(filled_by(floor, height, number(-pi, pi), free, aspect) > 0.8F);
  }));
}

TEST(Overview, HasWhatTheVisitorFacesAtTheTop) {
  const Rect free{0, 0, 1, 1};
  const CameraView view = view_of(overview_of(hall, 0, pi / 2, free, 1.5F), 1.5F);

  const auto south = project(view, to_world({20, 2})), north = project(view, to_world({20, 28}));
  const auto west = project(view, to_world({2, 15})), east = project(view, to_world({38, 15}));

  EXPECT_GT(south->y, north->y);
  EXPECT_LT(west->x, east->x);
}

TEST(WalkingCamera, KeepsTheNextSixMetresInView) {
  EXPECT_TRUE(rc::check("a way that goes roughly ahead", [] {
    const Rect free = any_free();
    const float aspect = free.height < 1 ? 9.0F / 16 : 16.0F / 9;
    const Placement body{{number(0, 40), number(0, 30)}, number(-pi, pi)};
    std::array<Vec2, 6> ahead{};
    Vec2 at = body.position;
    double heading = body.heading;
    for (Vec2& point : ahead) {
      heading += number(-0.25, 0.25);
      at += Vec2{std::cos(heading), std::sin(heading)};
      point = at;
    }
    const Walker walker{body, 0, ahead};
    const double yaw = yaw_towards(walker, 0);

    const CameraRig rig = behind(walker, yaw, free, aspect);

    RC_ASSERT(rig.distance >= 8 && rig.distance <= 12.5);
    const CameraView view = view_of(rig, aspect);
    for (const Vec2 point : ahead) {
      const auto seen = project(view, to_world(point));
      RC_ASSERT(seen.has_value());
      RC_ASSERT(seen->x >= free.x && seen->x <= free.x + free.width);
      RC_ASSERT(seen->y >= free.y && seen->y <= free.y + free.height);
    }
  }));
}

TEST(Camera, IsAlwaysAboveEverythingThatItCouldRunInto) {
  EXPECT_TRUE(rc::check("walking, arriving and every moment between", [] {
    const Rect free = any_free();
    const Placement body{{number(0, 40), number(0, 30)}, number(-pi, pi)};
    const Vec2 exhibit = body.position + Vec2{number(-2, 2), number(-2, 2)};
    const CameraRig from = behind({body, 0, {}}, number(-pi, pi), free, 1.7F);
    const CameraRig to = beside(body.position, exhibit, number(-pi, pi), 0, free, 1.7F);
    RC_ASSERT(view_of(blend(from, to, number(0, 1)), 1.7F).eye.y > tallest_thing);
  }));
}

TEST(ArrivalCamera, ShowsTheExhibitInTheUpperThird) {
  const Rect free{0.37F, 0, 0.63F, 1};

  const CameraView view =
      view_of(beside({10, 10}, {11.4, 10}, arrival_turn, 0, free, 16.0F / 9), 16.0F / 9);

  const auto exhibit = project(view, to_world({11.4, 10}, 1.2));
  const auto feet = project(view, to_world({10, 10}));
  EXPECT_LT(exhibit->y, 0.36F);
  EXPECT_GT(exhibit->y, 0.15F);
  EXPECT_LT(feet->y, 0.95F);
}

TEST(Camera, TurnsByTheShorterWayAndNoFasterThanAllowed) {
  EXPECT_TRUE(rc::check("a step", [] {
    const double from = number(-pi, pi), to = number(-pi, pi);
    const double next = turn_smoothly(from, to, 1.0 / 60, 0.9, 0.8);
    RC_ASSERT(std::abs(wrapped(next - from)) <= 0.8 / 60 + 1e-9);
    RC_ASSERT(std::abs(wrapped(to - next)) <= std::abs(wrapped(to - from)) + 1e-9);
  }));
}

}  // namespace
}  // namespace docent::scene::camera_test
