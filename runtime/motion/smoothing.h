#pragma once

#include <span>
#include <vector>

#include "runtime/model/geometry/vec2.h"

namespace docent::motion {

/// Weights of a Gaussian that add up to one. `deviation` is the standard deviation in samples; the
/// Gaussian is cut at three deviations.
std::vector<double> gaussian_kernel(double deviation);

/// Weights of a Hann window of 2 * radius + 1 samples that add up to one.
std::vector<double> hann_kernel(std::size_t radius);

/// Convolves evenly spaced values; beyond the ends the end values repeat.
std::vector<double> smooth_held(std::span<const double> values, std::span<const double> kernel);

/// Convolves evenly spaced points; beyond an end the curve goes on as its own image through the end
/// point, so that both ends stay where they are.
std::vector<Vec2> smooth_pinned(std::span<const Vec2> points, std::span<const double> kernel);

/// The same with equal weights over `count` (odd) samples, in a time that does not depend on
/// `count`.
std::vector<double> box_held(std::span<const double> values, std::size_t count);
std::vector<Vec2> box_pinned(std::span<const Vec2> points, std::size_t count);

/// A smooth curve on or closely above evenly spaced values: the running maximum over 2 * radius + 1
/// samples, then a Hann window as wide.
std::vector<double> smooth_above(std::span<const double> values, std::size_t radius);

/// The angle in (-pi, pi] that differs by whole turns.
double wrap_angle(double angle) noexcept;

/// Adds whole turns so that neighbours differ by at most half a turn.
void unwrap_angles(std::span<double> angles) noexcept;

}  // namespace docent::motion
