#pragma once

#include <cstdint>
#include <vector>

namespace docent::speech {

/// Sound as samples of one channel in [-1, 1].
struct Pcm {
  std::uint32_t rate = 0;  ///< Samples a second.
  std::vector<float> samples;
};

/// What recordings may have. A lying header must not ask for gigabytes.
inline constexpr std::uint32_t least_rate = 8'000, most_rate = 192'000;
inline constexpr std::uint32_t longest_seconds = 600;

}  // namespace docent::speech
