#pragma once

#include <chrono>
#include <cstdint>

namespace docent::clock {

/// Time that only moves forward (CLOCK_MONOTONIC): nanoseconds since some fixed moment.
std::chrono::nanoseconds monotonic_now() noexcept;

/// Measures the time between frames.
class FrameClock {
 public:
  FrameClock() noexcept : last_(monotonic_now()) {}

  /// Time since the last call, or since construction.
  std::chrono::nanoseconds since_last_frame() noexcept;

 private:
  std::chrono::nanoseconds last_;
};

}  // namespace docent::clock
