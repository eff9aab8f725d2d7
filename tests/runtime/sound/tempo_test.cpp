#include "runtime/sound/tempo.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace docent::sound::tempo_test {
namespace {

constexpr std::size_t rate = 48'000;

std::vector<float> tone(double hertz, std::size_t samples) {
  std::vector<float> made(samples);
  for (std::size_t i = 0; i < samples; ++i)
    made[i] = static_cast<float>(
        0.5 * std::sin(2 * std::numbers::pi * hertz * static_cast<double>(i) / rate));
  return made;
}

std::vector<float> through(Tempo& tempo, std::span<const float> samples) {
  std::vector<float> heard;
  std::array<float, 960> part{};
  const auto take = [&](std::size_t given) {
    heard.insert(heard.end(), part.begin(), part.begin() + static_cast<std::ptrdiff_t>(given));
    return given > 0;
  };
  while (!samples.empty()) {
    const auto next = samples.first(std::min({samples.size(), tempo.room(), std::size_t{960}}));
    tempo.push(next);
    samples = samples.subspan(next.size());
    while (take(tempo.pull(part))) {
    }
  }
  while (take(tempo.finish(part))) {
  }
  return heard;
}

double power(std::span<const float> samples) {
  double sum = 0;
  for (const float sample : samples) sum += double{sample} * sample;
  return sum / static_cast<double>(samples.size());
}

/// How often the sound goes from below zero to above, in a second.
double pitch(std::span<const float> samples) {
  std::size_t rises = 0;
  for (std::size_t i = 1; i < samples.size(); ++i)
    if (samples[i - 1] < 0 && samples[i] >= 0) ++rises;
  return static_cast<double>(rises) * rate / static_cast<double>(samples.size());
}

TEST(Tempo, ChangesNothingAtTheUsualSpeed) {
  Tempo tempo;
  const auto sound = tone(200, rate);
  EXPECT_EQ(through(tempo, sound), sound);
}

RC_GTEST_PROP(TempoProperty, LengthFollowsTheSpeedAndPitchAndLoudnessStay, ()) {
  const auto speed = static_cast<float>(*rc::gen::inRange(50, 301)) / 100;
  const double hertz = *rc::gen::inRange(140, 400);
  Tempo tempo;
  tempo.set_speed(speed);

  const auto sound = tone(hertz, 2 * rate);
  const auto heard = through(tempo, sound);

  const double length = static_cast<double>(heard.size()) * static_cast<double>(speed);
  RC_ASSERT(std::abs(length / (2.0 * rate) - 1) < 0.06);
  const auto middle = std::span(heard).subspan(2'000, heard.size() - 6'000);
  RC_ASSERT(std::abs(pitch(middle) / hertz - 1) < 0.03);
  RC_ASSERT(std::abs(power(middle) / power(sound) - 1) < 0.1);
}

RC_GTEST_PROP(TempoProperty, AnySpeedsAndSamplesAreWithinBounds, ()) {
  Tempo tempo;
  std::array<float, 960> part{};
  for (int turns = 100; turns > 0; --turns) {
    tempo.set_speed(static_cast<float>(*rc::gen::inRange(-100, 1000)) / 100);
    const auto sound = tone(*rc::gen::inRange(20, 9'000), *rc::gen::inRange<std::size_t>(0, 9'000));
    tempo.push(sound);
    RC_ASSERT(tempo.room() <= Tempo::most);
    RC_ASSERT(tempo.pull(part) <= part.size());
    if (*rc::gen::inRange(0, 20) == 0) tempo.clear();
    for (const float sample : part) RC_ASSERT(std::abs(sample) <= 0.6F);
  }
  tempo.set_speed(NAN);
  int rounds = 0;
  while (tempo.finish(part) > 0) RC_ASSERT(++rounds < 100);
}

}  // namespace
}  // namespace docent::sound::tempo_test
