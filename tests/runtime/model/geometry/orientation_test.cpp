#include "runtime/model/geometry/orientation.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdint>

namespace docent::test::orientation_test {
namespace {

TEST(Orientation, SeesATurnFarBelowRounding) {
  const Vec2 a{0.5, 0.5}, b{12, 12};
  const double up = std::nextafter(24.0, 25.0);

  EXPECT_EQ(orientation(a, b, {24, 24}), 0);
  EXPECT_EQ(orientation(a, b, {24, up}), 1);
  EXPECT_EQ(orientation(a, b, {up, 24}), -1);
}

RC_GTEST_PROP(Orientation, AgreesWithWholeNumbers, ()) {
  // Below 2^30 the products of whole numbers fit into 64 bits.
  const auto any = [] { return static_cast<std::int64_t>(*rc::gen::inRange(-1000000, 1000000)); };
  const std::int64_t ax = any(), ay = any(), bx = any(), by = any(), cx = any(), cy = any();
  const std::int64_t determinant = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
  const auto point = [](std::int64_t x, std::int64_t y) {
    return Vec2{static_cast<double>(x), static_cast<double>(y)};
  };

  RC_ASSERT(orientation(point(ax, ay), point(bx, by), point(cx, cy)) ==
            (determinant > 0) - (determinant < 0));
}

}  // namespace
}  // namespace docent::test::orientation_test
