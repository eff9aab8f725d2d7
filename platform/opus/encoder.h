#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/model/result.h"

namespace docent::opus {

/// A sound as a SpeechSound holds it.
struct Encoded {
  std::uint32_t skip = 0, samples = 0;
  std::vector<std::byte> packets;
};

/// What `encode` is given: speech keeps all of itself below 12 kHz.
inline constexpr std::uint32_t encoder_rate = 24'000;

/// Encodes samples of one channel, `encoder_rate` a second, in [-1, 1], as speech. The same samples
/// give the same packets on the same kind of processor. Fails where there are none, and where
/// memory is out.
Result<Encoded> encode(std::span<const float> samples, int bits_per_second);

/// The same of any other sound, in `SpeechSound::rate` samples a second, at `sound_bits`.
Result<Encoded> encode_sound(std::span<const float> samples);
inline constexpr int sound_bits = 40'000;  ///< A second.

/// libopus and its version, as it says itself.
const char* encoder_version() noexcept;

}  // namespace docent::opus
