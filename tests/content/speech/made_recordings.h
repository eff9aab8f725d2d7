#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace docent::test {

/// A tone of so many samples, in [-0.5, 0.5].
std::vector<float> tone(double hertz, std::uint32_t rate, std::size_t samples);

/// A WAV file: 16 bits, one channel unless `channels` says otherwise (each has the same sound).
std::string wav_of(std::span<const float> samples, std::uint32_t rate, std::uint32_t channels = 1);

/// The same in another form: 8, 24 or 32 bits, or (33) floats.
std::string wav_of_bits(std::span<const float> samples, std::uint32_t rate, std::uint32_t bits);

/// An Ogg file of Opus, of samples 24,000 a second, with pages of a few packets.
std::string ogg_of(std::span<const float> samples);

/// A page of Ogg with its checksum, as RFC 3533 has it.
std::string ogg_page(std::string_view body, std::span<const std::uint8_t> lacing,
                     std::uint64_t granule, std::uint32_t number);

double power(std::span<const float> samples);

}  // namespace docent::test
