#include "content/gait/balance.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace docent::gait::balance_test {
namespace {

RC_GTEST_PROP(BalancedMass, FallsAwayFromThePressureAsAPendulumDoes, ()) {
  constexpr double rate = 120;
  constexpr double omega_squared = 9.81 / 0.94;
  const double amplitude = *rc::gen::inRange(1, 30) * 0.01;
  const double beat = *rc::gen::inRange(10, 90) * 0.1;
  std::vector<GroundPoint> pressure;
  pressure.reserve(600);
  for (std::size_t f = 0; f < 600; ++f)
    pressure.emplace_back(amplitude * std::sin(beat * static_cast<double>(f) / rate), 0.0);

  const std::vector<GroundPoint> mass = balanced_mass(pressure, rate);

  for (std::size_t f = 200; f < 400; ++f) {
    const double acceleration = (mass[f + 1].x - 2 * mass[f].x + mass[f - 1].x) * rate * rate;
    RC_ASSERT(std::abs(acceleration - omega_squared * (mass[f].x - pressure[f].x)) <
              0.02 * amplitude * omega_squared);
  }
}

TEST(BalancedMass, StaysWhereThePressureStays) {
  const std::vector<GroundPoint> pressure(300, GroundPoint{0.3, -0.2});

  for (const GroundPoint& mass : balanced_mass(pressure, 120)) {
    EXPECT_NEAR(mass.x, 0.3, 1e-12);
    EXPECT_NEAR(mass.y, -0.2, 1e-12);
  }
}

TEST(Loading, GoesFromOneFootToTheOtherAndIsAlwaysWhole) {
  const GaitPlan plan{};
  const std::vector<Footstep> steps = plan_footsteps(plan);
  const FrameTimes times{.begin = -1, .rate = 120, .count = 240};
  const Loading loading = loading_of(steps, times);

  for (std::size_t f = 0; f < times.count; ++f)
    EXPECT_NEAR(loading.left[f] + loading.right[f], 1, 1e-12);
  EXPECT_GT(std::ranges::count(loading.left, 1.0), 60);
  EXPECT_GT(std::ranges::count(loading.right, 1.0), 60);
}

TEST(CentreOfPressure, ShiftsBackAndTowardsTheFirstFootBeforeItLeaves) {
  const GaitPlan plan{.kind = GaitPlan::Kind::FromStanding, .first = Side::Right};
  const std::vector<Footstep> steps = plan_footsteps(plan);
  const FrameTimes times{.begin = -0.1, .rate = 120, .count = 80};
  const std::vector<GroundPoint> pressure = centre_of_pressure(steps, times);

  const GroundPoint standing = pressure.front();
  const GroundPoint shifted = pressure[43];  // 0.26 s after the start.
  const GroundPoint on_left = pressure.back();
  EXPECT_LT(shifted.x, standing.x - 0.02) << "right is at negative x";
  EXPECT_LT(shifted.y, standing.y - 0.01);
  EXPECT_GT(on_left.x, standing.x + 0.05);
}

TEST(Smooth, KeepsStraightLinesStraightAwayFromTheEnds) {
  std::vector<double> line(200);
  std::iota(line.begin(), line.end(), 0.0);

  smooth(line, 120, 0.1);

  for (std::size_t f = 50; f < 150; ++f) EXPECT_NEAR(line[f], static_cast<double>(f), 1e-9);
}

}  // namespace
}  // namespace docent::gait::balance_test
