#include "runtime/scene/ribbon_mesh.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

namespace docent::scene::ribbon_mesh_test {
namespace {

struct Strip {
  std::vector<Vec2> rounded;
  std::vector<RibbonVertex> vertices;
  Strip() {
    rounded.reserve(1000);
    vertices.reserve(4000);
  }
};

Strip strip_along(std::span<const Vec2> points, double length) {
  Strip strip;
  append_ribbon(points, length, strip.rounded, strip.vertices);
  return strip;
}

double length_of(std::span<const Vec2> points) {
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
    sum += std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y);
  return sum;
}

Vec2 place_of(const RibbonVertex& v) {
  return {v.place[0], -v.place[1]};
}

TEST(Ribbon, OfAStraightWayIsARectangleWithRoomForItsRoundEnds) {
  const Vec2 way[] = {{1, 2}, {4, 2}};
  constexpr double half = ribbon_half_width + ribbon_rim;

  const Strip strip = strip_along(way, 3);

  ASSERT_EQ(strip.vertices.size(), 8U);
  EXPECT_NEAR(strip.vertices.front().place[0], 1 - half, 1e-6);
  EXPECT_NEAR(strip.vertices.front().ribbon[0], -half, 1e-6);
  EXPECT_NEAR(strip.vertices.back().place[0], 4 + half, 1e-6);
  EXPECT_NEAR(strip.vertices.back().ribbon[0], 3 + half, 1e-6);
  for (const RibbonVertex& v : strip.vertices) EXPECT_NEAR(std::abs(place_of(v).y - 2), half, 1e-6);
}

TEST(Ribbon, OfLessThanTwoDifferentPointsIsNothing) {
  const Vec2 same[] = {{1, 1}, {1, 1}, {1, 1}};

  EXPECT_TRUE(strip_along({}, 1).vertices.empty());
  EXPECT_TRUE(strip_along(std::span(same).first(1), 1).vertices.empty());
  EXPECT_TRUE(strip_along(same, 1).vertices.empty());
}

TEST(Ribbon, StopsWhereItsRoomEnds) {
  std::vector<Vec2> way;
  way.reserve(100);
  for (int i = 0; i < 100; ++i) way.push_back({i * 1.0, i % 2 * 1.0});
  std::vector<Vec2> rounded;
  rounded.reserve(2000);
  std::vector<RibbonVertex> vertices;
  vertices.reserve(50);

  EXPECT_EQ(append_ribbon(way, 140, rounded, vertices), 50U);
}

TEST(Ribbon, RoundsACornerWithinTheCornersOwnTriangle) {
  const Vec2 way[] = {{0, 0}, {3, 0}, {3, 3}};

  const Strip strip = strip_along(way, 6);

  double nearest = 1e9;
  for (const Vec2 p : strip.rounded) {
    nearest = std::min(nearest, std::hypot(p.x - 3, p.y));
    EXPECT_TRUE(p.x <= 3 + 1e-9 && p.y >= -1e-9);
  }
  EXPECT_GT(nearest, 0.03);
  EXPECT_LT(nearest, 0.15);
}

TEST(Ribbon, CountsMetresAlongFromZeroToTheWaysLength) {
  EXPECT_TRUE(rc::check("along grows from the start to the length that was given", [] {
    const auto steps = *rc::gen::container<std::vector<std::pair<int, int>>>(
        rc::gen::pair(rc::gen::inRange(-20, 20), rc::gen::inRange(-20, 20)));
    std::vector<Vec2> way{{0, 0}};
    for (const auto& [x, y] : steps) way.push_back(way.back() + Vec2(x, y) * 0.1);
    const double length = length_of(way);
    const Strip strip = strip_along(way, length);
    if (strip.vertices.empty()) {
      RC_ASSERT(length < 1e-3 || strip.rounded.size() < 2);
      return;
    }
    constexpr double cap = ribbon_half_width + ribbon_rim;
    RC_ASSERT(std::abs(strip.vertices.front().ribbon[0] + cap) < 1e-4);
    RC_ASSERT(std::abs(strip.vertices.back().ribbon[0] - length - cap) < 1e-3 + 1e-4 * length);
    for (std::size_t i = 2; i < strip.vertices.size(); i += 2)
      RC_ASSERT(strip.vertices[i].ribbon[0] >= strip.vertices[i - 2].ribbon[0] - 1e-4F);
  }));
}

TEST(Ribbon, NeverReachesFurtherFromTheWayThanItsMitreAllows) {
  EXPECT_TRUE(rc::check("every vertex lies near the rounded way", [] {
    const auto steps = *rc::gen::container<std::vector<std::pair<int, int>>>(
        rc::gen::pair(rc::gen::inRange(-9, 9), rc::gen::inRange(-9, 9)));
    std::vector<Vec2> way{{0, 0}};
    for (const auto& [x, y] : steps) way.push_back(way.back() + Vec2(x, y) * 0.2);
    const Strip strip = strip_along(way, length_of(way));
    constexpr double half = ribbon_half_width + ribbon_rim;
    for (const RibbonVertex& v : strip.vertices) {
      double nearest = 1e9;
      for (const Vec2 p : strip.rounded)
        nearest = std::min(nearest, std::hypot(place_of(v).x - p.x, place_of(v).y - p.y));
      RC_ASSERT(nearest < half * 1.65);
    }
  }));
}

}  // namespace
}  // namespace docent::scene::ribbon_mesh_test
