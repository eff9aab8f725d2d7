#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace docent::speech {

/// The part between the silence before and the silence after a sound, so that pieces can follow
/// each other; all of it where it is silent throughout. 10 ms are left on either side.
std::span<const float> without_silence(std::span<const float> samples, std::uint32_t rate);

/// Makes it as loud as every other piece, without clipping. What is nearly silent stays so.
void level(std::vector<float>& samples);

}  // namespace docent::speech
