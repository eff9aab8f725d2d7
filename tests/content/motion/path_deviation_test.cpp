#include "content/motion/path_deviation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "runtime/model/geometry/polyline.h"

namespace docent::test::path_deviation_test {
namespace {

constexpr double rate = 120, speed = 1.2;

/// A body that goes along the path and sways by 3 cm to both sides, or keeps `aside` metres away.
std::vector<Vec2> walked(const std::vector<Vec2>& path, double sway, Vec2 aside = {}) {
  std::vector<Vec2> roots;
  const double length = polyline_length(path);
  for (double along = 0; along < length; along += speed / rate)
    roots.push_back(point_along(path, along) + aside +
                    Vec2{0, sway * std::sin(2 * 3.14159265 * along / 0.7)});
  roots.push_back(path.back() + aside);
  return roots;
}

TEST(PathDeviation, OfABodyThatSwaysAboutThePathIsNearlyNone) {
  const std::vector<Vec2> path{{0, 0}, {6, 0}};

  const auto deviation = motion::offline::measure_deviation(walked(path, 0.03), rate, path);

  EXPECT_LT(deviation.mean, 0.005);
  EXPECT_NEAR(deviation.reached, 6, 1e-6);
}

TEST(PathDeviation, OfABodyBesideThePathIsHowFarItIsAway) {
  const std::vector<Vec2> path{{0, 0}, {6, 0}};

  const auto deviation = motion::offline::measure_deviation(walked(path, 0, {0, 0.2}), rate, path);

  EXPECT_NEAR(deviation.mean, 0.2, 1e-6);
  EXPECT_NEAR(deviation.largest, 0.2, 1e-6);
}

TEST(PathDeviation, ReachesTheEndOfAPathThatTurnsBackOverItself) {
  for (const double beside : {0.0, 0.02, 0.3}) {
    const std::vector<Vec2> path{{0, 0}, {6, 0}, {6, beside}, {0, beside}};
    for (const double sway : {0.0, 0.03}) {
      const auto deviation = motion::offline::measure_deviation(walked(path, sway), rate, path);
      EXPECT_NEAR(deviation.reached, 12 + beside, 1e-6) << beside << ' ' << sway;
      EXPECT_LT(deviation.mean, 0.01);
    }
  }
}

TEST(PathDeviation, OfABodyThatStopsHalfwayReachesHalf) {
  const std::vector<Vec2> path{{0, 0}, {6, 0}, {0, 0}};
  const std::vector<Vec2> half{{0, 0}, {6, 0}};

  EXPECT_NEAR(motion::offline::measure_deviation(walked(half, 0.03), rate, path).reached, 6, 0.05);
}

}  // namespace
}  // namespace docent::test::path_deviation_test
