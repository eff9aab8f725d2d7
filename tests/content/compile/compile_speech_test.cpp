#include "content/compile/compile_speech.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "runtime/interface/utterance.h"
#include "tests/support/museum_folder.h"
#include "tests/support/small_museum.h"
#include "tests/support/tone_voice.h"

namespace docent::compile::compile_speech_test {
namespace {

using test::InPath;
using test::MuseumFolder;
using test::ToneVoice;
using testing::HasSubstr;

/// A museum that says little, and what its staff wrote.
struct Staff {
  test::TemporaryFolder folder;
  config::MuseumConfig config;
  Museum museum = test::small_museum();
  Report report;

  Staff() {
    museum.speech.clear();
    for (Language& language : museum.languages) {
      language.words.clear();
      config.languages.push_back(language.tag);
    }
    config.folder = folder.path();
    config.files = {"museum.toml"};
  }

  void write(const std::string& language, const std::string& text, const std::string& recording,
             const std::string& reading = {}) {
    config::SpeechSection section;
    section.language = {language, {}, true};
    section.text = {text, {}, true};
    section.recording = {recording, {}, !recording.empty()};
    section.reading = {reading, {}, !reading.empty()};
    config.speech.push_back(section);
  }

  void make(const std::vector<SpeechSound>& before = {}) {
    compile_speech(config, Speech::Make, before, 2, museum, report);
  }
};

TEST(CompileSpeech, MakesASoundForEveryPieceOfEachLanguage) {
  const ToneVoice voice(0.1);
  const InPath path(std::filesystem::path(voice.program()).parent_path());
  Staff staff;

  staff.make();

  EXPECT_TRUE(staff.report.in_order().empty());
  for (std::uint32_t language = 0; language < staff.museum.languages.size(); ++language)
    for (const std::string& piece : interface::spoken_pieces(staff.museum, language))
      EXPECT_NE(find_sound(staff.museum.speech, language, piece), nullptr) << piece;
}

TEST(CompileSpeech, SaysOnceThatThereIsNoVoiceAndGoesOn) {
  const test::TemporaryFolder empty;
  const std::string before = std::getenv("PATH");
  ::setenv("PATH", empty.path().c_str(), 1);
  Staff staff;

  staff.make();

  ::setenv("PATH", before.c_str(), 1);
  EXPECT_TRUE(staff.museum.speech.empty());
  const auto told = staff.report.in_order();
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0].severity, Severity::Warning);
  EXPECT_EQ(
      told[0].message,
      "nothing is spoken: espeak-ng: the program is not there; install the package espeak-ng");
}

TEST(CompileSpeech, TellsWhatIsWrongWithARecording) {
  Staff staff;
  std::ofstream(staff.folder.path() / "hello.amr") << "#!AMR and so on";
  staff.write("en", "Jade disc", "hello.amr");
  staff.write("tlh", "Jade disc", {}, "baj");
  staff.write("en", "Jade dish", {}, "jade dish");

  compile_speech(staff.config, Speech::Check, {}, 1, staff.museum, staff.report);

  const auto told = staff.report.in_order();
  ASSERT_EQ(told.size(), 3U);
  EXPECT_THAT(told[0].message, HasSubstr("'hello.amr': this is an AMR file"));
  EXPECT_EQ(told[0].severity, Severity::Error);
  EXPECT_THAT(told[1].message, HasSubstr("the museum does not speak 'tlh'"));
  EXPECT_THAT(told[2].message, HasSubstr("never says 'Jade dish' by itself"));
  EXPECT_EQ(told[2].severity, Severity::Warning);
}

TEST(CompileSpeech, LetsARecordingWin) {
  ToneVoice voice(0.1);
  const InPath path(std::filesystem::path(voice.program()).parent_path());
  Staff staff;
  const ToneVoice other(0.7);
  std::filesystem::copy_file(std::filesystem::path(other.program()).parent_path() / "tone.wav",
                             staff.folder.path() / "disc.wav");
  staff.write("en", "Jade disc", "disc.wav");

  staff.make();

  EXPECT_TRUE(staff.report.in_order().empty());
  const SpeechSound* sound = find_sound(staff.museum.speech, 0, "Jade disc");
  ASSERT_NE(sound, nullptr);
  EXPECT_NEAR(sound->samples, 0.7 * SpeechSound::rate, 200);
  const std::size_t said = voice.said();
  EXPECT_EQ(said, staff.museum.speech.size() - 1);

  Staff again;
  std::filesystem::copy_file(staff.folder.path() / "disc.wav", again.folder.path() / "disc.wav");
  again.write("en", "Jade disc", "disc.wav");
  again.make(staff.museum.speech);
  EXPECT_EQ(voice.said(), 0U);
  EXPECT_EQ(again.museum.speech.size(), staff.museum.speech.size());
}

TEST(CompileSpeech, SectionsWithoutASoundAreTold) {
  const MuseumFolder museum;
  std::ofstream(museum.path() / "museum.toml", std::ios::app)
      << "[[speech]]\nlanguage = \"en\"\ntext = \"Jade disc\"\n"
         "[[speech]]\nlanguage = \"en\"\ntext = \"Hall\"\nrecording = \"speech/none.wav\"\n";

  const auto run = museum.compile();

  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("[[speech]] has neither a recording nor a reading"));
  EXPECT_THAT(run.err, HasSubstr("speech/none.wav"));
}

}  // namespace
}  // namespace docent::compile::compile_speech_test
