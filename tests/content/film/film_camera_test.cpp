#include "content/film/film_camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace docent::film::film_camera_test {
namespace {

/// A square room about the origin.
FloorPlan room(double half_side) {
  FloorPlan plan;
  plan.vertex = {{-half_side, -half_side},
                 {half_side, -half_side},
                 {half_side, half_side},
                 {-half_side, half_side}};
  plan.next = {1, 2, 3, 0};
  return plan;
}

TEST(FilmCamera, LooksWhereItsNameSays) {
  EXPECT_DOUBLE_EQ(camera_yaw(View::Back, 1), 1);
  EXPECT_NEAR(std::cos(camera_yaw(View::Front, 1) - 1), -1, 1e-12);
  EXPECT_NEAR(std::cos(camera_yaw(View::Side, 1) - 1), 0, 1e-12);
  EXPECT_GT(camera_pitch(View::Above, room(9), {}, 0), 1.2);
}

TEST(FilmCamera, StaysLevelInALargeRoomAndRisesOverAWallThatWouldHideTheFeet) {
  const double free = camera_pitch(View::Back, room(9), {}, 0);
  const double walled = camera_pitch(View::Back, room(2), {}, 0);

  EXPECT_LT(free, 0.2);
  EXPECT_GE(std::tan(walled) * 2, 1.45 - 1e-9);  // over the wall's edge one sees the floor at 0, 0
  EXPECT_LT(walled, 1);
}

TEST(FilmCamera, NeverLooksStraightDownForAWallHoweverNear) {
  EXPECT_LE(camera_pitch(View::Back, room(0.01), {}, 0), 1.11);
}

}  // namespace
}  // namespace docent::film::film_camera_test
