#include "tests/content/speech/made_recordings.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "platform/opus/encoder.h"
#include "runtime/model/speech.h"

namespace docent::test {

namespace {

void put(std::string& bytes, std::uint64_t value, int count) {
  for (int i = 0; i < count; ++i) bytes += static_cast<char>(value >> (8 * i));
}

std::string riff(std::uint32_t kind, std::uint32_t channels, std::uint32_t rate, std::uint32_t bits,
                 const std::string& data) {
  std::string file = "RIFF";
  put(file, 36 + data.size(), 4);
  file += "WAVEfmt ";
  put(file, 16, 4);
  put(file, kind, 2);
  put(file, channels, 2);
  put(file, rate, 4);
  put(file, std::uint64_t{rate} * channels * bits / 8, 4);
  put(file, channels * bits / 8, 2);
  put(file, bits, 2);
  file += "data";
  put(file, data.size(), 4);
  return file + data;
}

}  // namespace

std::vector<float> tone(double hertz, std::uint32_t rate, std::size_t samples) {
  std::vector<float> made(samples);
  for (std::size_t i = 0; i < samples; ++i)
    made[i] = static_cast<float>(
        0.5 * std::sin(2 * std::numbers::pi * hertz * static_cast<double>(i) / rate));
  return made;
}

std::string wav_of(std::span<const float> samples, std::uint32_t rate, std::uint32_t channels) {
  std::string data;
  for (const float sample : samples)
    for (std::uint32_t channel = 0; channel < channels; ++channel)
      put(data, static_cast<std::uint64_t>(std::lround(sample * 32767)), 2);
  return riff(1, channels, rate, 16, data);
}

std::string wav_of_bits(std::span<const float> samples, std::uint32_t rate, std::uint32_t bits) {
  std::string data;
  for (const float sample : samples) {
    const double full = std::ldexp(1.0, static_cast<int>(bits) - 1) - 1;
    if (bits == 33)
      put(data, std::bit_cast<std::uint32_t>(sample), 4);
    else if (bits == 8)
      put(data, static_cast<std::uint64_t>(std::lround(sample * 127 + 128)), 1);
    else
      put(data, static_cast<std::uint64_t>(std::llround(sample * full)),
          static_cast<int>(bits / 8));
  }
  return riff(bits == 33 ? 3 : 1, 1, rate, bits == 33 ? 32 : bits, data);
}

std::string ogg_page(std::string_view body, std::span<const std::uint8_t> lacing,
                     std::uint64_t granule, std::uint32_t number) {
  std::string page("OggS\0\0", 6);
  put(page, granule, 8);
  put(page, 77, 4);
  put(page, number, 4);
  put(page, 0, 4);
  put(page, lacing.size(), 1);
  for (const std::uint8_t lace : lacing) put(page, lace, 1);
  page += body;
  std::uint32_t sum = 0;
  for (const char c : page) {
    sum ^= std::uint32_t{static_cast<unsigned char>(c)} << 24U;
    for (int bit = 0; bit < 8; ++bit) sum = (sum << 1U) ^ ((sum >> 31U) != 0 ? 0x04c11db7U : 0U);
  }
  for (int i = 0; i < 4; ++i)
    page[22 + static_cast<std::size_t>(i)] = static_cast<char>(sum >> (8 * i));
  return page;
}

std::string ogg_of(std::span<const float> samples) {
  const auto encoded = opus::encode(samples, 24'000);
  std::string head = "OpusHead";
  put(head, 1, 1);
  put(head, 1, 1);
  put(head, encoded->skip, 2);
  put(head, 24'000, 4);
  put(head, 0, 3);
  const std::string tags = "OpusTags";
  const auto whole = [](std::string_view packet) {
    std::vector<std::uint8_t> lacing(packet.size() / 255, 255);
    lacing.push_back(static_cast<std::uint8_t>(packet.size() % 255));
    return lacing;
  };
  std::string file = ogg_page(head, whole(head), 0, 0) + ogg_page(tags, whole(tags), 0, 1);
  std::span<const std::byte> rest = encoded->packets;
  std::uint64_t granule = 0;
  for (std::uint32_t number = 2; !rest.empty(); ++number) {
    std::string body;
    std::vector<std::uint8_t> lacing;
    for (int packets = 0; packets < 9 && !rest.empty(); ++packets) {
      const auto packet = take_packet(rest);
      const std::string_view bytes(reinterpret_cast<const char*>(packet.data()), packet.size());
      body += bytes;
      const auto more = whole(bytes);
      lacing.insert(lacing.end(), more.begin(), more.end());
      granule += samples_of_packet(packet);
    }
    granule = std::min<std::uint64_t>(granule, encoded->skip + encoded->samples);
    file += ogg_page(body, lacing, granule, number);
  }
  return file;
}

double power(std::span<const float> samples) {
  double sum = 0;
  for (const float sample : samples) sum += double{sample} * sample;
  return samples.empty() ? 0 : sum / static_cast<double>(samples.size());
}

}  // namespace docent::test
