#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <numbers>

#include "runtime/plan/plan.h"

namespace docent::plan::glide_test {
namespace {

constexpr std::array<Vec2, 3> corner{Vec2{0, 0}, Vec2{4, 0}, Vec2{4, 3}};
const Placement start{{0, 0}, 0};

double metres_along_corner(Vec2 p) {
  return std::abs(p.y) < 1e-9 ? p.x : 4 + p.y;
}

TEST(AGlide, ComesToTheEndOfItsPathAndFacesAsAsked) {
  const motion::Walk walk = glide(start, corner, std::numbers::pi);

  ASSERT_FALSE(walk.body.empty());
  EXPECT_NEAR(glm::distance(walk.body.back().position, corner.back()), 0, 1e-6);
  EXPECT_NEAR(std::remainder(walk.body.back().heading - std::numbers::pi, 2 * std::numbers::pi), 0,
              1e-6);
}

TEST(AGlide, StaysOnItsPathAndNeverGoesBack) {
  const motion::Walk walk = glide(start, corner, {});

  double before = 0;
  for (const Placement& body : walk.body) {
    const Vec2 p = body.position;
    EXPECT_TRUE(std::abs(p.y) < 1e-6 || std::abs(p.x - 4) < 1e-6) << p.x << ", " << p.y;
    EXPECT_GE(metres_along_corner(p), before - 1e-9);
    before = metres_along_corner(p);
  }
}

TEST(AGlide, IsNoQuickerThanAComfortableWalk) {
  const motion::Walk walk = glide(start, corner, {});

  constexpr double comfortable = 1.3;  // metres a second
  for (std::size_t f = 1; f < walk.body.size(); ++f)
    EXPECT_LE(glm::distance(walk.body[f - 1].position, walk.body[f].position) * walk.frame_rate,
              comfortable + 1e-6);
}

TEST(AGlide, OfNoWayAtAllStandsWhereItIs) {
  const motion::Walk walk = glide(start, {}, {});

  ASSERT_FALSE(walk.body.empty());
  for (const Placement& body : walk.body) EXPECT_EQ(body.position, start.position);
}

}  // namespace
}  // namespace docent::plan::glide_test
