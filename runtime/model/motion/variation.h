#pragma once

#include <cmath>
#include <cstdint>

namespace docent {

/// Small differences between one step and the next: a number in [-1, 1] for each seed, step and
/// purpose, the same on every machine (SplitMix64, Steele, Lea and Flood 2014).
constexpr double variation(std::uint32_t seed, std::int64_t step, std::uint32_t purpose) noexcept {
  std::uint64_t x = (static_cast<std::uint64_t>(seed) << 40U) ^
                    (static_cast<std::uint64_t>(step + 1024) << 8U) ^ purpose;
  x += 0x9E3779B97F4A7C15ULL;
  x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9ULL;
  x = (x ^ (x >> 27U)) * 0x94D049BB133111EBULL;
  x ^= x >> 31U;
  return static_cast<double>(x >> 11U) * 0x1p-52 - 1.0;
}

/// The same with a memory: what a step is like is like the steps before it, the less the longer ago
/// they are, over tens of steps (1/f noise; Hausdorff et al. 1995 found it in the strides of
/// healthy people). Mean 0, standard deviation 1, within 4. Six sources, the k-th of which lasts
/// for 2^k steps (Voss and Clarke 1978). Purposes are below 32.
inline double fluctuation(std::uint32_t seed, std::int64_t step, std::uint32_t purpose) noexcept {
  constexpr std::uint32_t sources = 6, purposes = 32;
  double sum = 0;
  for (std::uint32_t k = 0; k < sources; ++k)
    sum += variation(seed, step >> k, purpose + purposes * k);
  return sum * std::sqrt(3.0 / sources);
}

}  // namespace docent
