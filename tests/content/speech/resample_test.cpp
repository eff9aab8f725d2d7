#include "content/speech/resample.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "content/speech/level.h"
#include "tests/content/speech/made_recordings.h"

namespace docent::speech::resample_test {
namespace {

using test::power;
using test::tone;

RC_GTEST_PROP(ResampleProperty, ATonePassesWithItsPitchAndLoudness, ()) {
  const auto from = *rc::gen::inRange<std::uint32_t>(8'000, 96'001);
  const auto to = *rc::gen::element<std::uint32_t>(16'000, 24'000, 48'000);
  const double hertz = *rc::gen::inRange(100, 2'500);

  const auto made = resample({from, tone(hertz, from, from / 4)}, to);
  const auto wanted = tone(hertz, to, to / 4);

  RC_ASSERT(std::abs(static_cast<double>(made.size()) - static_cast<double>(wanted.size())) <
            2 + to / static_cast<double>(from));
  for (std::size_t i = 200; i + 200 < std::min(made.size(), wanted.size()); ++i)
    RC_ASSERT(std::abs(made[i] - wanted[i]) < 0.01F);
}

TEST(Resample, LeavesOutWhatFewerSamplesCannotHold) {
  const auto made = resample({48'000, tone(15'000, 48'000, 48'000)}, 24'000);
  EXPECT_LT(power(std::span(made).subspan(100, made.size() - 200)), 1e-7);
}

TEST(Resample, GivesAtLeastOneSample) {
  EXPECT_EQ(resample({192'000, {0.5F}}, 24'000).size(), 1U);
  EXPECT_TRUE(resample({22'050, {}}, 24'000).empty());
}

TEST(Level, TakesTheSilenceOffBothEnds) {
  std::vector<float> sound(5'000);
  const auto middle = tone(300, 24'000, 2'400);
  std::ranges::copy(middle, sound.begin() + 1'000);

  const auto heard = without_silence(sound, 24'000);

  EXPECT_NEAR(static_cast<double>(heard.size()), 2'400 + 2 * 240, 4);
  EXPECT_EQ(without_silence(std::vector<float>(100), 24'000).size(), 100U);
  EXPECT_TRUE(without_silence({}, 24'000).empty());
}

RC_GTEST_PROP(LevelProperty, MakesAllPiecesAlikeAndClipsNothing, ()) {
  const auto loudness = static_cast<float>(*rc::gen::inRange(2, 200)) / 100;
  auto sound = tone(300, 24'000, 24'000);
  for (float& sample : sound) sample *= loudness;

  level(sound);

  RC_ASSERT(std::abs(std::sqrt(power(sound)) - 0.1) < 0.01);
  for (const float sample : sound) RC_ASSERT(std::abs(sample) <= 0.91F);
}

TEST(Level, LeavesSilenceSilent) {
  std::vector<float> sound(100, 0.0001F);
  level(sound);
  EXPECT_LT(power(sound), 1e-6);
}

}  // namespace
}  // namespace docent::speech::resample_test
