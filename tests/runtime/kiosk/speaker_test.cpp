#include "runtime/kiosk/speaker.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <span>

#include "platform/opus/decoder.h"
#include "platform/sqlite/content_reader.h"
#include "runtime/sound/volume.h"
#include "tests/support/kiosk_run.h"
#include "tests/support/sample_database.h"

namespace docent::kiosk::speaker_test {
namespace {

std::vector<float> decoded(const SpeechSound& sound) {
  opus::Decoder decoder = *opus::Decoder::open();
  std::vector<float> all, part(opus::Decoder::longest);
  std::span<const std::byte> rest = sound.packets;
  while (!rest.empty()) {
    const std::size_t more = decoder.decode(take_packet(rest), part);
    all.insert(all.end(), part.begin(), part.begin() + static_cast<std::ptrdiff_t>(more));
  }
  return {all.begin() + sound.skip, all.begin() + sound.skip + sound.samples};
}

/// The left channel.
std::vector<float> heard_in(const std::filesystem::path& file) {
  const std::string bytes = test::text_of(file);
  std::vector<float> samples;
  for (std::size_t at = 44; at + 4 <= bytes.size(); at += 4) {
    std::int16_t sample = 0;
    std::memcpy(&sample, bytes.data() + at, sizeof sample);
    samples.push_back(static_cast<float>(sample) / 32767);
  }
  return samples;
}

/// Is `said` somewhere among what is heard, as loud as at `volume`? From 0, not at all, to 1.
double likeness(std::span<const float> heard, std::span<const float> said, float volume) {
  const float gain = sound::gain_of(volume);
  double best = 0, energy_said = 0;
  for (const float sample : said) energy_said += std::pow(double{sample} * gain, 2);
  for (std::size_t at = 0; at + said.size() <= heard.size() && best <= 0.98; ++at) {
    double together = 0, energy = 1e-9;
    for (std::size_t i = 0; i < said.size(); i += 16) {
      together += double{said[i]} * gain * heard[at + i];
      energy += std::pow(heard[at + i], 2);
    }
    best = std::max(best, together / std::sqrt(energy * energy_said / 16));
  }
  return best;
}

/// A visit with headphones and open eyes: what comes out of the socket is what the database holds
/// of the first sentence.
TEST(Speaker, LetsTheFirstSentenceOfAVisitBeHeard) {
  const auto museum = sqlite::load_museum(test::sample_database());
  ASSERT_TRUE(museum.has_value()) << museum.error().what;
  const SpeechSound* wanted = find_sound(museum->speech, 0, "What would you like to see?");
  if (wanted == nullptr) GTEST_SKIP() << "the sample museum was compiled without espeak-ng";
  const test::VisitRun run("1 key ENTER\n2 headphones in\n4 quit\n");
  std::ofstream(run.file("kiosk.toml"))
      << "[sound]\ndevice = \"file:" << run.file("heard.wav").string() << "\"\n";

  const test::ProgramRun played = run.play("--config '" + run.file("kiosk.toml").string() +
                                           "' --speech '" + run.file("said.csv").string() +
                                           "' --stats '" + run.file("stats.json").string() + "'");

  ASSERT_EQ(played.exit_code, 0) << played.err;
  EXPECT_THAT(test::text_of(run.file("said.csv")),
              testing::HasSubstr(",en,What would you like to see?"));
  const std::vector<float> heard = heard_in(run.file("heard.wav"));
  const std::vector<float> said = decoded(*wanted);
  ASSERT_GT(heard.size(), said.size());
  EXPECT_GT(likeness(heard, said, 0.5F), 0.98);
  EXPECT_EQ(test::number_in(test::text_of(run.file("stats.json")), "allocations_in_frames"), 0);
}

/// A visit that listens to the bell: the first strike of it comes out of the loudspeaker.
TEST(Speaker, LetsASoundBeHeardThatAVisitorListensTo) {
  const auto museum = sqlite::load_museum(test::sample_database());
  ASSERT_TRUE(museum.has_value()) << museum.error().what;
  ASSERT_FALSE(museum->sounds.empty());
  const SpeechSound* bell = recording_of(*museum, 0, 0);
  ASSERT_NE(bell, nullptr);
  const test::VisitRun run("0.5 tap @exhibit:chime-bells\n60 tap @sound:1\n68 quit\n");
  std::ofstream(run.file("kiosk.toml"))
      << "[sound]\ndevice = \"file:" << run.file("heard.wav").string() << "\"\n";

  const test::ProgramRun played = run.play("--config '" + run.file("kiosk.toml").string() +
                                           "' --speech '" + run.file("said.csv").string() +
                                           "' --stats '" + run.file("stats.json").string() + "'");

  ASSERT_EQ(played.exit_code, 0) << played.err;
  EXPECT_THAT(test::text_of(run.file("said.csv")),
              testing::HasSubstr(",sound:1,en,\"[One bell, two notes]\"\n"));
  const std::vector<float> heard = heard_in(run.file("heard.wav"));
  const std::vector<float> played_back = decoded(*bell);
  ASSERT_GE(heard.size(), played_back.size());
  const auto strike = std::span(played_back).subspan(4800, 24'000);
  EXPECT_GT(likeness(std::span(heard).first(48'000), strike, 0.5F), 0.98);
  EXPECT_EQ(test::number_in(test::text_of(run.file("stats.json")), "allocations_in_frames"), 0);
}

/// Till the silence has ended, the captions go on: all of 5,000 Thai signs is read.
TEST(Speaker, IsSilentForAsLongAsALongTextWithoutAVoiceIsRead) {
  Museum museum;
  museum.languages.emplace_back().tag = "th";
  interface::Utterance utterance{.language = "th", .pieces = {}};
  for (int line = 0; line < 50; ++line) {
    std::string text;
    for (int sign = 0; sign < 100; ++sign) text += "ก";
    utterance.pieces.push_back({.text = text, .pause = true});
  }
  std::array<sound::SpeechPart, 512> parts;

  const std::size_t count = parts_of(utterance, museum, parts);

  float seconds = 0;
  for (const sound::SpeechPart& part : std::span(parts).first(count)) {
    EXPECT_EQ(part.sound, nullptr);
    seconds += static_cast<float>(part.pauses * sound::SpeechQueue::pause) / SpeechSound::rate;
  }
  EXPECT_NEAR(seconds, interface::seconds_of(utterance), 0.25);
  EXPECT_GT(seconds, 700);
}

/// Every language of the sample museum has a sound for each of its pieces, in less than 30 MB.
TEST(Speaker, HasTheSampleMuseumsVoices) {
  const auto museum = sqlite::load_museum(test::sample_database());
  ASSERT_TRUE(museum.has_value());
  if (std::ranges::all_of(museum->speech, is_recording))
    GTEST_SKIP() << "the sample museum was compiled without espeak-ng";
  std::size_t bytes = 0;
  std::vector<bool> speaks(museum->languages.size());
  for (const SpeechSound& sound : museum->speech) {
    bytes += sound.packets.size();
    if (is_recording(sound)) continue;
    speaks[sound.language] = true;
  }
  EXPECT_LT(bytes, 30'000'000U);
  EXPECT_EQ(std::ranges::count(speaks, false), 0);
}

}  // namespace
}  // namespace docent::kiosk::speaker_test
