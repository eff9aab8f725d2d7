#include "runtime/scene/walking_camera.h"

#include <gtest/gtest.h>

#include <array>

#include "tests/runtime/scene/walk_in_halls.h"

namespace docent::scene::walking_camera_test {
namespace {

struct Scene {
  WalkInHall walk = any_walk_in_a_hall(26);
  Rect free = any_free();
  float aspect = aspect_of(free);
  std::vector<Vec2> ahead;
  std::array<Vec3, 2> goal{};

  Walker walker(double along) {
    ahead = walk.ahead(along);
    const Vec2 at = walk.at(along), on = walk.at(along + 0.1) - at;
    const bool is_near = walk.length() - along <= 12.8;
    goal = {to_world(walk.way.back()), to_world(walk.way.back(), 1.2)};
    return {{at, std::atan2(on.y, on.x)}, 0, ahead, std::span(goal).first(is_near ? 2 : 0)};
  }
};

/// Head, foot and the next metres; the goal once the walk's last twelve metres have begun.
void expect_in_view(const Walker& walker, const CameraRig& rig, const Rect& free, float aspect,
                    bool goal_is_due) {
  const CameraView view = view_of(rig, aspect);
  RC_ASSERT(is_in(free, project(view, to_world(walker.body.position))));
  RC_ASSERT(is_in(free, project(view, to_world(walker.body.position, 1.7))));
  for (const Vec2 p : walker.ahead) RC_ASSERT(is_in(free, project(view, to_world(p))));
  if (goal_is_due)
    for (const Vec3 p : walker.goal) RC_ASSERT(is_in(free, project(view, p)));
}

TEST(AWalkingCamera, ShowsGuideWayAndNearGoalAtOnceWhicheverWayItLooks) {
  EXPECT_TRUE(rc::check("in the free part of the picture", [] {
    Scene scene;
    const double along = number(0, scene.walk.length());
    const Walker walker = scene.walker(along);

    const CameraRig rig =
        behind(walker, number(-std::numbers::pi, std::numbers::pi), scene.free, scene.aspect);

    expect_in_view(walker, rig, scene.free, scene.aspect, true);
  }));
}

TEST(AWalkingCamera, ShowsAGoalThatIsFarBehindItOnAGlassThatStandsUpright) {
  const Rect free{0, 0, 1, 0.56F};
  constexpr float aspect = 9.0F / 16;
  std::vector<Vec2> ahead;
  for (double metre = 1; metre < 7; ++metre) ahead.push_back(metre * Vec2{0.69, 0.72});
  const std::array<Vec3, 2> goal{to_world({8.8, 9.2}), to_world({8.8, 9.2}, 1.2)};
  const Walker walker{{{0, 0}, 0.8}, 0, ahead, goal};

  const CameraView view = view_of(behind(walker, -3.07, free, aspect), aspect);

  for (const Vec3 p : {goal[0], goal[1], to_world({0, 0}), to_world({0, 0}, 1.7)})
    EXPECT_TRUE(is_in(free, project(view, p)));
  for (const Vec2 p : ahead) EXPECT_TRUE(is_in(free, project(view, to_world(p))));
}

TEST(AWalkingCamera, KeepsGuideWayAndNearGoalInThePictureAllAlongAWalk) {
  EXPECT_TRUE(rc::check("at every step", [] {
    Scene scene;
    WalkingCamera camera;
    camera.cut(scene.walker(0), scene.free, scene.aspect);
    constexpr double pace = 1.3 / 60;
    for (double along = 0; along < scene.walk.length(); along += pace) {
      const Walker walker = scene.walker(along);
      camera.advance(walker, scene.free, scene.aspect, 1.0F / 60);
      expect_in_view(walker, camera.rig(walker, scene.free), scene.free, scene.aspect,
                     scene.walk.length() - along <= 12);
    }
  }));
}

}  // namespace
}  // namespace docent::scene::walking_camera_test
