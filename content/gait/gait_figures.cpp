#include "content/gait/gait_figures.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace docent::gait {
namespace gait_figures {
namespace {

// Of healthy adults, from the sources in the header: degrees by share of the cycle (loading,
// release) or of swing (pitch). `rise` is in metres, of the walker of 1.70 m, by share of swing.
constexpr std::array<Knot, 15> loading{{{-0.22, 55},
                                        {-0.18, 46},
                                        {-0.14, 34},
                                        {-0.11, 24},
                                        {-0.08, 14.5},
                                        {-0.05, 7.5},
                                        {-0.02, 3.2},
                                        {0.00, 2.4},
                                        {0.03, 5.4},
                                        {0.07, 10.8},
                                        {0.11, 14.2},
                                        {0.14, 15},
                                        {0.20, 12},
                                        {0.30, 6},
                                        {0.42, 0}}};
constexpr std::array<Knot, 6> release{
    {{-0.22, 0}, {-0.16, 4}, {-0.11, 12}, {-0.06, 23}, {-0.02, 32}, {0.0, 36}}};
constexpr std::array<Knot, 5> pitch{{{0.12, -66}, {0.28, -51}, {0.46, -21}, {0.64, 2}, {0.84, 20}}};
constexpr std::array<Knot, 4> rise{{{0.16, 0.056}, {0.32, 0.066}, {0.56, 0.038}, {0.84, 0.080}}};

}  // namespace

double value_at(const Harmonics& curve, double cycle) noexcept {
  constexpr double turn = 2 * std::numbers::pi;
  return curve.mean + curve.a1 * std::cos(turn * (cycle - curve.p1)) +
         curve.a2 * std::cos(2 * turn * (cycle - curve.p2));
}

std::span<const Knot> knee_loading() noexcept {
  return loading;
}
std::span<const Knot> knee_release() noexcept {
  return release;
}
std::span<const Knot> swing_pitch() noexcept {
  return pitch;
}
std::span<const Knot> swing_ball_rise() noexcept {
  return rise;
}

}  // namespace gait_figures

double through(std::span<const gait_figures::Knot> knots, double at) noexcept {
  if (at <= knots.front().at) return knots.front().value;
  if (at >= knots.back().at) return knots.back().value;
  std::size_t k = 0;
  while (at > knots[k + 1].at) ++k;
  const auto slope = [&](std::size_t i) {
    return (knots[i + 1].value - knots[i].value) / (knots[i + 1].at - knots[i].at);
  };
  // The harmonic mean of the slopes on both sides keeps the curve between its knots.
  const auto tangent = [&](std::size_t i) {
    if (i == 0 || i + 1 == knots.size()) return 0.0;
    const double a = slope(i - 1);
    const double b = slope(i);
    return a * b <= 0 ? 0.0 : 2 * a * b / (a + b);
  };
  const double h = knots[k + 1].at - knots[k].at;
  const double t = (at - knots[k].at) / h;
  const double t2 = t * t;
  const double t3 = t2 * t;
  return (2 * t3 - 3 * t2 + 1) * knots[k].value + (t3 - 2 * t2 + t) * h * tangent(k) +
         (3 * t2 - 2 * t3) * knots[k + 1].value + (t3 - t2) * h * tangent(k + 1);
}

double spline(std::span<const gait_figures::Knot> knots, double first_slope, double last_slope,
              double at) {
  const std::size_t n = knots.size();
  // Slopes at the knots from the continuity of curvature: a tridiagonal system (Thomas).
  std::vector<double> slope(n), factor(n);
  slope.front() = first_slope;
  const auto h = [&](std::size_t k) { return knots[k + 1].at - knots[k].at; };
  const auto rise = [&](std::size_t k) { return (knots[k + 1].value - knots[k].value) / h(k); };
  for (std::size_t k = 1; k + 1 < n; ++k) {
    const double below = 1 / h(k - 1);
    const double above = 1 / h(k);
    const double right = 3 * (rise(k - 1) * below + rise(k) * above);
    const double pivot = 2 * (below + above) - below * factor[k - 1];
    factor[k] = above / pivot;
    slope[k] = (right - below * slope[k - 1]) / pivot;
  }
  slope.back() = last_slope;
  for (std::size_t k = n - 1; k-- > 1;) slope[k] -= factor[k] * slope[k + 1];

  std::size_t k = 0;
  while (k + 2 < n && at > knots[k + 1].at) ++k;
  const double t = std::clamp((at - knots[k].at) / h(k), 0.0, 1.0);
  const double t2 = t * t;
  const double t3 = t2 * t;
  return (2 * t3 - 3 * t2 + 1) * knots[k].value + (t3 - 2 * t2 + t) * h(k) * slope[k] +
         (3 * t2 - 2 * t3) * knots[k + 1].value + (t3 - t2) * h(k) * slope[k + 1];
}

double ease(double share) noexcept {
  const double t = std::clamp(share, 0.0, 1.0);
  return t * t * t * (10 + t * (6 * t - 15));
}

}  // namespace docent::gait
