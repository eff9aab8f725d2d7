#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

namespace docent::motion {

/// What happens by chance, and is yet the same whenever it is asked: functions of a time and of who
/// it is, without a state. Good for months: nothing is summed up.

/// A number in [0, 1) for the n-th time (SplitMix64; Steele, Lea, Flood 2014).
inline double chance(std::uint64_t who, std::int64_t n) noexcept {
  std::uint64_t z = (who + 1) * 0x9e3779b97f4a7c15U + static_cast<std::uint64_t>(n);
  z = (z ^ (z >> 32)) * 0xd6e8feb86659fd93U;  // neighbours in time are no neighbours in number
  z += 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1.0p-53;
}

/// From 0 to 1 and from rest to rest with the least jerk (Flash and Hogan 1985).
inline double least_jerk(double t) noexcept {
  t = t < 0 ? 0 : t > 1 ? 1 : t;
  return t * t * t * (10 + t * (6 * t - 15));
}

/// Something that recurs about once in a period, at irregular times.
struct Occasion {
  std::int64_t n = 0;  ///< Which.
  double since = 0;    ///< Seconds since it began.
};

/// The occasion that is just then, if one is: each `lasts` seconds, less than the period.
inline std::optional<Occasion> occasion_at(double seconds, double period, double lasts,
                                           std::uint64_t who) noexcept {
  const auto n = static_cast<std::int64_t>(std::floor(seconds / period));
  const double begins = static_cast<double>(n) * period + (period - lasts) * chance(who, n);
  if (seconds < begins || seconds >= begins + lasts) return {};
  return Occasion{n, seconds - begins};
}

/// A number in [-1, 1] that is kept for about a period, then changes within `change` seconds.
inline double kept_for(double seconds, double period, double change, std::uint64_t who) noexcept {
  const auto n = static_cast<std::int64_t>(std::floor(seconds / period));
  const double begins = static_cast<double>(n) * period + (period - change) * chance(who, n);
  const double before = 2 * chance(~who, n - 1) - 1, after = 2 * chance(~who, n) - 1;
  return before + (after - before) * least_jerk((seconds - begins) / change);
}

}  // namespace docent::motion
