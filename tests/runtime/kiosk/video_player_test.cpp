#include "runtime/kiosk/video_player.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>

#include "platform/headless/headless_display.h"
#include "tests/support/kiosk_run.h"
#include "tests/support/made_video.h"
#include "tests/support/museum_folder.h"

namespace docent::kiosk::video_player_test {
namespace {

constexpr auto texture = scene::TextureId{1};

/// A player of one video of 10 frames, 25 a second, in a texture of 32 by 24 pixels.
class TheVideoPlayer : public ::testing::Test {
 protected:
  void SetUp() override {
    auto display = headless::open_headless({64, 64});
    if (!display) GTEST_SKIP() << display.error().what;
    display_ = std::move(*display);
    holdings_.emplace();
    holdings_->add_image(texture, {32, 24, std::vector<std::byte>(std::size_t{4} * 32 * 24)});
  }

  /// Is another frame shown at that time of the video?
  bool shows(float seconds, bool plays = true, gles::Holdings::Size size = {32, 24}) {
    player_.want(VideoPlayer::Wish{
        .image = 0, .texture = texture, .size = size, .seconds = seconds, .plays = plays});
    player_.wait();
    return player_.upload_next(*holdings_);
  }
  /// Does the player hold anything of a video's bytes?
  bool is_held() {
    player_.wait();
    return is_held_;
  }

  std::string video_ = test::make_video({});
  std::unique_ptr<headless::HeadlessDisplay> display_;
  std::optional<gles::Holdings> holdings_;
  /// The test's only image, and whether anybody has it.
  struct OneVideo : BlobArchive {
    explicit OneVideo(TheVideoPlayer& test) : of(test) {}
    std::span<const std::byte> read(std::uint32_t image) override {
      of.is_held_ = of.is_whole_ = image == 0;
      return image == 0 ? test::bytes_of(of.video_) : std::span<const std::byte>();
    }
    bool read_part(std::uint32_t image, std::size_t from, std::span<std::byte> out) override {
      if (image != 0 || from > of.video_.size() || out.size() > of.video_.size() - from)
        return false;
      of.is_held_ = true;
      of.is_whole_ = false;
      std::ranges::copy(test::bytes_of(of.video_).subspan(from, out.size()), out.begin());
      return true;
    }
    void let_go() noexcept override { of.is_held_ = of.is_whole_ = false; }
    TheVideoPlayer& of;
  };

