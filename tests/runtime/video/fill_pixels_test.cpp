#include "runtime/video/fill_pixels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>

namespace docent::video::fill_pixels_test {
namespace {

/// A frame of one colour, but for its right half.
struct Made {
  std::uint32_t width, height;
  std::vector<std::byte> y, u, v;

  Made(std::uint32_t w, std::uint32_t h, int bright, int blue, int red)
      : width(w),
        height(h),
        y(std::size_t{w} * h, static_cast<std::byte>(bright)),
        u(std::size_t{(w + 1) / 2} * ((h + 1) / 2), static_cast<std::byte>(blue)),
        v(u.size(), static_cast<std::byte>(red)) {}

  Planes planes() const {
    return {.width = width,
            .height = height,
            .y = y.data(),
            .u = u.data(),
            .v = v.data(),
            .y_stride = static_cast<std::ptrdiff_t>(width),
            .uv_stride = static_cast<std::ptrdiff_t>((width + 1) / 2)};
  }
};

Pixels room_for(std::uint32_t width, std::uint32_t height) {
  return {width, height, std::vector<std::byte>(std::size_t{4} * width * height)};
}

std::array<int, 4> pixel(const Pixels& picture, std::size_t x, std::size_t y) {
  std::array<int, 4> values{};
  for (std::size_t i = 0; i < 4; ++i)
    values[i] = std::to_integer<int>(picture.rgba[4 * (y * picture.width + x) + i]);
  return values;
}

TEST(FillPixels, KnowsTheColoursOfBothStandards) {
  // BT.601: red of 255 is 81, 90, 240; BT.709: 63, 102, 240.
  Pixels picture = room_for(4, 4);
  fill_pixels(Made(8, 8, 81, 90, 240).planes(), picture);
  EXPECT_THAT(pixel(picture, 1, 1),
              testing::ElementsAre(testing::Ge(253), testing::Le(2), testing::Le(2), 255));
  Planes planes{};
  const Made red(8, 8, 63, 102, 240);
  planes = red.planes();
  planes.is_bt709 = true;
  fill_pixels(planes, picture);
  EXPECT_THAT(pixel(picture, 1, 1),
              testing::ElementsAre(testing::Ge(253), testing::Le(2), testing::Le(2), 255));
}

TEST(FillPixels, ShowsTheMiddleOfAWiderFrame) {
  Made wide(12, 4, 16, 128, 128);
  for (std::size_t y = 0; y < 4; ++y)
    for (std::size_t x = 4; x < 8; ++x) wide.y[y * 12 + x] = std::byte{235};

  Pixels picture = room_for(4, 4);
  fill_pixels(wide.planes(), picture);

  for (std::size_t x = 0; x < 4; ++x)
    EXPECT_THAT(pixel(picture, x, 2), testing::ElementsAre(255, 255, 255, 255)) << x;
}

RC_GTEST_PROP(FillPixelsProperty, AGreyFrameIsGreyAtAnySize, ()) {
  const auto side = [] { return *rc::gen::inRange<std::uint32_t>(1, 70); };
  const Made grey(side(), side(), 126, 128, 128);
  Pixels picture = room_for(side(), side());

  Planes planes = grey.planes();
  planes.is_bt709 = *rc::gen::arbitrary<bool>();
  fill_pixels(planes, picture);

  for (std::size_t y = 0; y < picture.height; ++y)
    for (std::size_t x = 0; x < picture.width; ++x)
      RC_ASSERT((pixel(picture, x, y) == std::array<int, 4>{128, 128, 128, 255}));
}

TEST(FillPixels, LeavesAPictureWithoutPixelsAlone) {
  Pixels none;
  fill_pixels(Made(4, 4, 126, 128, 128).planes(), none);
  EXPECT_TRUE(none.rgba.empty());
}

}  // namespace
}  // namespace docent::video::fill_pixels_test
