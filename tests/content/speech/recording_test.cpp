#include "content/speech/recording.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <sndfile.h>

#include <span>
#include <string>

#include "content/content_error.h"
#include "tests/content/speech/made_recordings.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace docent::speech::recording_test {
namespace {

using test::ogg_of;
using test::power;
using test::tone;
using test::wav_of;
using testing::HasSubstr;

/// What is said about a recording of these bytes; empty where it is read.
std::string refusal(std::string_view bytes) {
  try {
    read_sound(bytes, "hello.wav");
    return {};
  } catch (const content::ContentError& error) {
    EXPECT_EQ(error.code, "unreadable-recording");
    EXPECT_EQ(error.file, "hello.wav");
    EXPECT_FALSE(error.hint.empty());
    return error.what();
  }
}

/// A file of one channel as libsndfile writes it.
std::string written_by_library(std::span<const float> samples, int rate, int format) {
  const test::TemporaryFolder folder;
  const std::string file = (folder.path() / "sound").string();
  SF_INFO info{.frames = 0,
               .samplerate = rate,
               .channels = 1,
               .format = format,
               .sections = 0,
               .seekable = 0};
  SNDFILE* out = sf_open(file.c_str(), SFM_WRITE, &info);
  EXPECT_NE(out, nullptr) << sf_strerror(nullptr);
  sf_write_float(out, samples.data(), static_cast<sf_count_t>(samples.size()));
  sf_close(out);
  return test::text_of(file);
}

RC_GTEST_PROP(RecordingProperty, AWavFileIsReadAsItWasWritten, ()) {
  const auto rate = *rc::gen::inRange<std::uint32_t>(8'000, 96'001);
  const auto channels = *rc::gen::inRange<std::uint32_t>(1, 7);
  const auto count = *rc::gen::inRange<std::size_t>(1, 2'000);
  const auto samples = tone(440, rate, count);

  const Pcm read = read_sound(wav_of(samples, rate, channels), "hello.wav");

  RC_ASSERT(read.rate == rate);
  RC_ASSERT(read.samples.size() == count);
  for (std::size_t i = 0; i < count; ++i)
    RC_ASSERT(std::abs(read.samples[i] - samples[i]) < 1.0F / 16000);
}

TEST(Recording, IsReadInEveryUsualWidth) {
  const auto samples = tone(300, 44'100, 4'410);
  for (const std::uint32_t bits : {8U, 16U, 24U, 32U, 33U}) {
    const Pcm read = read_sound(test::wav_of_bits(samples, 44'100, bits), "hello.wav");
    ASSERT_EQ(read.samples.size(), samples.size()) << bits;
    EXPECT_NEAR(power(read.samples) / power(samples), 1, 0.02) << bits;
  }
}

TEST(Recording, OfAStreamEndsWhereItEnds) {
  std::string bytes = wav_of(tone(300, 22'050, 100), 22'050);
  for (std::size_t i = 40; i < 44; ++i) bytes[i] = '\x7f';
  EXPECT_EQ(read_sound(bytes, "hello.wav").samples.size(), 100U);
}

TEST(Recording, OfOpusHasItsLengthAndLoudness) {
  const auto samples = tone(440, 24'000, 24'000);

  const Pcm read = read_sound(ogg_of(samples), "hello.opus");

  EXPECT_EQ(read.rate, 48'000U);
  EXPECT_EQ(read.samples.size(), 48'000U);
  EXPECT_NEAR(power(read.samples) / power(samples), 1, 0.2);
}

TEST(Recording, ThatIsNotReadIsCalledByItsName) {
  EXPECT_THAT(refusal("#!AMR and so on"), HasSubstr("an AMR file; WAV, FLAC"));
  EXPECT_THAT(refusal(std::string("\0\0\0\x20"
                                  "ftypM4A ",
                                  12)),
              HasSubstr("M4A"));
  EXPECT_THAT(refusal(""), HasSubstr("no sound that docent knows"));
}

/// What libsndfile reads; bytes that only begin like that are refused with its sentence.
TEST(Recording, OfALibrarysKindHasItsLengthAndLoudness) {
  const auto samples = tone(440, 44'100, 44'100);
  for (const int format : {SF_FORMAT_FLAC | SF_FORMAT_PCM_16, SF_FORMAT_AIFF | SF_FORMAT_PCM_16,
                           SF_FORMAT_OGG | SF_FORMAT_VORBIS, SF_FORMAT_OGG | SF_FORMAT_OPUS,
                           SF_FORMAT_MPEG | SF_FORMAT_MPEG_LAYER_III}) {
    const bool is_opus = format == (SF_FORMAT_OGG | SF_FORMAT_OPUS);
    const auto given = is_opus ? tone(440, 48'000, 48'000) : samples;
    const std::string bytes = written_by_library(given, is_opus ? 48'000 : 44'100, format);
    const Pcm read = read_sound(bytes, "hello");

    EXPECT_EQ(read.rate, is_opus ? 48'000U : 44'100U) << format;
    EXPECT_NEAR(static_cast<double>(read.samples.size()), static_cast<double>(given.size()), 2'400)
        << format;
    EXPECT_NEAR(power(read.samples) / power(given), 1, 0.2) << format;
  }
}

TEST(Recording, ThatOnlyBeginsLikeALibrarysKindIsRefused) {
  for (const char* begins : {"ID3\x04 and so on", "fLaC and so on", "\xff\xfb and so on"})
    EXPECT_THAT(refusal(begins),
                testing::AnyOf(HasSubstr("it cannot be read: "), HasSubstr("it holds no sound"),
                               HasSubstr("it is damaged")));
  const std::string vorbis = "\x01vorbis and so on";
  const std::uint8_t lacing[] = {static_cast<std::uint8_t>(vorbis.size())};
  EXPECT_THAT(refusal(test::ogg_page(vorbis, lacing, 0, 0)), HasSubstr("it cannot be read: "));
}

/// Whatever is cut off or spoilt: a sentence, or what is left.
TEST(Recording, OfALibrarysKindIsReadOrRefusedHoweverItIsSpoilt) {
  const std::string flac =
      written_by_library(tone(440, 44'100, 8'820), 44'100, SF_FORMAT_FLAC | SF_FORMAT_PCM_16);
  for (std::size_t at = 0; at < flac.size(); at += 97) {
    std::string spoilt = flac;
    spoilt[at] = static_cast<char>(spoilt[at] ^ 0x55);
    for (const std::string& bytes : {spoilt, flac.substr(0, at)}) {
      try {
        EXPECT_FALSE(read_sound(bytes, "hello").samples.empty());
      } catch (const content::ContentError& error) {
        EXPECT_EQ(error.code, "unreadable-recording");
        EXPECT_FALSE(error.hint.empty());
      }
    }
  }
}

TEST(Recording, ThatIsCutShortIsRefused) {
  const std::string wav = wav_of(tone(300, 22'050, 2'000), 22'050);
  EXPECT_THAT(refusal(wav.substr(0, 3'000)), HasSubstr("cut short"));
  EXPECT_THAT(refusal(wav.substr(0, 30)), HasSubstr("cut short"));
  EXPECT_THAT(refusal(wav.substr(0, 44)), HasSubstr("cut short"));
  const std::string ogg = ogg_of(tone(300, 24'000, 24'000));
  EXPECT_THAT(refusal(ogg.substr(0, ogg.size() - 5)), HasSubstr("cut short"));
}

TEST(Recording, ThatLiesIsRefused) {
  std::string wav = wav_of(tone(300, 22'050, 200), 22'050);
  wav[22] = '\x7f';  // channels
  EXPECT_THAT(refusal(wav), HasSubstr("127 channels"));
  wav[22] = 1;
  wav[25] = wav[24] = 0;  // samples a second
  EXPECT_THAT(refusal(wav), HasSubstr("0 samples a second; 8000 to 192000 are read"));
  wav[20] = '\x55';
  EXPECT_THAT(refusal(wav), HasSubstr("kind 85 with 16 bits, which is not read"));
}

TEST(Recording, OfOpusWithAChangedByteIsRefused) {
  const std::string ogg = ogg_of(tone(300, 24'000, 12'000));
  for (std::size_t at = 0; at < ogg.size(); at += 7) {
    std::string changed = ogg;
    changed[at] = static_cast<char>(changed[at] ^ 0x20);
    EXPECT_NE(refusal(changed), "") << at;
  }
}

RC_GTEST_PROP(RecordingProperty, AnyChangeIsASoundOrASentence, ()) {
  const bool is_ogg = *rc::gen::arbitrary<bool>();
  static const std::string whole_wav = wav_of(tone(300, 22'050, 900), 22'050, 2);
  static const std::string whole_ogg = ogg_of(tone(300, 24'000, 2'400));
  std::string bytes = is_ogg ? whole_ogg : whole_wav;
  for (int changes = *rc::gen::inRange(1, 6); changes > 0; --changes)
    bytes[*rc::gen::inRange<std::size_t>(0, std::min<std::size_t>(bytes.size(), 100))] =
        *rc::gen::arbitrary<char>();
  bytes.resize(*rc::gen::inRange<std::size_t>(0, bytes.size() + 1));
  try {
    const Pcm read = read_sound(bytes, "hello");
    RC_ASSERT(!read.samples.empty());
    for (const float sample : read.samples) RC_ASSERT(std::abs(sample) <= 1.001F);
  } catch (const content::ContentError& error) {
    RC_ASSERT(!std::string(error.what()).empty());
  }
}

}  // namespace
}  // namespace docent::speech::recording_test
