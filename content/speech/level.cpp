#include "content/speech/level.h"

#include <algorithm>
#include <cmath>

namespace docent::speech {

namespace {

constexpr float audible = 0.003F;      // -50 dB
constexpr double wanted_power = 0.01;  // an RMS of -20 dB, as speech is usually levelled
constexpr float most_peak = 0.9F, most_gain = 30;

float peak_of(std::span<const float> samples) {
  float peak = 0;
  for (const float sample : samples) peak = std::max(peak, std::abs(sample));
  return peak;
}

}  // namespace

std::span<const float> without_silence(std::span<const float> samples, std::uint32_t rate) {
  const auto is_heard = [](float sample) { return std::abs(sample) > audible; };
  const auto first = std::ranges::find_if(samples, is_heard);
  if (first == samples.end()) return samples;
  const auto last = std::find_if(samples.rbegin(), samples.rend(), is_heard).base();
  const auto margin = static_cast<std::ptrdiff_t>(rate / 100);
  const auto before = std::min(margin, first - samples.begin());
  const auto after = std::min(margin, samples.end() - last);
  return {first - before, last + after};
}

void level(std::vector<float>& samples) {
  double sum = 0;
  std::size_t heard = 0;
  for (const float sample : samples)
    if (std::abs(sample) > audible) {
      sum += double{sample} * sample;
      ++heard;
    }
  if (heard == 0) return;
  const auto gain = static_cast<float>(std::sqrt(wanted_power * static_cast<double>(heard) / sum));
  const float kept = std::min({gain, most_gain, most_peak / peak_of(samples)});
  for (float& sample : samples) sample *= kept;
}

}  // namespace docent::speech