  std::atomic<bool> is_held_ = false, is_whole_ = false;
  VideoPlayer player_{std::make_shared<OneVideo>(*this)};
};

TEST_F(TheVideoPlayer, ShowsEachFrameOnceWhenItIsDue) {
  EXPECT_TRUE(shows(0)) << "its first frame, at once";
  EXPECT_FALSE(shows(0.02F));
  EXPECT_TRUE(shows(0.041F));
  EXPECT_FALSE(shows(0.06F));
  for (int frame = 2; frame < 10; ++frame)
    EXPECT_TRUE(shows(0.001F + 0.04F * static_cast<float>(frame))) << frame;

  EXPECT_EQ(player_.counters().shown, 10U);
  EXPECT_EQ(player_.counters().dropped, 0U);
}

TEST_F(TheVideoPlayer, LeavesOutWhatComesTooLate) {
  EXPECT_TRUE(shows(0));
  while (shows(0.3F)) {
  }

  const VideoCounters counters = player_.counters();
  EXPECT_EQ(counters.shown + counters.dropped, 8U) << "frames of 0 to 280 ms";
  EXPECT_GT(counters.dropped, 0U);
}

TEST_F(TheVideoPlayer, EndsAndBeginsAgain) {
  EXPECT_TRUE(shows(0));
  EXPECT_FALSE(player_.has_ended());
  shows(0.41F);
  EXPECT_TRUE(player_.has_ended());

  EXPECT_TRUE(shows(0)) << "the first frame again";
  EXPECT_FALSE(player_.has_ended());
}

TEST_F(TheVideoPlayer, GoesOnWhereItIsInAnotherSize) {
  EXPECT_TRUE(shows(0));
  EXPECT_TRUE(shows(0.201F));
  player_.wait();
  const std::uint64_t shown = player_.counters().shown, dropped = player_.counters().dropped;

  holdings_->release(texture);
  holdings_->add_image(texture, {16, 12, std::vector<std::byte>(std::size_t{4} * 16 * 12)});
  EXPECT_TRUE(shows(0.21F, true, {16, 12})) << "what is due, at once";
  EXPECT_FALSE(shows(0.22F, true, {16, 12})) << "and nothing of what was before it";
  EXPECT_EQ(player_.counters().shown, shown + 1);
  EXPECT_EQ(player_.counters().dropped, dropped) << "nobody has missed what they had seen";
  EXPECT_TRUE(shows(0.241F, true, {16, 12}));
}

TEST_F(TheVideoPlayer, BeginsAnewWhereItIsForAnotherPicture) {
  constexpr auto other = scene::TextureId{2};
  holdings_->add_image(other, {32, 24, std::vector<std::byte>(std::size_t{4} * 32 * 24)});
  EXPECT_TRUE(shows(0, false)) << "it stands at its beginning";
  EXPECT_FALSE(shows(0, false));

  player_.want(VideoPlayer::Wish{.image = 0, .texture = other, .size = {32, 24}, .plays = false});
  player_.wait();
  EXPECT_TRUE(player_.upload_next(*holdings_)) << "as somebody else's does, too";
}

TEST_F(TheVideoPlayer, HoldsNothingWhileTheVideoStandsAtItsBeginning) {
  EXPECT_TRUE(shows(0, false)) << "its first frame, in the place of whatever was there";
  EXPECT_FALSE(is_held());
  EXPECT_FALSE(shows(0, false));
  EXPECT_FALSE(is_held());

  EXPECT_TRUE(shows(0.041F)) << "it is played";
  EXPECT_TRUE(is_held());
  EXPECT_FALSE(is_whole_) << "a frame at a time";
  EXPECT_FALSE(shows(0.042F, false));
  EXPECT_TRUE(is_held()) << "whoever has stopped it may go on";
  EXPECT_TRUE(shows(0, false)) << "it has come to its end";
  EXPECT_FALSE(is_held());
  EXPECT_FALSE(player_.has_ended());
}

TEST_F(TheVideoPlayer, IsAtItsEndWhereTheFileIsNotWhatItWas) {
  EXPECT_TRUE(shows(0));
  player_.wait();
  video_.resize(video_.size() / 2);
  shows(0.3F);
  shows(0.35F);

  EXPECT_TRUE(player_.has_ended());
}

TEST(AVideoPlayer, PlaysNothingWhereThereIsNoFile) {
  VideoPlayer player({});
  player.want(VideoPlayer::Wish{.image = 0, .size = {32, 24}});
  player.wait();

  EXPECT_TRUE(player.has_ended());
}

TEST_F(TheVideoPlayer, HoldsNothingOfWhatCannotBePlayed) {
  video_ = "nothing";
  EXPECT_FALSE(shows(0));
  EXPECT_TRUE(player_.has_ended());
  EXPECT_FALSE(shows(0, false));
  EXPECT_FALSE(is_held());

  video_ = test::make_video({}, std::vector<std::string>(10, "\x82 and no frame"));
  EXPECT_FALSE(shows(0.1F));
  EXPECT_TRUE(player_.has_ended());
  EXPECT_FALSE(shows(0, false));
  EXPECT_FALSE(is_held());
}

TEST_F(TheVideoPlayer, IsAtItsEndWhereAFrameIsDamagedOrThereIsNone) {
  std::vector<std::string> frames = test::coded_frames({});
  frames[3] = std::string(frames[3].size(), '\x7f');
  video_ = test::make_video({}, frames);
  shows(0);
  shows(0.2F);
  EXPECT_TRUE(player_.has_ended());

  player_.want({});
  player_.wait();
  video_ = "nothing";
  EXPECT_FALSE(shows(0));
  EXPECT_TRUE(player_.has_ended());
}

TEST_F(TheVideoPlayer, ShowsNothingOnceNobodyWatches) {
  EXPECT_TRUE(shows(0));
  player_.want({});
  player_.wait();

  EXPECT_FALSE(player_.upload_next(*holdings_));
  EXPECT_FALSE(player_.has_ended());
}

/// The small museum with a video of two seconds as its disc's second picture.
struct MuseumWithVideo : test::MuseumFolder {
  MuseumWithVideo() {
    write("images/turning.webm", test::make_video({.width = 320, .height = 180, .frames = 50}));
    replace("exhibits/hall.toml", "text.ar = \"قرص.\"\n",
            "text.ar = \"قرص.\"\n"
            "[[exhibit.pictures]]\nimage = \"images/turning.webm\"\n"
            "caption.en = \"It turns\"\ncaption.ar = \"يدور\"\n");
    const test::ProgramRun compiled = compile("--no-speech");
    EXPECT_EQ(compiled.exit_code, 0) << compiled.err;
  }
  /// What the kiosk counts in a visit, and tells.
  std::string visit(const std::string& what, const std::string& settings = {},
                    const std::string& size = "640x360") const {
    const test::TemporaryFolder folder;
    std::ofstream(folder.path() / "a.visit") << what;
    std::ofstream(folder.path() / "kiosk.toml") << settings;
    const auto stats = folder.path() / "stats.json";
    const test::ProgramRun run = test::run_program(
        "docent", "--content '" + database().string() + "' --config '" +
                      (folder.path() / "kiosk.toml").string() + "' --display headless --size " +
                      size + " --visit '" + (folder.path() / "a.visit").string() + "' --stats '" +
                      stats.string() + "'");
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return test::text_of(stats);
  }
};

TEST(AVideo, PlaysByItselfWhereOneLeafsToItAndStandsStillAtItsEnd) {
  const MuseumWithVideo museum;

  const std::string stats = museum.visit(
      "1 tap @exhibit:jade-disc\n30 tap @picture:next\n34 tap @video:play\n34.5 tap @video:stop\n"
      "36 tap @picture:next\n37 quit\n");

  EXPECT_NEAR(test::number_in(stats, "video_frames"), 50 + 1 + 12, 3)
      << "all of it, the first frame again, half a second, and no more";
  EXPECT_EQ(test::number_in(stats, "video_frames_dropped"), 0);
  EXPECT_EQ(test::number_in(stats, "allocations_in_frames"), 0);
}

TEST(AVideo, PlaysForEachOfTwoWhoShareAGlassWithoutTakingMemory) {
  const MuseumWithVideo museum;

  const std::string stats = museum.visit(
      "1 tap @look:teal seat 1\n2 tap @exhibit:jade-disc seat 1\n"
      "3 tap @look:rose seat 2\n4 tap @exhibit:jade-disc seat 2\n"
      "40 tap @picture:next seat 1\n40.5 tap @picture:next seat 2\n45 quit\n",
      "visitors = 2\nscreen_inches = 55\n", "1280x720");

  EXPECT_NEAR(test::number_in(stats, "video_frames"), 2 * (50 + 1), 4)
      << "all of it and the first frame again, on both cards";
  EXPECT_EQ(test::number_in(stats, "video_frames_dropped"), 0);
  EXPECT_EQ(test::number_in(stats, "allocations_in_frames"), 0);
}

TEST(AVideo, StandsStillUntilItIsTouchedWhereMotionIsReduced) {
  const MuseumWithVideo museum;

  const std::string stats = museum.visit(
      "1 tap @exhibit:jade-disc\n30 tap @picture:next\n34 quit\n", "reduced_motion = true\n");

  EXPECT_EQ(test::number_in(stats, "video_frames"), 1);
}

}  // namespace
}  // namespace docent::kiosk::video_player_test
