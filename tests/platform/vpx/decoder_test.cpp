#include "platform/vpx/decoder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/support/made_video.h"

namespace docent::vpx::decoder_test {
namespace {

using test::bytes_of;
using test::VideoSketch;
using testing::HasSubstr;

/// What becomes of all frames of a file: the sentence about the first that is refused, with the
/// number that it has.
std::string fault_of(const std::string& file) {
  const auto video = video::read_webm(bytes_of(file));
  if (!video) return video.error().what;
  auto decoder = Decoder::open(*video);
  for (std::size_t i = 0; i < video->frames.size(); ++i) {
    const video::Frame& frame = video->frames[i];
    const auto planes = decoder->decode(bytes_of(file).subspan(frame.at, frame.size));
    if (!planes) return std::to_string(i + 1) + " " + planes.error().what;
  }
  return {};
}

class DecoderOf : public testing::TestWithParam<video::Codec> {};
INSTANTIATE_TEST_SUITE_P(Codecs, DecoderOf, testing::Values(video::Codec::Vp8, video::Codec::Vp9));

TEST_P(DecoderOf, ShowsTheBarWhereItIsInEachFrame) {
  const VideoSketch sketch{.codec = GetParam(), .width = 160, .height = 90, .frames = 8};
  const std::string file = test::make_video(sketch);
  const auto video = video::read_webm(bytes_of(file));
  ASSERT_TRUE(video.has_value()) << video.error().what;
  ASSERT_EQ(video->frames.size(), 8U);
  auto decoder = Decoder::open(*video);
  ASSERT_TRUE(decoder.has_value());

  for (std::size_t i = 0; i < 8; ++i) {
    const video::Frame& frame = video->frames[i];
    EXPECT_EQ(frame.is_key, i == 0);
    const auto planes = decoder->decode(bytes_of(file).subspan(frame.at, frame.size));
    ASSERT_TRUE(planes.has_value()) << planes.error().what;
    ASSERT_NE(planes->y, nullptr);
    const auto bright = [&](std::size_t x) { return std::to_integer<int>(planes->y[x]); };
    // Coded with losses: the ground is 126, the bar 220.
    EXPECT_GT(bright(20 * i + 3), 190) << i;
    EXPECT_NEAR(bright((20 * i + 80) % 160), 126, 20) << i;
  }
}

TEST_P(DecoderOf, RefusesAVideoThatLiesAboutItsSize) {
  const VideoSketch lie{.codec = GetParam(), .width = 64, .height = 48, .says_width = 32};

  EXPECT_EQ(fault_of(test::make_video(lie)), "1 is 64 x 48 pixels, and the video says 32 x 48");
}

TEST_P(DecoderOf, RefusesAFrameInTheMiddleThatIsLargerThanTheOthers) {
  VideoSketch sketch{.codec = GetParam(), .frames = 4};
  std::vector<std::string> frames = test::coded_frames(sketch);
  frames[2] =
      test::coded_frames({.codec = GetParam(), .width = 640, .height = 480, .frames = 1})[0];

  EXPECT_EQ(fault_of(test::make_video(sketch, frames)),
            "3 is 640 x 480 pixels, and the video says 64 x 48");
}

TEST_P(DecoderOf, GivesTheFirstPictureOfAFile) {
  const std::string file =
      test::make_video({.codec = GetParam(), .width = 160, .height = 90, .frames = 3});

  const Result<Pixels> picture = first_picture(bytes_of(file));

  ASSERT_TRUE(picture.has_value()) << picture.error().what;
  EXPECT_EQ(picture->width, 160U);
  EXPECT_EQ(picture->height, 90U);
  EXPECT_GT(std::to_integer<int>(picture->rgba[4 * 3]), 200) << "the bar is at the left";
  EXPECT_FALSE(first_picture(bytes_of("nothing")).has_value());
}

TEST_P(DecoderOf, AnyBytesInAFrameAreSurvived) {
  rc::check([&] {
    const VideoSketch sketch{.codec = GetParam(), .frames = 4};
    std::vector<std::string> frames = test::coded_frames(sketch);
    std::string& one = frames[*rc::gen::inRange<std::size_t>(0, 4)];
    for (int i = 0; i < 4; ++i)
      one[*rc::gen::inRange<std::size_t>(0, one.size())] = *rc::gen::arbitrary<char>();
    fault_of(test::make_video(sketch, frames));
  });
}

}  // namespace
}  // namespace docent::vpx::decoder_test
