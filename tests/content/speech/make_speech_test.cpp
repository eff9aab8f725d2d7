#include "content/speech/make_speech.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/content/speech/made_recordings.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/tone_voice.h"

namespace docent::speech::make_speech_test {
namespace {

using test::tone;
using test::ToneVoice;
using testing::HasSubstr;

constexpr const char* nobody = "nobody-of-docent";  // no such program

std::vector<WantedSpeech> two_languages() {
  return {{.language = 0, .tag = "en", .pieces = {"left", "door"}},
          {.language = 1, .tag = "ja", .pieces = {"館"}}};
}

TEST(MakeSpeech, SpeaksLanguagesWhoseVoiceReadsThem) {
  ToneVoice voice;
  const auto wanted = two_languages();

  const MadeSpeech made = make_speech(
      {.wanted = wanted, .own = {}, .before = {}, .program = voice.program(), .reader = nobody});

  ASSERT_EQ(made.sounds.size(), 2U);
  EXPECT_EQ(made.sounds[0].text, "door");
  EXPECT_EQ(made.sounds[1].text, "left");
  EXPECT_NEAR(made.sounds[0].samples, 48'000, 100);
  const auto held = samples_of_packets(made.sounds[0].packets);
  ASSERT_TRUE(held.has_value());
  EXPECT_GE(*held, made.sounds[0].skip + made.sounds[0].samples);
  EXPECT_EQ(made.languages[0].silent, "");
  EXPECT_NEAR(made.languages[0].seconds, 2, 0.01);
  EXPECT_THAT(made.languages[1].silent, HasSubstr("does not know the script"));
}

TEST(MakeSpeech, MakesOnlyAnewWhatHasChanged) {
  ToneVoice voice;
  auto wanted = two_languages();
  const MadeSpeech first = make_speech(
      {.wanted = wanted, .own = {}, .before = {}, .program = voice.program(), .reader = nobody});
  EXPECT_EQ(voice.said(), 2U);

  const MadeSpeech same = make_speech({.wanted = wanted,
                                       .own = {},
                                       .before = first.sounds,
                                       .program = voice.program(),
                                       .reader = nobody});
  EXPECT_EQ(voice.said(), 0U);
  EXPECT_EQ(same.languages[0].taken_over, 2U);
  ASSERT_EQ(same.sounds.size(), 2U);
  EXPECT_EQ(same.sounds[1].packets, first.sounds[1].packets);

  wanted[0].pieces.push_back("right");
  const MadeSpeech more = make_speech({.wanted = wanted,
                                       .own = {},
                                       .before = first.sounds,
                                       .program = voice.program(),
                                       .reader = nobody});
  EXPECT_EQ(voice.said(), 1U);
  EXPECT_EQ(more.sounds.size(), 3U);
}

TEST(MakeSpeech, GivesTheSameForAnyNumberOfThreads) {
  ToneVoice voice;
  std::vector<WantedSpeech> wanted(1);
  wanted[0].tag = "en";
  for (int i = 0; i < 20; ++i) wanted[0].pieces.push_back(std::to_string(i));

  const MadeSpeech one = make_speech({.wanted = wanted,
                                      .own = {},
                                      .before = {},
                                      .program = voice.program(),
                                      .reader = nobody,
                                      .jobs = 1});
  const MadeSpeech four = make_speech({.wanted = wanted,
                                       .own = {},
                                       .before = {},
                                       .program = voice.program(),
                                       .reader = nobody,
                                       .jobs = 4});

  ASSERT_EQ(one.sounds.size(), 20U);
  ASSERT_EQ(four.sounds.size(), 20U);
  for (std::size_t i = 0; i < 20; ++i) {
    EXPECT_EQ(one.sounds[i].text, four.sounds[i].text);
    EXPECT_EQ(one.sounds[i].made_of, four.sounds[i].made_of);
    EXPECT_EQ(one.sounds[i].packets, four.sounds[i].packets);
  }
}

TEST(MakeSpeech, LetsAReadingTeachAVoiceItsScript) {
  ToneVoice voice;
  const auto wanted = two_languages();
  OwnSpeech own;
  own.language = 1;
  own.text = "館";
  own.reading = "かん";

  const MadeSpeech made = make_speech({.wanted = wanted,
                                       .own = {&own, 1},
                                       .before = {},
                                       .program = voice.program(),
                                       .reader = nobody});

  ASSERT_EQ(made.sounds.size(), 3U);
  EXPECT_EQ(made.sounds[2].text, "館");
  EXPECT_EQ(made.languages[1].silent, "");
}

TEST(MakeSpeech, HasKanjiReadWhereSomebodyReadsThem) {
  ToneVoice voice;
  const test::TemporaryFolder folder;
  const auto reader = folder.path() / "mecab";
  std::ofstream(reader) << "#!/bin/sh\n[ \"$1\" = -D ] && echo 'charset: utf8' && exit 0\n"
                           "cat >/dev/null\nprintf '館\\t名詞\\t一般\\tカン\\nEOS\\n'\n";
  std::filesystem::permissions(reader, std::filesystem::perms::owner_all);
  const auto wanted = two_languages();

  const MadeSpeech made = make_speech({.wanted = wanted,
                                       .own = {},
                                       .before = {},
                                       .program = voice.program(),
                                       .reader = reader.string()});

  ASSERT_EQ(made.sounds.size(), 3U);
  EXPECT_EQ(made.sounds[2].text, "館");
  EXPECT_EQ(made.languages[1].silent, "");
}

TEST(MakeSpeech, TellsWhatReadsJapaneseWhereNobodyDoes) {
  ToneVoice voice;
  const auto wanted = two_languages();

  const MadeSpeech made = make_speech(
      {.wanted = wanted, .own = {}, .before = {}, .program = voice.program(), .reader = nobody});

  EXPECT_THAT(made.languages[1].silent,
              HasSubstr("install the packages mecab and mecab-ipadic-utf8"));
}

TEST(MakeSpeech, PrefersRecordingsAndNeedsNoVoiceForThem) {
  const auto wanted = two_languages();
  OwnSpeech own;
  own.language = 1;
  own.text = "館";
  own.digest = "5a";
  own.recording = {44'100, tone(300, 44'100, 88'200)};

  const MadeSpeech made = make_speech(
      {.wanted = wanted, .own = {&own, 1}, .before = {}, .program = nobody, .reader = nobody});

  ASSERT_EQ(made.sounds.size(), 1U);
  EXPECT_EQ(made.sounds[0].language, 1U);
  EXPECT_NEAR(made.sounds[0].samples, 96'000, 200);
  EXPECT_EQ(made.languages[1].recorded, 1U);
  EXPECT_EQ(made.languages[0].silent,
            "nobody-of-docent: the program is not there; install the package espeak-ng");
}

TEST(MakeSpeech, SpeaksNoLanguageInPart) {
  auto wanted = two_languages();
  wanted[1].pieces.emplace_back("左");
  OwnSpeech own;
  own.language = 1;
  own.text = "館";
  own.digest = "5a";
  own.recording = {44'100, tone(300, 44'100, 88'200)};

  const MadeSpeech made = make_speech(
      {.wanted = wanted, .own = {&own, 1}, .before = {}, .program = nobody, .reader = nobody});

  EXPECT_TRUE(made.sounds.empty());
  EXPECT_THAT(made.languages[1].silent, HasSubstr("1 of 2 pieces are recorded"));
}

}  // namespace
}  // namespace docent::speech::make_speech_test
