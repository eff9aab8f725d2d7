#include "runtime/motion/smoothing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace docent {
namespace {

void normalise(std::vector<double>& kernel) {
  const double sum = std::accumulate(kernel.begin(), kernel.end(), 0.0);
  for (double& weight : kernel) weight /= sum;
}

}  // namespace

std::vector<double> gaussian_kernel(double deviation) {
  const auto radius = static_cast<std::size_t>(std::ceil(3 * std::max(deviation, 0.0)));
  std::vector<double> kernel(2 * radius + 1, 1.0);
  if (radius == 0) return kernel;
  for (std::size_t i = 0; i < kernel.size(); ++i) {
    const double x = (static_cast<double>(i) - static_cast<double>(radius)) / deviation;
    kernel[i] = std::exp(-0.5 * x * x);
  }
  normalise(kernel);
  return kernel;
}

std::vector<double> hann_kernel(std::size_t radius) {
  std::vector<double> kernel(2 * radius + 1, 1.0);
  for (std::size_t i = 0; i < kernel.size(); ++i)
    kernel[i] = 0.5 - 0.5 * std::cos(2 * std::numbers::pi * static_cast<double>(i + 1) /
                                     static_cast<double>(kernel.size() + 1));
  normalise(kernel);
  return kernel;
}

std::vector<double> smooth_held(std::span<const double> values, std::span<const double> kernel) {
  std::vector<double> out(values.size());
  const auto count = static_cast<std::ptrdiff_t>(values.size());
  const auto radius = static_cast<std::ptrdiff_t>(kernel.size() / 2);
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    double sum = 0;
    for (std::ptrdiff_t k = -radius; k <= radius; ++k)
      sum += kernel[static_cast<std::size_t>(k + radius)] *
             values[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i + k, 0, count - 1))];
    out[static_cast<std::size_t>(i)] = sum;
  }
  return out;
}

std::vector<Vec2> smooth_pinned(std::span<const Vec2> points, std::span<const double> kernel) {
  const auto last = static_cast<std::ptrdiff_t>(points.size()) - 1;
  const auto at = [&](std::ptrdiff_t i) { return points[static_cast<std::size_t>(i)]; };
  const auto beyond = [&](std::ptrdiff_t i) {
    if (i < 0) return 2.0 * points.front() - at(std::min(-i, last));
    if (i > last) return 2.0 * points.back() - at(std::max<std::ptrdiff_t>(2 * last - i, 0));
    return at(i);
  };
  const auto radius = static_cast<std::ptrdiff_t>(kernel.size() / 2);
  std::vector<Vec2> out(points.size());
  for (std::ptrdiff_t i = 0; i <= last; ++i) {
    Vec2 sum{};
    for (std::ptrdiff_t k = -radius; k <= radius; ++k)
      sum += kernel[static_cast<std::size_t>(k + radius)] * beyond(i + k);
    out[static_cast<std::size_t>(i)] = sum;
  }
  return out;
}

double wrap_angle(double angle) noexcept {
  const double wrapped = std::remainder(angle, 2 * std::numbers::pi);
  return wrapped <= -std::numbers::pi ? wrapped + 2 * std::numbers::pi : wrapped;
}

void unwrap_angles(std::span<double> angles) noexcept {
  for (std::size_t i = 1; i < angles.size(); ++i)
    angles[i] = angles[i - 1] + wrap_angle(angles[i] - angles[i - 1]);
}

}  // namespace docent
