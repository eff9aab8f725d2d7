#include "runtime/video/webm.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/support/made_video.h"

namespace docent::video::webm_test {
namespace {

using test::bytes_of;
using test::make_video;
using test::VideoSketch;
using testing::HasSubstr;

/// Frames of no meaning that begin as those of VP9 do: the parser looks no farther.
std::vector<std::string> dummy_frames(std::size_t count) {
  std::vector<std::string> frames(count, "\x86 and so on");
  if (count > 0) frames[0] = std::string("\x82") + " key";
  return frames;
}

std::string dummy_video(const VideoSketch& sketch) {
  return make_video(sketch, dummy_frames(sketch.frames));
}

std::string fault_of(const std::string& file) {
  const Result<Video> video = read_webm(bytes_of(file));
  return video ? std::string() : video.error().what;
}

TEST(ReadWebm, FindsEachFrameWithItsTime) {
  const VideoSketch sketch{.width = 320, .height = 180, .frames = 20};
  const std::string file = dummy_video(sketch);

  const Result<Video> video = read_webm(bytes_of(file));

  ASSERT_TRUE(video.has_value()) << video.error().what;
  EXPECT_EQ(video->codec, Codec::Vp9);
  EXPECT_EQ(video->width, 320U);
  EXPECT_EQ(video->height, 180U);
  EXPECT_FALSE(video->has_sound);
  ASSERT_EQ(video->frames.size(), 20U);
  for (std::size_t i = 0; i < 20; ++i) {
    EXPECT_EQ(file.substr(video->frames[i].at, video->frames[i].size), dummy_frames(20)[i]);
    EXPECT_EQ(video->frames[i].milliseconds, 40 * i);
    EXPECT_EQ(video->frames[i].is_key, i == 0);
  }
  EXPECT_EQ(video->duration(), std::chrono::milliseconds(800));
}

TEST(ReadWebm, ReadsWhatABrowserRecordedWithoutSizes) {
  const VideoSketch sketch{.frames = 20, .is_streamed = true};
  const std::string streamed = dummy_video(sketch);

  const Result<Video> video = read_webm(bytes_of(streamed));

  ASSERT_TRUE(video.has_value()) << video.error().what;
  EXPECT_EQ(video->frames.size(), 20U);
}

TEST(ReadWebm, TellsOfSoundThatNobodyHears) {
  EXPECT_TRUE(read_webm(bytes_of(dummy_video({.has_sound = true})))->has_sound);
}

TEST(ReadWebm, KnowsTheFramesOfVp8ThatAreNeverShown) {
  // RFC 6386, section 9.1: key and shown; not key and not shown; not key and shown.
  const std::vector<std::string> frames{"\x10", "\x01", "\x11"};
  const std::string file = make_video({.codec = Codec::Vp8}, frames);

  const Result<Video> video = read_webm(bytes_of(file));

  ASSERT_TRUE(video.has_value());
  EXPECT_TRUE(video->frames[0].is_key);
  EXPECT_FALSE(video->frames[1].is_shown);
  EXPECT_EQ(video->shown(), 2U);
}

TEST(ReadWebm, RefusesWhatIsNoneWithASentence) {
  EXPECT_EQ(fault_of(""), "this file is empty");
  EXPECT_THAT(fault_of("GIF89a"), HasSubstr("this is no WebM video"));
  EXPECT_THAT(fault_of(dummy_video({.says_kind = "matroska"})), HasSubstr("Matroska video (MKV)"));
  EXPECT_THAT(fault_of(dummy_video({.says_codec = "V_AV1"})), HasSubstr("coded as AV1"));
  EXPECT_THAT(fault_of(dummy_video({.frames = 0})), HasSubstr("holds no frame"));
  EXPECT_THAT(fault_of(dummy_video({.first = 3})), HasSubstr("cut out of another"));
  EXPECT_THAT(fault_of(dummy_video({.says_width = 1U << 30U})), HasSubstr("1073741824 x 48"));
}

TEST(ReadWebm, RefusesAFileThatIsTooLargeBeforeItReadsIt) {
  const std::string file = dummy_video({});

  const Result<Video> video = read_webm(bytes_of(file), {.bytes = file.size() - 1});

  ASSERT_FALSE(video.has_value());
  EXPECT_THAT(video.error().what, HasSubstr("MB; at most"));
}

TEST(ReadWebm, RefusesTimesThatRunBackwards) {
  std::string file = dummy_video({.frames = 2, .is_streamed = true});
  file += test::element(0xA3, std::string("\x81\xff\x00\x00\x86", 5));

  EXPECT_THAT(fault_of(file), HasSubstr("frame 3 of this video is before the one before it"));
}

RC_GTEST_PROP(ReadWebmProperty, AVideoThatIsCutOffAnywhereIsSaidToBe, ()) {
  const std::string file = dummy_video({.frames = 20});
  const auto length = *rc::gen::inRange<std::size_t>(1, file.size());

  RC_ASSERT(!fault_of(file.substr(0, length)).empty());
}

RC_GTEST_PROP(ReadWebmProperty, NoFrameLiesOutsideOfADamagedFile, ()) {
  std::string file = dummy_video({.frames = 20});
  for (int i = 0; i < 3; ++i)
    file[*rc::gen::inRange<std::size_t>(0, file.size())] = *rc::gen::arbitrary<char>();

  const Result<Video> video = read_webm(bytes_of(file));

  if (!video) return;
  std::uint32_t before = 0;
  for (const Frame& frame : video->frames) {
    RC_ASSERT(frame.size > 0U);
    RC_ASSERT(std::size_t{frame.at} + frame.size <= file.size());
    RC_ASSERT(frame.milliseconds >= before);
    before = frame.milliseconds;
  }
}

std::string beyond_of(const VideoSketch& sketch) {
  const std::string file = dummy_video(sketch);
  return beyond(*read_webm(bytes_of(file))).value_or("");
}

TEST(Beyond, TakesWhatAKioskPlays) {
  EXPECT_EQ(beyond_of({.width = 1280, .height = 720, .milliseconds_a_frame = 34}), "");
  EXPECT_EQ(beyond_of({.width = 720, .height = 1280, .milliseconds_a_frame = 33}), "");
  EXPECT_EQ(beyond_of({.frames = 1500}), "") << "a minute of 25 frames a second";
}

TEST(Beyond, SaysWhatIsTooMuch) {
  EXPECT_THAT(beyond_of({.width = 1920, .height = 1080}), HasSubstr("at most 1280 x 720"));
  EXPECT_THAT(beyond_of({.width = 1280, .height = 1280}), HasSubstr("at most 1280 x 720"));
  EXPECT_THAT(beyond_of({.frames = 1600}), HasSubstr("lasts 64 seconds; at most 60"));
  EXPECT_THAT(beyond_of({.frames = 60, .milliseconds_a_frame = 17}), HasSubstr("frames a second"));
  EXPECT_THAT(beyond_of({.frames = 1}), HasSubstr("a single frame"));
  EXPECT_THAT(beyond_of({.width = 8, .height = 8}), HasSubstr("too small"));
}

TEST(Beyond, SaysWhatWouldBeSqueezed) {
  // A DVD of a wide film, in pixels, and as a shape alone.
  EXPECT_THAT(beyond_of({.width = 720, .height = 576, .says_shown_width = 1024}),
              HasSubstr("are 1.42 times as wide as they are high"));
  EXPECT_THAT(beyond_of({.width = 720,
                         .height = 576,
                         .says_shown_width = 16,
                         .says_shown_height = 9,
                         .says_unit = 3}),
              HasSubstr("are 1.42 times as wide"));
  EXPECT_THAT(beyond_of({.width = 720, .height = 576, .says_shown_height = 810}),
              HasSubstr("are 0.71 times as wide"));
}

TEST(Beyond, TakesTheShapeThatRoundingMakes) {
  EXPECT_EQ(beyond_of({.width = 854,
                       .height = 480,
                       .says_shown_width = 16,
                       .says_shown_height = 9,
                       .says_unit = 3}),
            "");
  EXPECT_EQ(
      beyond_of({.width = 640, .height = 480, .says_shown_width = 1280, .says_shown_height = 960}),
      "")
      << "larger, and no other shape";
  EXPECT_EQ(beyond_of({.width = 640,
                       .height = 480,
                       .says_shown_width = 1,
                       .says_shown_height = 100,
                       .says_unit = 4}),
            "")
      << "a unit that nobody knows";
}

TEST(Beyond, SaysThatEdgesAreNotCutOff) {
  EXPECT_THAT(beyond_of({.width = 640, .height = 480, .says_cropped = 8}),
              HasSubstr("parts of it at its edges are not to be seen"));
}

}  // namespace
}  // namespace docent::video::webm_test
