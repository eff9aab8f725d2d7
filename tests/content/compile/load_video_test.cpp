#include "content/compile/load_video.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "config/museum_config.h"
#include "content/compile/compile_images.h"
#include "content/content_error.h"
#include "tests/support/made_video.h"
#include "tests/support/museum_folder.h"

namespace docent::compile::load_video_test {
namespace {

using test::make_video;
using test::MuseumFolder;
using test::VideoSketch;
using testing::HasSubstr;

/// The small museum with a video as the second picture of its disc.
struct MuseumWithVideo : MuseumFolder {
  explicit MuseumWithVideo(const std::string& video) {
    write("images/turning.webm", video);
    replace("exhibits/hall.toml", "text.ar = \"قرص.\"\n",
            "text.ar = \"قرص.\"\n"
            "[[exhibit.pictures]]\nimage = \"images/turning.webm\"\n");
  }
};

std::string fault_of(const std::string& video) {
  const MuseumWithVideo museum(video);
  const test::ProgramRun run =
      test::run_program("docent-content", "check '" + museum.path().string() + "'");
  EXPECT_EQ(run.exit_code, 1) << run.err;
  EXPECT_THAT(run.err,
              HasSubstr("hall.toml:11:9: error[unreadable-video]: 'images/turning.webm': "));
  EXPECT_THAT(run.err, HasSubstr("hint: ffmpeg -i FILM -an -c:v libvpx-vp9 -b:v 1400k"));
  return run.err;
}

TEST(LoadVideo, KeepsItsFileAsItIs) {
  const test::TemporaryFolder folder;
  const std::string video = make_video({.width = 320, .height = 180, .frames = 12});
  std::ofstream(folder.path() / "a.webm", std::ios::binary) << video;

  const LoadedVideo loaded = load_video(folder.path() / "a.webm", "a.webm");

  EXPECT_EQ(loaded.image.width, 320U);
  EXPECT_EQ(loaded.image.height, 180U);
  EXPECT_TRUE(std::ranges::equal(loaded.image.bytes, test::bytes_of(video)));
  EXPECT_FALSE(loaded.has_sound);
}

TEST(LoadVideo, IsNoExhibitsFirstPicture) {
  const MuseumWithVideo museum(make_video({}));
  museum.replace("exhibits/hall.toml", "images/disc.svg", "images/turning.webm");

  const test::ProgramRun run = museum.compile();

  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("hall.toml:5:9: error[video-as-first-picture]"));
}

TEST(LoadVideo, HasANameThatSaysSo) {
  const MuseumWithVideo museum(make_video({}));
  museum.write("images/disc.svg", make_video({}));
  EXPECT_THAT(museum.compile().err,
              HasSubstr("this is a video, and its name does not end in .webm"));
}

TEST(LoadVideo, IsTakenWhereAPictureIsNamedAndTold) {
  const MuseumWithVideo museum(make_video({.has_sound = true}));

  const test::ProgramRun run = museum.compile();

  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("warning[video-silent]: the sound of the video "
                                 "'images/turning.webm' is left out"));
}

TEST(LoadVideo, RefusesWhatNoKioskPlaysWithItsPlaceAndARemedy) {
  const std::string whole = make_video({});
  EXPECT_THAT(fault_of(whole.substr(0, whole.size() / 2)),
              HasSubstr("damaged or cut short, at byte"));
  EXPECT_THAT(fault_of(make_video({.says_width = 640, .says_height = 480})),
              HasSubstr("frame 1 of this video is 64 x 48 pixels, and the video says 640 x 480"));
  EXPECT_THAT(fault_of(make_video({.says_codec = "V_AV1"})), HasSubstr("coded as AV1"));
  EXPECT_THAT(fault_of(make_video({.says_width = 1920, .says_height = 1080})),
              HasSubstr("this video is 1920 x 1080 pixels; at most 1280 x 720 are played"));
  EXPECT_THAT(fault_of(make_video({.frames = 0})), HasSubstr("holds no frame"));
  EXPECT_THAT(fault_of(make_video({.says_kind = "matroska"})), HasSubstr("Matroska video (MKV)"));
  EXPECT_THAT(fault_of(make_video({.milliseconds_a_frame = 8})), HasSubstr("125 frames a second"));
}

