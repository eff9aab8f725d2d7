#include "runtime/path/offset/offset_curve.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/runtime/path/floors.h"

namespace docent::test {
namespace {

using std::numbers::pi;

path::OffsetCurve curve_at(const Floor& floor, double distance) {
  return path::offset_curve(path::MedialAxisMap(floor), distance);
}

TEST(OffsetCurve, RoundsTheCornersOfABoxAndKeepsThoseOfTheHall) {
  const Floor floor = floor_of(hall_with_a_box());

  const path::OffsetCurve curve = curve_at(floor, 1);

  EXPECT_EQ(curve.components, 1U);
  EXPECT_EQ(curve.holes, 1U);
  EXPECT_NEAR(curve.area, 10 * 6 - (4 + 4 * 2 + pi), 1e-9);
  EXPECT_NEAR(curve.perimeter, 2 * (10 + 6) + 4 * 2 + 2 * pi, 1e-9);
}

TEST(OffsetCurve, FallsApartWhereADoorIsTooNarrow) {
  const Floor floor = floor_of(two_rooms(1));

  EXPECT_EQ(curve_at(floor, 0.4).components, 1U);
  EXPECT_EQ(curve_at(floor, 0.6).components, 2U);
  EXPECT_EQ(curve_at(floor, 3).rings.size(), 0U);
}

TEST(OffsetCurve, IsTheWallsAtDistanceZero) {
  const Floor floor = floor_of(hall_with_a_box());

  const path::OffsetCurve curve = curve_at(floor, 0);

  EXPECT_NEAR(curve.area, 12 * 8 - 4, 1e-9);
  EXPECT_NEAR(curve.perimeter, 40 + 8, 1e-9);
}

RC_GTEST_PROP(OffsetCurve, LosesItsPerimeterInAreaAsTheDistanceGrows, ()) {
  const auto plan = random_hall();
  RC_PRE(plan.has_value());
  const Floor floor = floor_of(*plan);
  const path::MedialAxisMap map(floor);
  const double low = *rc::gen::inRange(1, 60) / 100.0, high = low + 0.5;

  // The coarea formula: the area between two distances is the integral of the lengths between.
  constexpr int steps = 400;
  double swept = 0;
  for (int i = 0; i < steps; ++i)
    swept += path::offset_curve(map, low + (i + 0.5) * (high - low) / steps).perimeter *
             (high - low) / steps;

  const double lost = path::offset_curve(map, low).area - path::offset_curve(map, high).area;
  RC_ASSERT(std::abs(swept - lost) < 2e-3 * (1 + lost));
}

}  // namespace
}  // namespace docent::test
