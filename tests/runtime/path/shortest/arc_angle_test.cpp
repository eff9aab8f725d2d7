#include "runtime/path/shortest/arc_angle.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

namespace docent::test::arc_angle_test {
namespace {

constexpr double pi = std::numbers::pi;

double between(double low, double high) {
  constexpr int steps = 1'000'000'000;
  return low + (high - low) * *rc::gen::inRange(0, steps + 1) / steps;
}
Vec2 unit_at(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

RC_GTEST_PROP(ArcAngle, TurnsADirectionAsCosineAndSineDo, ()) {
  const double begin = between(-pi, pi), angle = between(-pi / 2, 3 * pi / 2);
  const Vec2 turned = path::turned_by(unit_at(begin), angle);
  RC_ASSERT(std::abs(turned.x - std::cos(begin + angle)) <= 3e-15);
  RC_ASSERT(std::abs(turned.y - std::sin(begin + angle)) <= 3e-15);
}

RC_GTEST_PROP(ArcAngle, IsFoundAsTheArcTangentFindsIt, ()) {
  const double begin = between(-pi, pi), angle = between(-0.01, pi + 0.01);
  const double length = std::exp(between(-20, 20));
  RC_ASSERT(std::abs(path::angle_between(unit_at(begin), length * unit_at(begin + angle)) -
                     angle) <= 1e-14);
}

RC_GTEST_PROP(ArcAngle, OfASmallTurnIsRelativelyExact, ()) {
  const double angle = between(-0.42, 0.42) * std::exp(between(-30, 0));
  const path::SineVersine turn = path::of_small_angle(angle);
  const double half = std::sin(angle / 2);
  RC_ASSERT(std::abs(turn.sine - std::sin(angle)) <= 1e-15 * std::abs(angle));
  RC_ASSERT(std::abs(turn.versine - 2 * half * half) <= 1e-15 * angle * angle);
}

}  // namespace
}  // namespace docent::test::arc_angle_test
