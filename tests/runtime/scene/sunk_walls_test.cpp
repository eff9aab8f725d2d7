#include "runtime/scene/sunk_walls.h"

#include <gtest/gtest.h>

#include <array>

#include "content/scenery/scenery.h"
#include "runtime/scene/walking_camera.h"
#include "tests/runtime/scene/walk_in_halls.h"
#include "tests/support/sanitized.h"

namespace docent::scene::sunk_walls_test {
namespace {

/// The walls as they are drawn: the content compiler's triangles, sunk as the shader sinks them.
class DrawnWalls {
 public:
  explicit DrawnWalls(const FloorPlan& plan)
      : scenery_(scenery::make_scenery(plan, {}, {}, {}, {.texel = 0.5})) {}

  bool hide(Vec3 point, Vec3 eye, const SunkWalls& walls) const {
    for (const SceneryPart& part : scenery_.parts) {
      if (part.surface != Surface::Plaster && part.surface != Surface::CutFace) continue;
      for (std::uint32_t i = 0; i + 2 < part.index_count; i += 3)
        if (is_between(part.first_index + i, point, eye, walls)) return true;
    }
    return false;
  }

 private:
  Vec3 corner(std::uint32_t index, const SunkWalls& walls) const {
    Vec3 p = scenery_.vertices[scenery_.indices[index]].position;
    p.y = std::min(p.y, static_cast<float>(walls.height_at(to_floor(p))));
    return p;
  }
  /// Möller and Trumbore 1997.
  bool is_between(std::uint32_t first, Vec3 point, Vec3 eye, const SunkWalls& walls) const {
    const Vec3 a = corner(first, walls), b = corner(first + 1, walls), c = corner(first + 2, walls);
    const Vec3 ray = eye - point, p = glm::cross(ray, c - a);
    const float det = glm::dot(b - a, p);
    if (std::abs(det) < 1e-9F) return false;
    const Vec3 t = point - a, q = glm::cross(t, b - a);
    const float u = glm::dot(t, p) / det, v = glm::dot(ray, q) / det;
    const float share = glm::dot(c - a, q) / det;
    return u >= 0 && v >= 0 && u + v <= 1 && share > 1e-4F && share < 1;
  }

