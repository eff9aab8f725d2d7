#include "content/speech/resample.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace docent::speech {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double half = 16;       // taps on either side of a sample, at the lower of the rates
constexpr std::size_t lanes = 8;  // sums that are taken at a time

double sinc(double x) {
  return x == 0 ? 1 : std::sin(pi * x) / (pi * x);
}

/// Blackman's window on [-1, 1].
double window(double x) {
  return std::abs(x) >= 1 ? 0 : 0.42 + 0.5 * std::cos(pi * x) + 0.08 * std::cos(2 * pi * x);
}

double cutoff_of(std::uint32_t from, std::uint32_t to) {
  return 0.97 * std::min(1.0, static_cast<double>(to) / from);
}

/// The taps of a place that is `share` of the way from one sample to the next; they add up to 1.
void fill_phase(double share, double cutoff, std::size_t reach, std::span<float> taps) {
  std::vector<double> exact(2 * reach);
  for (std::size_t tap = 0; tap < exact.size(); ++tap) {
    const double x = static_cast<double>(tap) - static_cast<double>(reach) + 1 - share;
    exact[tap] = sinc(cutoff * x) * window(x / static_cast<double>(reach));
  }
  const double sum = std::reduce(exact.begin(), exact.end());
  std::ranges::transform(exact, taps.begin(),
                         [=](double tap) { return static_cast<float>(tap / sum); });
}

/// Of `width` samples, a multiple of the lanes: one sum would wait for itself at each tap.
float weighted(const float* samples, const float* taps, std::size_t width) {
  std::array<float, lanes> sums{};
  for (std::size_t tap = 0; tap < width; tap += lanes)
    for (std::size_t lane = 0; lane < lanes; ++lane)
      sums[lane] += samples[tap + lane] * taps[tap + lane];
  return ((sums[0] + sums[4]) + (sums[2] + sums[6])) + ((sums[1] + sums[5]) + (sums[3] + sums[7]));
}

}  // namespace

Resampler::Resampler(std::uint32_t from, std::uint32_t to)
    : from_(from),
      phases_(to / std::gcd(from, to)),
      step_(from / std::gcd(from, to)),
      reach_(static_cast<std::size_t>(std::ceil(half / cutoff_of(from, to)))),
      width_((2 * reach_ + lanes - 1) / lanes * lanes),
      taps_(phases_ * width_) {
  for (std::size_t phase = 0; phase < phases_; ++phase)
    fill_phase(static_cast<double>(phase) / static_cast<double>(phases_), cutoff_of(from, to),
               reach_, std::span(taps_).subspan(phase * width_, width_));
}

std::vector<float> Resampler::resample(std::span<const float> samples) const {
  if (samples.empty()) return {};
  // With the silence before and after it, so that every new sample has all of its taps.
  std::vector<float> padded(reach_ - 1 + samples.size() + width_);
  std::ranges::copy(samples, padded.begin() + static_cast<std::ptrdiff_t>(reach_ - 1));
  std::vector<float> made(std::max<std::size_t>(1, samples.size() * phases_ / step_));
  for (std::size_t i = 0; i < made.size(); ++i) {
    const std::size_t place = i * step_;
    const float sample =
        weighted(padded.data() + place / phases_, taps_.data() + place % phases_ * width_, width_);
    made[i] = std::clamp(sample, -1.0F, 1.0F);
  }
  return made;
}

std::vector<float> resample(const Pcm& sound, std::uint32_t rate) {
  if (sound.rate == rate) return sound.samples;
  return Resampler(sound.rate, rate).resample(sound.samples);
}

}  // namespace docent::speech
