#include "runtime/sound/volume.h"

#include <algorithm>
#include <cmath>

namespace docent::sound {

float gain_of(float volume) noexcept {
  if (!(volume > 0)) return 0;
  constexpr float range = 40;  // decibels from the softest to the loudest
  return std::pow(10.0F, (std::min(volume, 1.0F) - 1) * range / 20);
}

void to_device(std::span<const float> samples, float gain_before, float gain_after,
               std::span<std::int16_t> out) noexcept {
  const float step =
      samples.empty() ? 0 : (gain_after - gain_before) / static_cast<float>(samples.size());
  float gain = gain_before;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    gain += step;
    const float value = std::clamp(samples[i] * gain, -1.0F, 1.0F) * 32767;
    out[2 * i] = out[2 * i + 1] = static_cast<std::int16_t>(std::lrint(value));
  }
}

}  // namespace docent::sound
