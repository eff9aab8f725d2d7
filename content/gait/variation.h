#pragma once

#include <cstdint>

namespace docent::gait {

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

}  // namespace docent::gait
