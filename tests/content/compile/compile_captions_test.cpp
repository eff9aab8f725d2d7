#include "content/compile/compile_captions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "platform/sqlite/content_reader.h"
#include "tests/support/made_video.h"
#include "tests/support/museum_folder.h"

namespace docent::compile::compile_captions_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// The small museum with a video of 400 ms as the second picture of its disc, and captions.
struct MuseumWithCaptions : test::MuseumFolder {
  explicit MuseumWithCaptions(std::string_view english, std::string_view arabic = {},
                              const test::VideoSketch& video = {}) {
    write("images/turning.webm", test::make_video(video));
    std::string captions = "captions.en = \"images/turning.en.vtt\"\n";
    write("images/turning.en.vtt", english);
    if (!arabic.empty()) {
      captions += "captions.ar = \"images/turning.ar.vtt\"\n";
      write("images/turning.ar.vtt", arabic);
    }
    replace("exhibits/hall.toml", "text.ar = \"قرص.\"\n",
            "text.ar = \"قرص.\"\n"
            "[[exhibit.pictures]]\nimage = \"images/turning.webm\"\n" +
                captions);
  }
  test::ProgramRun check() const {
    return test::run_program("docent-content", "check '" + path().string() + "'");
  }
};

TEST(CompileCaptions, AreInTheDatabaseInTheOrderOfTime) {
  const MuseumWithCaptions museum(
      "WEBVTT\n\n00:00.200 --> 00:09.000\n<i>Two</i>\n\n00:00.000 --> 00:00.300\nOne\n",
      "WEBVTT\n\n00:00.100 --> 00:00.200\nواحد\n");
  const test::ProgramRun run = museum.compile();
  ASSERT_EQ(run.exit_code, 0) << run.err;

  const auto read = sqlite::load_museum(museum.database());
  ASSERT_TRUE(read.has_value()) << read.error().what;
  EXPECT_THAT(read->cues,
              ElementsAre(Cue{.begin = 0, .end = 200, .text = "One"},
                          Cue{.begin = 200, .end = 300, .text = "One\nTwo"},
                          Cue{.begin = 300, .end = 400, .text = "Two"},
                          Cue{.language = 1, .begin = 100, .end = 200, .text = "واحد"}));
}

TEST(CompileCaptions, AreMissedInALanguageThatHasNone) {
  const MuseumWithCaptions museum("WEBVTT\n\n00:00.000 --> 00:00.300\nOne\n");

  const test::ProgramRun run = museum.check();
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("warning[captions-missing]: the video 'images/turning.webm' has "
                                 "no captions in ar"));
  EXPECT_THAT(run.err, HasSubstr("hint: write captions.ar = "));
}

TEST(CompileCaptions, TellWhereAFileIsWrong) {
  const MuseumWithCaptions museum("WEBVTT\n\n00:00,000 --> 00:00.300\nOne\n",
                                  "WEBVTT\n\n00:00.100 --> 00:00.200\nواحد\n");

  const test::ProgramRun run = museum.check();
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("turning.en.vtt:3:1: error[bad-caption-time]: '00:00,000' is no "
                                 "time"));
  EXPECT_THAT(run.err, HasSubstr("hint: write minutes, seconds and thousandths"));
}

TEST(CompileCaptions, TellOfWhatIsNoText) {
  const MuseumWithCaptions museum(std::string_view("\xFF\xFEW\0E\0B\0", 8),
                                  "WEBVTT\n\n00:00.100 --> 00:00.200\nواحد\n");

  const test::ProgramRun run = museum.check();
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("turning.en.vtt"));
  EXPECT_THAT(run.err, HasSubstr("UTF-16"));
}

TEST(CompileCaptions, TellOfWhatIsNeverRead) {
  const MuseumWithCaptions museum(
      "WEBVTT\n\n00:00.000 --> 00:00.300\nOne\n\n00:07.000 --> 00:08.000\nLate\n",
      "WEBVTT\n\n00:00.100 --> 00:00.200\nواحد\n");

  const test::ProgramRun run = museum.check();
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("turning.en.vtt:6:1: warning[caption-after-end]: this caption is "
                                 "never read: its video ends after 0.4 s"));
}

TEST(CompileCaptions, TellOfMoreThanAKioskShows) {
  std::string many = "WEBVTT\n";
  for (int i = 0; i < 101; ++i)
    many += "\n00:00." + std::to_string(100 + 2 * i) + " --> 00:00." + std::to_string(101 + 2 * i) +
            "\nA\n";
  std::string together = "WEBVTT\n";
  for (int i = 0; i < 4; ++i)
    together += "\n00:00.100 --> 00:00.200\n" + std::string(180, static_cast<char>('a' + i)) + "\n";
  const MuseumWithCaptions museum(many, together);

  const test::ProgramRun run = museum.check();
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("error[too-many-captions]: the captions of this video change 101 "
                                 "times, and a kiosk shows at most 100"));
  EXPECT_THAT(run.err, HasSubstr("error[caption-too-long]: at 0.1 s several captions are read at "
                                 "once, with 723 letters together"));
}

TEST(CompileCaptions, AreOfVideosAndOfTheMuseumsLanguages) {
  const MuseumWithCaptions museum("WEBVTT\n\n00:00.000 --> 00:00.300\nOne\n");
  museum.replace("exhibits/hall.toml", "captions.en", "captions.fr");
  EXPECT_THAT(museum.check().err,
              HasSubstr("error[unknown-language]: captions are given in 'fr', which the museum "
                        "does not speak"));
  museum.replace("exhibits/hall.toml", "captions.fr = \"images/turning.en.vtt\"",
                 "captions.en = \"images/turning.vtt\"");
  EXPECT_THAT(museum.check().err, HasSubstr("error[missing-file]"));
  museum.replace("exhibits/hall.toml", "images/turning.webm", "images/disc.svg");
  EXPECT_THAT(museum.check().err, HasSubstr("'images/disc.svg' is no video, and has no time for "
                                            "captions"));
}

TEST(CompileCaptions, AreAskedForWhereAVideoHasSoundAndNone) {
  const MuseumWithCaptions museum("WEBVTT\n\n00:00.000 --> 00:00.300\nOne\n", {},
                                  {.has_sound = true});
  EXPECT_THAT(museum.check().err, Not(HasSubstr("video-silent")));
  museum.replace("exhibits/hall.toml", "captions.en = \"images/turning.en.vtt\"\n", "");
  const test::ProgramRun without = museum.check();
  EXPECT_THAT(without.err, HasSubstr("warning[video-silent]"));
  EXPECT_THAT(without.err, HasSubstr("hint: write what is said and heard into a WebVTT file"));
}

}  // namespace
}  // namespace docent::compile::compile_captions_test
