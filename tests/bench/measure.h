#pragma once

#include <cstddef>
#include <span>

#include "runtime/model/geometry/vec2.h"

namespace docent::bench {

/// The value below which a part (0 to 1) of the values lie, interpolated. NaN for none.
double quantile(std::span<const double> values, double part);
double median(std::span<const double> values);

/// Seconds on a clock that only goes forward.
double now() noexcept;

/// Bytes that the program has asked for and not given back.
double heap_in_use() noexcept;
/// Megabytes that the process has held at most since it began or `forget_peak` was called (Linux).
double peak_megabytes();
void forget_peak();

/// y = factor * x ^ exponent, by least squares on the logarithms. All coordinates positive.
struct PowerLaw {
  double factor = 0, exponent = 0;
};
PowerLaw fit_power_law(std::span<const Vec2> points);

}  // namespace docent::bench
