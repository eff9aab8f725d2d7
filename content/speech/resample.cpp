#include "content/speech/resample.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>

namespace docent::speech {

namespace {

constexpr double pi = std::numbers::pi;
constexpr std::ptrdiff_t half = 16;  // taps on either side of a sample, at the lower of the rates

double sinc(double x) {
  return x == 0 ? 1 : std::sin(pi * x) / (pi * x);
}

/// Blackman's window on [-1, 1].
double window(double x) {
  return std::abs(x) >= 1 ? 0 : 0.42 + 0.5 * std::cos(pi * x) + 0.08 * std::cos(2 * pi * x);
}

/// The taps for each place between two samples at which a new one may lie.
struct Filter {
  std::size_t phases = 0;
  std::ptrdiff_t reach = 0;  ///< Samples on either side.
  std::vector<float> taps;   ///< 2 * reach for each phase.
};

Filter make_filter(std::size_t phases, double cutoff) {
  Filter filter{
      .phases = phases, .reach = static_cast<std::ptrdiff_t>(std::ceil(half / cutoff)), .taps = {}};
  const auto width = static_cast<std::size_t>(2 * filter.reach);
  filter.taps.resize(phases * width);
  for (std::size_t phase = 0; phase < phases; ++phase) {
    double sum = 0;
    const auto tap_at = [&](std::size_t tap) {
      const double x = static_cast<double>(static_cast<std::ptrdiff_t>(tap) - filter.reach + 1) -
                       static_cast<double>(phase) / static_cast<double>(phases);
      return cutoff * sinc(cutoff * x) * window(x / static_cast<double>(filter.reach));
    };
    for (std::size_t tap = 0; tap < width; ++tap) sum += tap_at(tap);
    for (std::size_t tap = 0; tap < width; ++tap)
      filter.taps[phase * width + tap] = static_cast<float>(tap_at(tap) / sum);
  }
  return filter;
}

float sample_at(const std::vector<float>& samples, std::size_t whole, const float* taps,
                std::ptrdiff_t reach) {
  const auto size = static_cast<std::ptrdiff_t>(samples.size());
  const std::ptrdiff_t first = static_cast<std::ptrdiff_t>(whole) - reach + 1;
  const std::ptrdiff_t begin = std::max<std::ptrdiff_t>(0, -first);
  const std::ptrdiff_t end = std::min(2 * reach, size - first);
  float sum = 0;
  for (std::ptrdiff_t tap = begin; tap < end; ++tap)
    sum += samples[static_cast<std::size_t>(first + tap)] * taps[tap];
  return sum;
}

}  // namespace

std::vector<float> resample(const Pcm& sound, std::uint32_t rate) {
  if (sound.rate == rate || sound.samples.empty()) return sound.samples;
  const std::uint32_t common = std::gcd(sound.rate, rate);
  const std::size_t phases = rate / common, step = sound.rate / common;
  const double cutoff = 0.97 * std::min(1.0, static_cast<double>(rate) / sound.rate);
  const Filter filter = make_filter(phases, cutoff);
  std::vector<float> made(std::max<std::size_t>(1, sound.samples.size() * phases / step));
  for (std::size_t i = 0; i < made.size(); ++i) {
    const std::size_t place = i * step;
    const float* taps =
        filter.taps.data() + place % phases * static_cast<std::size_t>(2 * filter.reach);
    made[i] = std::clamp(sample_at(sound.samples, place / phases, taps, filter.reach), -1.0F, 1.0F);
  }
  return made;
}

}  // namespace docent::speech