TEST(LoadVideo, RefusesAFrameThatIsDamaged) {
  std::vector<std::string> frames = test::coded_frames({});
  frames[4] = std::string(frames[4].size(), '\x7f');

  EXPECT_THAT(fault_of(make_video({}, frames)), HasSubstr("frame 5 of this video is damaged"));
}

TEST(LoadVideo, RefusesPixelsThatAreNotSquare) {
  EXPECT_THAT(fault_of(make_video({.says_shown_width = 80, .says_shown_height = 48})),
              HasSubstr("the pixels of this video are 1.25 times as wide as they are high"));
}

/// How a command of the shell ends; what it says is nobody's.
int ended(const std::string& command) {
  return std::system(
      ("(" + command + ") >/dev/null 2>&1").c_str());  // NOLINT(bugprone-command-processor)
}

/// Does the command that `check` names as the remedy make of a film what `check` takes? `film`: how
/// ffmpeg makes one.
void expect_remedied(const std::string& film) {
  const MuseumWithVideo museum("no video");
  const std::string told =
      test::run_program("docent-content", "check '" + museum.path().string() + "'").err;
  const std::size_t begin = told.find("hint: ffmpeg") + 6, end = told.find(" makes one", begin);
  ASSERT_NE(end, std::string::npos) << told;
  std::string remedy = told.substr(begin, end - begin);
  const std::size_t name = remedy.find("FILM"), made = remedy.find("turning.webm");
  ASSERT_TRUE(name != std::string::npos && made != std::string::npos) << remedy;
  const test::TemporaryFolder folder;
  const std::string source = "'" + (folder.path() / "film.mkv").string() + "'";
  remedy.replace(made, 12, "-y '" + (museum.path() / "images/turning.webm").string() + "'");
  remedy.replace(name, 4, source);

  ASSERT_EQ(ended("ffmpeg -f lavfi -i " + film + " " + source), 0);
  ASSERT_EQ(ended(remedy), 0) << remedy;

  const test::ProgramRun checked =
      test::run_program("docent-content", "check '" + museum.path().string() + "'");
  EXPECT_EQ(checked.exit_code, 0) << film << '\n' << checked.err;
}

TEST(LoadVideo, SaysHowNearlyAnyFilmBecomesOne) {
  if (ended("ffmpeg -version") != 0) GTEST_SKIP() << "ffmpeg is not here";
  expect_remedied("testsrc2=s=1920x804:r=24:d=0.2 -c:v ffv1 -pix_fmt yuv422p10le");  // 2.39:1
  expect_remedied("testsrc2=s=720x576:r=50:d=0.2 -c:v mpeg2video -aspect 16:9");     // a DVD
  expect_remedied("testsrc2=s=540x960:r=60:d=0.2 -c:v ffv1 -pix_fmt yuv444p");       // a telephone
  expect_remedied("testsrc2=s=321x101:r=12:d=0.5 -c:v ffv1");
}

TEST(LoadVideo, TellsOfMoreThanAKioskMayReadInto) {
  const std::string video = make_video({});
  const MuseumWithVideo folder(video);
  const config::MuseumConfig config = *config::load_museum_config(folder.path()).value;
  const auto told = [&](std::size_t many_bytes) {
    Museum museum;
    museum.exhibits.resize(2);
    museum.pictures = {{.exhibit = 0}};
    Report report;
    compile_images(config, Images::Check, 1, museum, report, many_bytes);
    return report.in_order();
  };

  EXPECT_TRUE(told(video.size()).empty());
  const std::vector<Diagnostic> more = told(video.size() - 1);
  ASSERT_EQ(more.size(), 1U);
  EXPECT_EQ(more[0].code, "videos-large");
  EXPECT_EQ(more[0].severity, Severity::Warning);
  EXPECT_THAT(more[0].message, HasSubstr("images/turning.webm"));
}

}  // namespace
}  // namespace docent::compile::load_video_test
