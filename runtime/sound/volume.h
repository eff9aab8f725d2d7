#pragma once

#include <cstdint>
#include <span>

namespace docent::sound {

/// What samples are multiplied with at a volume of 0 to 1: each tenth is heard as about as much
/// louder as the last; 0 is silence.
float gain_of(float volume) noexcept;

/// Samples in [-1, 1] as whole numbers for two channels, both the same, while the gain goes from
/// one value to another without a click. `out` has room for two of each.
void to_device(std::span<const float> samples, float gain_before, float gain_after,
               std::span<std::int16_t> out) noexcept;

}  // namespace docent::sound
