#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "content/gait/gait_figures.h"

namespace docent::gait::gait_figures_test {
namespace {

using gait_figures::Knot;

std::vector<Knot> some_knots() {
  const auto steps =
      *rc::gen::nonEmpty(rc::gen::container<std::vector<int>>(rc::gen::inRange(1, 50)));
  std::vector<Knot> knots{{0, 0}};
  for (const int step : steps)
    knots.push_back({knots.back().at + 0.02 * step, std::sin(1.7 * step) * step});
  return knots;
}

RC_GTEST_PROP(Curve, PassesThroughItsKnotsAndNeverBeyondThem, ()) {
  const std::vector<Knot> knots = some_knots();

  for (std::size_t k = 0; k + 1 < knots.size(); ++k) {
    RC_ASSERT(std::abs(through(knots, knots[k].at) - knots[k].value) < 1e-9);
    const double low = std::min(knots[k].value, knots[k + 1].value);
    const double high = std::max(knots[k].value, knots[k + 1].value);
    for (const double share : {0.1, 0.3, 0.5, 0.7, 0.9}) {
      const double value = through(knots, std::lerp(knots[k].at, knots[k + 1].at, share));
      RC_ASSERT(value >= low - 1e-9);
      RC_ASSERT(value <= high + 1e-9);
    }
  }
}

RC_GTEST_PROP(Spline, PassesThroughItsKnotsWithTheGivenEndSlopesAndNoKink, ()) {
  const std::vector<Knot> knots = some_knots();
  const double first = *rc::gen::inRange(-20, 20);
  const double last = *rc::gen::inRange(-20, 20);
  constexpr double h = 1e-7;
  const auto slope = [&](double from, double to) {
    return (spline(knots, first, last, to) - spline(knots, first, last, from)) / (to - from);
  };

  for (const Knot& knot : knots)
    RC_ASSERT(std::abs(spline(knots, first, last, knot.at) - knot.value) < 1e-7);
  const double end = knots.back().at;
  RC_ASSERT(std::abs(slope(0, h) - first) < 0.5);
  RC_ASSERT(std::abs(slope(end - h, end) - last) < 0.5);
  for (std::size_t k = 1; k + 1 < knots.size(); ++k)
    RC_ASSERT(std::abs(slope(knots[k].at - h, knots[k].at) - slope(knots[k].at, knots[k].at + h)) <
              1.0);
}

TEST(Ease, RisesFromNothingToOneWithoutAJolt) {
  EXPECT_DOUBLE_EQ(ease(-1), 0);
  EXPECT_DOUBLE_EQ(ease(0.5), 0.5);
  EXPECT_DOUBLE_EQ(ease(2), 1);
  EXPECT_NEAR(ease(0.01) / 0.01, 0, 0.002);
}

}  // namespace
}  // namespace docent::gait::gait_figures_test
