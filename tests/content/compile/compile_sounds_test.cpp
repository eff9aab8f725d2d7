#include "content/compile/compile_sounds.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "platform/opus/decoder.h"
#include "platform/sqlite/content_reader.h"
#include "tests/content/speech/made_recordings.h"
#include "tests/support/museum_folder.h"

namespace docent::compile::compile_sounds_test {
namespace {

using test::tone;
using test::wav_of;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr std::uint32_t rate = 8'000;
constexpr std::string_view words =
    "title.en = \"The disc rings\"\ntitle.ar = \"رنين القرص\"\n"
    "description.en = \"A clear note.\"\ndescription.ar = \"نغمة صافية.\"\n";

/// The small museum, in which one can listen to its disc.
struct MuseumWithSound : test::MuseumFolder {
  explicit MuseumWithSound(std::string_view rest = "recording = \"sounds/ring.wav\"\n") {
    write("sounds/ring.wav", wav_of(tone(440, rate, rate), rate));
    replace("exhibits/hall.toml", "text.ar = \"قرص.\"\n",
            "text.ar = \"قرص.\"\n[[exhibit.sounds]]\n" + std::string(words) + std::string(rest));
  }
  test::ProgramRun check() const {
    return test::run_program("docent-content", "check '" + path().string() + "'");
  }
  Museum made(const std::string& options = "--no-speech") const {
    const test::ProgramRun run = compile(options);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    auto read = sqlite::load_museum(database());
    EXPECT_TRUE(read.has_value()) << read.error().what;
    return read.value_or(Museum{});
  }
};

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

TEST(CompileSounds, AreInTheDatabaseAsLoudAsSpeechWithWhatIsReadOfThem) {
  const MuseumWithSound museum("recording = \"sounds/ring.wav\"\ncaptions.en = \"sounds/r.vtt\"\n");
  museum.write("sounds/r.vtt", "WEBVTT\n\n00:00.000 --> 00:09.000\n[It rings]\n");

  const Museum read = museum.made();

  ASSERT_EQ(read.sounds.size(), 1U);
  EXPECT_EQ(read.sounds[0].exhibit, 0U);
  EXPECT_EQ(read.sounds[0].title.at("ar"), "رنين القرص");
  EXPECT_EQ(read.sounds[0].description.at("en"), "A clear note.");
  EXPECT_THAT(read.sound_cues, ElementsAre(SoundCue{.begin = 0, .end = 1000, .text = "[It rings]"}))
      << "it ends with its sound";
  const SpeechSound* sound = recording_of(read, 0, 1);
  ASSERT_NE(sound, nullptr) << "one for everybody";
  EXPECT_EQ(sound->samples, SpeechSound::rate);
  EXPECT_NEAR(std::sqrt(test::power(decoded(*sound))), 0.1, 0.02) << "-20 dB, as speech is";
}

TEST(CompileSounds, AreHeardInTheLanguageThatTheyAreSpokenInOrElseInTheFirst) {
  const MuseumWithSound museum("spoken.en = \"sounds/ring.wav\"\nspoken.ar = \"sounds/ar.opus\"\n");
  museum.write("sounds/ar.opus", test::ogg_of(tone(300, 24'000, 12'000)));

  const Museum read = museum.made();

  ASSERT_NE(recording_of(read, 0, 1), nullptr);
  EXPECT_EQ(recording_of(read, 0, 0)->samples, SpeechSound::rate);
  EXPECT_EQ(recording_of(read, 0, 1)->samples, SpeechSound::rate / 2);
}

TEST(CompileSounds, TellInWhichLanguagesThereIsNone) {
  const MuseumWithSound museum("spoken.ar = \"sounds/ring.wav\"\ncaptions.ar = \"sounds/r.vtt\"\n");
  museum.write("sounds/r.vtt", "WEBVTT\n\n00:00.000 --> 00:01.000\nرنين\n");

  const test::ProgramRun run = museum.check();

  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("warning[recording-missing]: a sound has no recording in en"));
  EXPECT_THAT(run.err, HasSubstr("warning[captions-missing]: a sound has no captions in en"));
  const Museum read = museum.made();
  EXPECT_EQ(recording_of(read, 0, 0), recording_of(read, 0, 1)) << "another language's is heard";
  EXPECT_EQ(cues_of_sound(read, 0, 0).size(), 1U) << "and read";
}

TEST(CompileSounds, AreTakenOverWhereNothingChanged) {
  const MuseumWithSound museum;
  const Museum first = museum.made("");
  const auto made_of = recording_of(first, 0, 0)->made_of;

  const Museum again = museum.made("");
  EXPECT_EQ(recording_of(again, 0, 0)->made_of, made_of);
  EXPECT_EQ(recording_of(again, 0, 0)->packets, recording_of(first, 0, 0)->packets);

  museum.write("sounds/ring.wav", wav_of(tone(600, rate, rate), rate));
  EXPECT_NE(recording_of(museum.made(), 0, 0)->made_of, made_of);
}

/// What staff write wrongly, and what they are told.
struct Mistake {
  std::string_view rest, told;
};

TEST(CompileSounds, TellWhatIsWrongWithItsLine) {
  for (const auto& [rest, told] : {
           Mistake{"",
                   "hall.toml:10:1: error[missing-field]: sound 1 of exhibit 'jade-disc' has "
                   "no recording"},
           Mistake{"recording = \"sounds/ring.wav\"\nspoken.en = \"sounds/ring.wav\"\n",
                   "error[bad-value]: sound 1 of exhibit 'jade-disc' has both a recording for "
                   "everybody and some by language"},
           Mistake{"recording = \"sounds/rung.wav\"\n", "hall.toml:15:13: error["},
           Mistake{"spoken.fr = \"sounds/ring.wav\"\n",
                   "error[unknown-language]: a recording is given in 'fr', which the museum does "
                   "not speak"},
           Mistake{"spoken.en = \"sounds/rung.wav\"\n", "hall.toml:15:13: error["},
           Mistake{"recording = \"sounds/ring.wav\"\ncaptions.en = \"sounds/r.vtt\"\n",
                   "hall.toml:16:15: error["},
           Mistake{"recording = \"images/disc.svg\"\n",
                   "hall.toml:15:13: error[unreadable-recording]: 'images/disc.svg': this is no "
                   "sound that docent knows"},
           Mistake{"recording = \"sounds/ring.wav\"\nvolume = 3\n", "error[unknown-key]"},
       }) {
    const MuseumWithSound museum(rest);
    const test::ProgramRun run = museum.check();
    EXPECT_EQ(run.exit_code, 1) << rest;
    EXPECT_THAT(run.err, HasSubstr(told)) << rest;
  }
}

TEST(CompileSounds, AreNeitherTooLongNorTooShortNorSilent) {
  const std::vector<float> silence(rate, 0.0F);
  for (const auto& [samples, told] :
       {std::pair{tone(100, rate, 301 * rate),
                  "error[sound-too-long]: 'sounds/ring.wav': it lasts 301 s, and nobody stands and "
                  "listens for more than 300 s"},
        {tone(100, rate, rate / 10),
         "error[sound-too-short]: 'sounds/ring.wav': it lasts only 0.1"},
        {silence, "error[silent-sound]: 'sounds/ring.wav': nothing is heard in it"}}) {
    const MuseumWithSound museum;
    museum.write("sounds/ring.wav", wav_of(samples, rate));

    const test::ProgramRun run = museum.check();

    EXPECT_EQ(run.exit_code, 1);
    EXPECT_THAT(run.err, AllOf(HasSubstr(told), HasSubstr("hint: "))) << run.err;
  }
}

TEST(CompileSounds, AreAtMostFourOfAnExhibit) {
  std::string rest = "recording = \"sounds/ring.wav\"\n";
  for (int i = 0; i < 4; ++i)
    rest.append("[[exhibit.sounds]]\n").append(words).append("recording = \"sounds/ring.wav\"\n");
  const MuseumWithSound museum(rest);

  const test::ProgramRun run = museum.check();

  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("exhibit 'jade-disc' has 5 sounds"));
}

TEST(CompileSounds, HaveATitleAndADescriptionInEachLanguage) {
  const MuseumWithSound museum;
  museum.replace("exhibits/hall.toml", "description.ar = \"نغمة صافية.\"\n", "");

  const test::ProgramRun run = museum.check();

  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("the description of sound 1 of exhibit 'jade-disc' is not "
                                 "translated into 'ar'"));
}

}  // namespace
}  // namespace docent::compile::compile_sounds_test
