#include "runtime/motion/smoothing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace docent::motion {
namespace {

void normalise(std::vector<double>& kernel) {
  const double sum = std::accumulate(kernel.begin(), kernel.end(), 0.0);
  for (double& weight : kernel) weight /= sum;
}

/// Values that go on beyond their ends as the end values.
struct Held {
  using Value = double;
  std::span<const double> values;

  double operator[](std::ptrdiff_t i) const {
    const auto last = static_cast<std::ptrdiff_t>(values.size()) - 1;
    return values[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i, 0, last))];
  }
};

/// Points that go on beyond their ends as their own image through the end point.
struct Pinned {
  using Value = Vec2;
  std::span<const Vec2> values;

  Vec2 operator[](std::ptrdiff_t i) const {
    const auto last = static_cast<std::ptrdiff_t>(values.size()) - 1;
    const auto at = [&](std::ptrdiff_t k) {
      return values[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(k, 0, last))];
    };
    if (i < 0) return 2.0 * at(0) - at(-i);
    if (i > last) return 2.0 * at(last) - at(2 * last - i);
    return at(i);
  }
};

template <typename Extended>
std::vector<typename Extended::Value> convolve(const Extended& source,
                                               std::span<const double> kernel) {
  std::vector<typename Extended::Value> out(source.values.size());
  const auto radius = static_cast<std::ptrdiff_t>(kernel.size() / 2);
  for (std::size_t i = 0; i < out.size(); ++i) {
    typename Extended::Value sum{};
    for (std::ptrdiff_t k = -radius; k <= radius; ++k)
      sum +=
          kernel[static_cast<std::size_t>(k + radius)] * source[static_cast<std::ptrdiff_t>(i) + k];
    out[i] = sum;
  }
  return out;
}

template <typename Extended>
std::vector<typename Extended::Value> average(const Extended& source, std::size_t radius) {
  using Value = typename Extended::Value;
  const std::size_t width = 2 * radius + 1;
  std::vector<Value> sums(source.values.size() + width, Value{});
  for (std::size_t i = 1; i < sums.size(); ++i)
    sums[i] = sums[i - 1] +
              source[static_cast<std::ptrdiff_t>(i - 1) - static_cast<std::ptrdiff_t>(radius)];
  std::vector<Value> out(source.values.size());
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = (1.0 / static_cast<double>(width)) * (sums[i + width] - sums[i]);
  return out;
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
  return convolve(Held{values}, kernel);
}

std::vector<Vec2> smooth_pinned(std::span<const Vec2> points, std::span<const double> kernel) {
  return convolve(Pinned{points}, kernel);
}

std::vector<double> smooth_above(std::span<const double> values, std::size_t radius) {
  std::vector<double> widened(values.size());
  for (std::size_t f = 0; f < values.size(); ++f) {
    const std::size_t from = f > radius ? f - radius : 0;
    const std::size_t to = std::min(f + radius + 1, values.size());
    widened[f] = *std::max_element(values.begin() + static_cast<std::ptrdiff_t>(from),
                                   values.begin() + static_cast<std::ptrdiff_t>(to));
  }
  return smooth_held(widened, hann_kernel(radius));
}

std::vector<double> box_held(std::span<const double> values, std::size_t count) {
  return average(Held{values}, count / 2);
}

std::vector<Vec2> box_pinned(std::span<const Vec2> points, std::size_t count) {
  return average(Pinned{points}, count / 2);
}

double wrap_angle(double angle) noexcept {
  if (std::abs(angle) < std::numbers::pi) return angle;
  const double wrapped = std::remainder(angle, 2 * std::numbers::pi);
  return wrapped <= -std::numbers::pi ? wrapped + 2 * std::numbers::pi : wrapped;
}

void unwrap_angles(std::span<double> angles) noexcept {
  for (std::size_t i = 1; i < angles.size(); ++i)
    angles[i] = angles[i - 1] + wrap_angle(angles[i] - angles[i - 1]);
}

}  // namespace docent::motion
