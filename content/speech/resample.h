#pragma once

#include <cstdint>
#include <vector>

#include "content/speech/pcm.h"

namespace docent::speech {

/// The same sound with another number of samples a second, without what the fewer cannot hold:
/// a windowed sinc of 32 taps, in phases (Crochiere and Rabiner, "Multirate Digital Signal
/// Processing", 1983).
std::vector<float> resample(const Pcm& sound, std::uint32_t rate);

}  // namespace docent::speech
