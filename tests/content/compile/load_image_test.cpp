#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "content/compile/load_image.h"
#include "content/content_error.h"
#include "platform/image/image.h"
#include "tests/support/temporary_folder.h"

namespace docent::compile::load_image_test {
namespace {

using test::TemporaryFolder;

Pixels plain(std::uint32_t width, std::uint32_t height) {
  return {.width = width,
          .height = height,
          .rgba = std::vector<std::byte>(std::size_t{4} * width * height, std::byte{200})};
}

TEST(LoadImage, DrawsAnSvgWithItsOwnShape) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "half.svg")
      << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 20 10'>"
         "<rect width='10' height='10' fill='#ff0000'/></svg>";

  const EncodedImage image = load_image(folder.path() / "half.svg", "half.svg");
  const Result<Pixels> pixels = image::decode_image(image.bytes);

  ASSERT_TRUE(pixels.has_value());
  EXPECT_EQ(image.width, 768U);
  EXPECT_EQ(image.height, 384U);
  const auto rgba_at = [&](std::size_t x, std::size_t y) {
    const std::size_t at = 4 * (y * pixels->width + x);
    return std::vector<std::byte>(pixels->rgba.begin() + static_cast<std::ptrdiff_t>(at),
                                  pixels->rgba.begin() + static_cast<std::ptrdiff_t>(at + 4));
  };
  EXPECT_THAT(rgba_at(100, 100),
              testing::ElementsAre(std::byte{255}, std::byte{0}, std::byte{0}, std::byte{255}));
  EXPECT_EQ(rgba_at(700, 100)[3], std::byte{0}) << "what is not drawn is clear";
}

TEST(LoadImage, MakesAJpegOfWhatIsNowhereClear) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "full.svg")
      << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 20 10'>"
         "<rect width='20' height='10' fill='#ff0000'/></svg>";

  const EncodedImage image = load_image(folder.path() / "full.svg", "full.svg");

  ASSERT_GT(image.bytes.size(), 2U);
  EXPECT_EQ(image.bytes[0], std::byte{0xff});
  EXPECT_EQ(image.bytes[1], std::byte{0xd8});
  EXPECT_EQ(image::decode_image(image.bytes).value().width, 768U);
}

TEST(LoadImage, KeepsASmallPngByteForByte) {
  const TemporaryFolder folder;
  ASSERT_TRUE(image::write_png(folder.path() / "a.png", plain(30, 20)).has_value());

  const EncodedImage image = load_image(folder.path() / "a.png", "a.png");

  EXPECT_EQ(image.bytes, *image::encode_png(plain(30, 20)));
  EXPECT_EQ(image.width, 30U);
  EXPECT_EQ(image.height, 20U);
}

TEST(LoadImage, ScalesDownWhatNoKioskCanShow) {
  const TemporaryFolder folder;
  ASSERT_TRUE(image::write_png(folder.path() / "a.png", plain(3000, 1000)).has_value());

  const EncodedImage image = load_image(folder.path() / "a.png", "a.png");

  EXPECT_EQ(image.width, 768U);
  EXPECT_EQ(image.height, 256U);
}

TEST(LoadImage, RefusesAPngThatIsCutShort) {
  const TemporaryFolder folder;
  const auto whole = *image::encode_png(plain(300, 200));
  std::ofstream(folder.path() / "a.png", std::ios::binary)
      .write(reinterpret_cast<const char*>(whole.data()),
             static_cast<std::streamsize>(whole.size() / 2));

  EXPECT_THROW(load_image(folder.path() / "a.png", "a.png"), content::ContentError);
}

TEST(LoadImage, RefusesTextThatIsNoDrawing) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "a.svg") << "<svg";

  EXPECT_THROW(load_image(folder.path() / "a.svg", "a.svg"), content::ContentError);
}

}  // namespace
}  // namespace docent::compile::load_image_test