  Scenery scenery_;
};

std::vector<Sight> sights_of(const Walker& walker) {
  std::vector<Sight> sights{{walker.body.position, 0.3}};
  for (const Vec2 p : walker.ahead) sights.push_back({p});
  for (const Vec3 p : walker.goal) sights.push_back({to_floor(p), 0.4});
  return sights;
}

bool sees_all(const Walker& walker, Vec3 eye, const DrawnWalls& drawn, const SunkWalls& walls) {
  const Vec2 off = to_floor(eye) - walker.body.position;
  const Vec2 aside = left_of(off) / glm::length(off) * 0.2;
  for (const double height : {0.05, 0.5, 1.0, 1.6})
    for (const double side : {-1.0, 0.0, 1.0})
      if (drawn.hide(to_world(walker.body.position + side * aside, height), eye, walls))
        return false;
  for (const Vec2 p : walker.ahead)
    if (drawn.hide(to_world(p, 0.01), eye, walls)) return false;
  for (const Vec3 p : walker.goal)
    if (drawn.hide(p + Vec3(0, 0.01F, 0), eye, walls)) return false;
  return true;
}

TEST(SunkWalls, HideNeitherTheGuideNorTheWayNorTheGoal) {
  EXPECT_TRUE(rc::check("from where the camera is at rest", [] {
    const WalkInHall walk = any_walk_in_a_hall(14);
    const DrawnWalls drawn(walk.plan);
    SunkWalls walls(walk.plan.vertex.size());
    walls.show(walk.plan);
    const double along = number(0, walk.length());
    const std::vector<Vec2> ahead = walk.ahead(along);
    const std::array<Vec3, 2> goal{to_world(walk.way.back()), to_world(walk.way.back(), 1.2)};
    const Walker walker{{walk.at(along), 0}, 0, ahead, goal};
    const Rect free = any_free();
    const CameraView view =
        view_of(behind(walker, number(-std::numbers::pi, std::numbers::pi), free, aspect_of(free)),
                aspect_of(free));

    walls.advance(walker.body.position, view.eye, sights_of(walker), -1);

    RC_ASSERT(sees_all(walker, view.eye, drawn, walls));
  }));
}

TEST(SunkWalls, AreDownBeforeTheGuideComesBehindThem) {
  NEEDS_SPEED();
  EXPECT_TRUE(rc::check("all along a walk", [] {
    const WalkInHall walk = any_walk_in_a_hall(14);
    const DrawnWalls drawn(walk.plan);
    SunkWalls walls(walk.plan.vertex.size());
    walls.show(walk.plan);
    const Rect free = any_free();
    WalkingCamera camera;
    constexpr double pace = 1.3 / 60;
    int steps = 0, hidden = 0;
    for (double along = 0; along < walk.length(); along += pace, ++steps) {
      const std::vector<Vec2> ahead = walk.ahead(along);
      const Vec2 at = walk.at(along), on = walk.at(along + 0.1) - at;
      const Walker walker{{at, std::atan2(on.y, on.x)}, 0, ahead};
      if (steps == 0) camera.cut(walker, free, aspect_of(free));
      camera.advance(walker, free, aspect_of(free), 1.0F / 60);
      const Vec3 eye = view_of(camera.rig(walker, free), aspect_of(free)).eye;
      walls.advance(at, eye, sights_of(walker), 1.0F / 60);
      // A second for those that stood there from the start, half of one where a bend shows them.
      if (steps < 60 || steps % 15 != 0) continue;
      const Walker guide_alone{walker.body, 0, {}};
      hidden = sees_all(guide_alone, eye, drawn, walls) ? 0 : hidden + 1;
      RC_ASSERT(hidden <= 2);
    }
  }));
}

TEST(SunkWalls, StandWhereTheyHideNothingAndRiseAgain) {
  test::HallMaker hall;
  hall.room({0, 0}, {20, 10}).block({4, 4.8}, {16, 5.1});
  SunkWalls walls(hall.plan.vertex.size());
  walls.show(hall.plan);
  EXPECT_FALSE(walls.levels().any);
  const Vec3 from_the_south = to_world({10, -3}, 9), from_the_north = to_world({10, 13}, 9);
  const std::array<Sight, 1> sight{{{{10, 5.6}, 0.3}}};

  walls.advance({10, 5.6}, from_the_north, sight, -1);
  EXPECT_NEAR(walls.height_at({10, 5}), cut_height, 0.01);
  walls.advance({10, 5.6}, from_the_south, sight, -1);
  EXPECT_NEAR(walls.height_at({10, 5}), sunk_height, 0.01);
  EXPECT_NEAR(walls.height_at({14, 5}), cut_height, 0.01);
  EXPECT_NEAR(walls.height_at({10, 10}), cut_height, 0.01);
  for (int i = 0; i < 120; ++i) walls.advance({10, 5.6}, from_the_south, {}, 1.0F / 60);
  EXPECT_FALSE(walls.levels().any);
}

TEST(SunkWalls, StandWhereTheWindowComesToWhateverHasSunkOnItsOtherSide) {
  test::HallMaker hall;
  hall.room({0, 0}, {200, 10}).block({1, 4.8}, {199, 5.1});
  SunkWalls walls(hall.plan.vertex.size());
  walls.show(hall.plan);
  for (double x = 10; x < 190; x += 0.5) {
    const std::array<Sight, 1> sight{{{{x, 5.6}, 0.3}}};
    walls.advance({x, 5.6}, to_world({x, -3}, 9), sight, 1.0F / 60);
    ASSERT_NEAR(walls.height_at({x + 10, 5}), cut_height, 1e-6) << x;
  }
}

}  // namespace
}  // namespace docent::scene::sunk_walls_test
