#include "platform/opus/encoder.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "platform/opus/decoder.h"
#include "runtime/model/speech.h"

namespace docent::opus::encoder_test {
namespace {

/// A voice of 150 Hz with its overtones.
std::vector<float> hum(std::size_t samples) {
  std::vector<float> sound(samples);
  for (std::size_t i = 0; i < samples; ++i)
    for (int overtone = 1; overtone < 8; ++overtone)
      sound[i] += 0.1F * static_cast<float>(std::sin(2 * std::numbers::pi * 150 * overtone *
                                                     static_cast<double>(i) / encoder_rate));
  return sound;
}

std::vector<float> decoded(const Encoded& encoded) {
  Decoder decoder = *Decoder::open();
  std::vector<float> all;
  std::array<float, Decoder::longest> part{};
  std::span<const std::byte> rest = encoded.packets;
  while (!rest.empty()) {
    const std::size_t more = decoder.decode(take_packet(rest), part);
    all.insert(all.end(), part.begin(), part.begin() + static_cast<std::ptrdiff_t>(more));
  }
  return {all.begin() + encoded.skip, all.begin() + encoded.skip + encoded.samples};
}

double energy(std::span<const float> sound) {
  double sum = 0;
  for (const float sample : sound) sum += double{sample} * sample;
  return sum / static_cast<double>(sound.size());
}

RC_GTEST_PROP(EncoderProperty, WhatIsEncodedHasItsLengthAndKeepsToTheFormat, ()) {
  const auto samples = *rc::gen::inRange<std::size_t>(1, 3 * encoder_rate);

  const auto encoded = encode(hum(samples), 24'000);

  RC_ASSERT(encoded.has_value());
  RC_ASSERT(encoded->samples == 2 * samples);
  const auto held = samples_of_packets(encoded->packets);
  RC_ASSERT(held.has_value());
  RC_ASSERT(*held >= encoded->skip + encoded->samples);
  RC_ASSERT(*held < encoded->skip + encoded->samples + SpeechSound::longest_frame);
}

/// A cymbal is above what speech keeps.
TEST(Encoder, KeepsOfAnySoundWhatIsHigh) {
  std::vector<float> high(SpeechSound::rate);
  for (std::size_t i = 0; i < high.size(); ++i)
    high[i] = 0.3F * static_cast<float>(std::sin(2 * std::numbers::pi * 15'000 *
                                                 static_cast<double>(i) / SpeechSound::rate));

  const auto encoded = encode_sound(high);

  ASSERT_TRUE(encoded.has_value());
  EXPECT_EQ(encoded->samples, high.size());
  EXPECT_NEAR(energy(decoded(*encoded)) / energy(high), 1, 0.2);
  EXPECT_NEAR(static_cast<double>(encoded->packets.size()), sound_bits / 8.0, 1500);
}

TEST(Encoder, GivesBackTheSoundWithItsLoudnessAndInItsPlace) {
  const std::vector<float> sound = hum(encoder_rate);
  const auto encoded = encode(sound, 24'000);

  const std::vector<float> heard = decoded(*encoded);

  ASSERT_EQ(heard.size(), 2 * sound.size());
  EXPECT_NEAR(energy(heard) / energy(sound), 0.9, 0.2);  // low tones are weakened
  double together = 0;
  for (std::size_t i = 0; i < sound.size(); ++i) together += double{sound[i]} * heard[2 * i];
  together /= static_cast<double>(sound.size());
  EXPECT_GT(together / std::sqrt(energy(sound) * energy(heard)), 0.8);
}

TEST(Encoder, TakesAtMostThreeThousandBytesASecond) {
  EXPECT_LT(encode(hum(10 * encoder_rate), 24'000)->packets.size(), 33'000U);
  EXPECT_LT(encode(std::vector<float>(10 * encoder_rate), 24'000)->packets.size(), 33'000U);
}

TEST(Encoder, SaysThatNothingCannotBeEncoded) {
  ASSERT_FALSE(encode({}, 24'000).has_value());
  EXPECT_EQ(encode({}, 24'000).error().what, "Opus cannot be encoded: invalid argument");
}

RC_GTEST_PROP(DecoderProperty, AnyBytesAreSomeSamplesOrNone,
              (const std::vector<std::vector<std::uint8_t>>& packets)) {
  Decoder decoder = *Decoder::open();
  std::array<float, Decoder::longest> out{};
  for (const auto& packet : packets)
    RC_ASSERT(decoder.decode(std::as_bytes(std::span(packet)), out) <= out.size());
}

TEST(Decoder, ForgetsTheSoundBefore) {
  const auto encoded = encode(hum(encoder_rate), 24'000);
  std::span<const std::byte> packets = encoded->packets;
  const auto first = take_packet(packets);
  Decoder decoder = *Decoder::open();
  std::array<float, Decoder::longest> fresh{}, again{};
  decoder.decode(first, fresh);
  decoder.decode(take_packet(packets), again);
  decoder.forget();
  again = {};
  decoder.decode(first, again);
  EXPECT_EQ(again, fresh);
}

}  // namespace
}  // namespace docent::opus::encoder_test
