#include "content/gait/footsteps.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace docent::gait::footsteps_test {
namespace {

GaitPlan some_walk() {
  return {.speed = *rc::gen::inRange(80, 135) * 0.01,
          .turn = *rc::gen::inRange(-90, 91) * std::numbers::pi / 180,
          .turn_speed = *rc::gen::inRange(80, 100) * 0.01,
          .turn_length = *rc::gen::inRange(12, 25) * 0.1,
          .first = *rc::gen::element(Side::Left, Side::Right),
          .seed = *rc::gen::inRange(0U, 1000U)};
}

RC_GTEST_PROP(Footsteps, TakeTurnsAndOverlapInDoubleSupport, ()) {
  const std::vector<Footstep> steps = plan_footsteps(some_walk());

  for (std::size_t k = 0; k + 2 < steps.size(); ++k) {
    RC_ASSERT(steps[k + 1].foot == other(steps[k].foot));
    RC_ASSERT(steps[k].strike < steps[k + 1].strike);
    RC_ASSERT(steps[k].toe_off > steps[k + 1].strike);
    RC_ASSERT(steps[k].toe_off < steps[k + 2].strike);
  }
}

RC_GTEST_PROP(Footsteps, FollowFromTheSeedAlone, ()) {
  const GaitPlan plan = some_walk();
  GaitPlan another = plan;
  ++another.seed;
  const std::vector<Footstep> once = plan_footsteps(plan);
  const std::vector<Footstep> again = plan_footsteps(plan);
  const std::vector<Footstep> different = plan_footsteps(another);

  for (std::size_t k = 0; k < once.size(); ++k) {
    RC_ASSERT(once[k].ankle == again[k].ankle);
    RC_ASSERT(once[k].strike == again[k].strike);
  }
  RC_ASSERT(once.front().ankle != different.front().ankle);
}

TEST(Footsteps, KeepTheSpeedThatIsAskedFor) {
  const std::vector<Footstep> steps = plan_footsteps({.speed = 1.2, .seed = 4});

  const Footstep& first = steps.front();
  const Footstep& last = steps.back();
  EXPECT_NEAR(glm::length(last.ankle - first.ankle) / (last.strike - first.strike), 1.2, 0.02);
}

TEST(Footsteps, AreShorterOnTheInsideOfABend) {
  const GaitPlan plan{.turn = std::numbers::pi / 2, .turn_length = 2.0, .seed = 7};
  const std::vector<Footstep> steps = plan_footsteps(plan);
  double inner = 0;
  double outer = 0;
  ASSERT_EQ(steps.size() % 2, 1U);
  for (std::size_t k = 3; k < steps.size(); ++k)  // As many strides of either foot.
    (steps[k].foot == Side::Left ? inner : outer) +=
        glm::length(steps[k].ankle - steps[k - 2].ankle);

  // A quarter turn on a track 11 cm wide.
  EXPECT_NEAR(outer - inner, 0.11 * std::numbers::pi / 2, 0.06);
}

TEST(Footsteps, EndSideBySide) {
  const std::vector<Footstep> steps = plan_footsteps({.kind = GaitPlan::Kind::ToStanding});

  const GroundPoint apart = steps.back().ankle - steps[steps.size() - 2].ankle;
  EXPECT_NEAR(std::abs(apart.x), 0.155, 0.03);
  EXPECT_NEAR(apart.y, 0, 0.03);
}

}  // namespace
}  // namespace docent::gait::footsteps_test
