#include "platform/image/image.h"

#include <gmock/gmock.h>
#include <rapidcheck.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <jpeglib.h>

#include "tests/support/temporary_folder.h"

namespace docent::image::image_test {
namespace {

using ::testing::HasSubstr;

Pixels chequered(std::uint32_t width, std::uint32_t height) {
  Pixels picture{width, height, {}};
  for (std::uint32_t y = 0; y < height; ++y)
    for (std::uint32_t x = 0; x < width; ++x)
      for (const unsigned byte : {x * 255 / width, y * 255 / height, (x + y) % 2 * 255, 255U})
        picture.rgba.push_back(static_cast<std::byte>(byte));
  return picture;
}

std::vector<std::byte> jpeg_of(const Pixels& picture) {
  jpeg_compress_struct info{};
  jpeg_error_mgr errors{};
  info.err = jpeg_std_error(&errors);
  jpeg_create_compress(&info);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&info, &bytes, &size);
  info.image_width = picture.width;
  info.image_height = picture.height;
  info.input_components = 4;
  info.in_color_space = JCS_EXT_RGBA;
  jpeg_set_defaults(&info);
  jpeg_start_compress(&info, TRUE);
  while (info.next_scanline < info.image_height) {
    std::vector<unsigned char> row(std::size_t{4} * picture.width);
    for (std::size_t i = 0; i < row.size(); ++i)
      row[i] = std::to_integer<unsigned char>(picture.rgba[info.next_scanline * row.size() + i]);
    unsigned char* pointer = row.data();
    jpeg_write_scanlines(&info, &pointer, 1);
  }
  jpeg_finish_compress(&info);
  jpeg_destroy_compress(&info);
  const auto* first = reinterpret_cast<const std::byte*>(bytes);
  std::vector<std::byte> out(first, first + size);
  std::free(bytes);
  return out;
}

TEST(Png, ComesBackAsItWasWritten) {
  EXPECT_TRUE(rc::check("decode(encode(picture)) == picture", [] {
    Pixels picture;
    picture.width = *rc::gen::inRange(1U, 40U);
    picture.height = *rc::gen::inRange(1U, 40U);
    const auto bytes = *rc::gen::container<std::vector<std::uint8_t>>(
        std::size_t{4} * picture.width * picture.height, rc::gen::arbitrary<std::uint8_t>());
    for (const std::uint8_t byte : bytes) picture.rgba.push_back(std::byte{byte});

    const auto decoded = decode_image(encode_png(picture).value());

    RC_ASSERT(decoded.has_value());
    RC_ASSERT(decoded->width == picture.width && decoded->rgba == picture.rgba);
  }));
}

TEST(Png, WithoutTransparencyIsWrittenWithoutAlphaAndComesBackOpaque) {
  const Pixels picture = chequered(30, 20);

  const auto file = encode_png(picture).value();

  EXPECT_EQ(file[25], std::byte{2});  // IHDR's colour type: true colour
  EXPECT_EQ(decode_image(file).value().rgba, picture.rgba);
}

TEST(Png, CutShortAnywhereIsRefusedWithASentence) {
  const auto whole = encode_png(chequered(16, 16)).value();

  constexpr std::size_t behind_the_pixels = 32;  // checksums and the end's own chunk
  for (std::size_t size = 8; size + behind_the_pixels < whole.size(); ++size) {
    const auto decoded = decode_image(std::span(whole).first(size));
    ASSERT_FALSE(decoded.has_value()) << size;
    EXPECT_THAT(decoded.error().what, HasSubstr("this PNG is damaged or cut short"));
  }
}

TEST(Png, WithAFlippedBitInItsPixelsIsRefused) {
  auto file = encode_png(chequered(16, 16)).value();
  file[file.size() / 2] ^= std::byte{4};

  EXPECT_FALSE(decode_image(file).has_value());
}

TEST(Jpeg, ComesBackWithinItsLoss) {
  Pixels plain{24, 16, {}};
  for (int i = 0; i < 24 * 16; ++i)
    for (const int byte : {200, 120, 40, 255}) plain.rgba.push_back(static_cast<std::byte>(byte));

  const auto decoded = decode_image(jpeg_of(plain));

  ASSERT_TRUE(decoded.has_value());
  EXPECT_EQ(decoded->width, 24U);
  for (std::size_t i = 0; i < plain.rgba.size(); ++i)
    EXPECT_NEAR(std::to_integer<int>(decoded->rgba[i]), std::to_integer<int>(plain.rgba[i]), 4);
}

TEST(Jpeg, IsReadAtASmallerScaleWhereThatIsEnough) {
  Pixels halves{.width = 770, .height = 400, .rgba = {}};
  for (std::size_t i = 0; i < std::size_t{770} * 400; ++i)
    halves.rgba.insert(halves.rgba.end(), 3,
                       std::byte{i % 770 < 385 ? std::uint8_t{40} : std::uint8_t{220}}),
        halves.rgba.push_back(std::byte{255});
  const auto file = encode_jpeg(halves).value();

  const Pixels small = decode_at_least(file, 144).value();
  EXPECT_EQ(small.width, 193U);  // a quarter, rounded up
  EXPECT_EQ(small.height, 100U);
  EXPECT_NEAR(std::to_integer<int>(small.rgba[4 * (50 * 193 + 40)]), 40, 4);
  EXPECT_NEAR(std::to_integer<int>(small.rgba[4 * (50 * 193 + 150)]), 220, 4);
  EXPECT_EQ(decode_at_least(file, 385).value().width, 385U);
  EXPECT_EQ(decode_at_least(file, 386).value().width, 770U);
  EXPECT_EQ(decode_at_least(file, 9000).value().width, 770U);
}

TEST(Jpeg, CutShortIsRefusedWithASentence) {
  const auto whole = jpeg_of(chequered(64, 64));

  for (const std::size_t size : {whole.size() / 4, whole.size() / 2, whole.size() * 3 / 4}) {
    const auto decoded = decode_image(std::span(whole).first(size));
    ASSERT_FALSE(decoded.has_value()) << size;
    EXPECT_THAT(decoded.error().what, HasSubstr("this JPEG is damaged or cut short"));
  }
}

TEST(Images, OfAnotherKindAreRefusedWithASentence) {
  const std::array<std::byte, 6> gif{std::byte{'G'}, std::byte{'I'}, std::byte{'F'},
                                     std::byte{'8'}, std::byte{'9'}, std::byte{'a'}};

  EXPECT_THAT(decode_image(gif).error().what, HasSubstr("neither a PNG nor a JPEG"));
  EXPECT_THAT(decode_image({}).error().what, HasSubstr("neither a PNG nor a JPEG"));
}

TEST(Images, LargerThanTheLimitsAreRefusedBeforeTheirPixelsAreRead) {
  const auto png = encode_png(chequered(40, 10)).value();

  EXPECT_THAT(decode_image(png, {.side = 39}).error().what, HasSubstr("40 x 10"));
  EXPECT_THAT(decode_image(png, {.pixels = 399}).error().what, HasSubstr("40 x 10"));
  EXPECT_TRUE(decode_image(png, {.side = 40, .pixels = 400}).has_value());
  EXPECT_FALSE(decode_image(jpeg_of(chequered(40, 10)), {.side = 39}).has_value());
}

TEST(Images, TellTheirSizeFromTheirHeaderAlone) {
  const auto png = encode_png(chequered(40, 10)).value();
  const auto jpeg = jpeg_of(chequered(20, 30));

  const auto of_png = read_image_size(std::span(png).first(60)).value();
  const auto of_jpeg = read_image_size(jpeg).value();

  EXPECT_EQ(of_png.width, 40U);
  EXPECT_EQ(of_png.height, 10U);
  EXPECT_TRUE(of_png.rgba.empty());
  EXPECT_EQ(of_jpeg.width, 20U);
  EXPECT_EQ(of_jpeg.height, 30U);
}

TEST(EncodingAJpeg, GivesThePictureBackAlmostAsItWas) {
  Pixels picture{64, 48, {}};
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 64; ++x)
      for (const int byte : {4 * x, 5 * y, 2 * x + 2 * y, 255})
        picture.rgba.push_back(static_cast<std::byte>(byte));

  const auto bytes = encode_jpeg(picture).value();
  const Pixels decoded = decode_image(bytes).value();

  EXPECT_LT(bytes.size(), picture.rgba.size() / 4);
  EXPECT_EQ(bytes, encode_jpeg(picture).value());
  ASSERT_EQ(decoded.rgba.size(), picture.rgba.size());
  for (std::size_t i = 0; i < picture.rgba.size(); ++i)
    EXPECT_NEAR(std::to_integer<int>(decoded.rgba[i]), std::to_integer<int>(picture.rgba[i]), 8);
}

TEST(EncodingAJpeg, OfNoPixelsIsRefused) {
  EXPECT_FALSE(encode_jpeg({}).has_value());
}

TEST(Shrinking, KeepsTheShapeAndTheLight) {
  Pixels picture{4, 2, {}};
  for (const int grey : {0, 255, 255, 0, 0, 255, 255, 0})
    for (const int byte : {grey, grey, grey, 255})
      picture.rgba.push_back(static_cast<std::byte>(byte));

  const Pixels small = shrink(picture, 2);

  EXPECT_EQ(small.width, 2U);
  EXPECT_EQ(small.height, 1U);
  // Half of white's light is 188 in sRGB, not 128.
  for (const std::size_t i : {0, 4}) EXPECT_EQ(std::to_integer<int>(small.rgba[i]), 188);
}

TEST(Shrinking, LeavesASmallPictureAlone) {
  const Pixels picture = chequered(8, 6);

  EXPECT_EQ(shrink(picture, 8).rgba, picture.rgba);
}

TEST(Shrinking, GivesAPixelOnABorderToBothSides) {
  Pixels picture{3, 1, {}};
  for (const int grey : {255, 255, 0})
    for (const int byte : {grey, grey, grey, 255})
      picture.rgba.push_back(static_cast<std::byte>(byte));

  const Pixels small = shrink(picture, 2);

  // The right half has a third of its light from the middle pixel: 1/3 is 156 in sRGB.
  EXPECT_EQ(std::to_integer<int>(small.rgba[0]), 255);
  EXPECT_EQ(std::to_integer<int>(small.rgba[4]), 156);
}

TEST(MipLevels, HalveThePictureDownToAPixelOfAllItsLight) {
  Pixels chequered{6, 3, {}};
  for (int i = 0; i < 18; ++i)
    for (const int channel : {i % 2 == 0 ? 255 : 0, 0, 0, 255})
      chequered.rgba.push_back(static_cast<std::byte>(channel));

  const std::vector<Pixels> levels = mip_levels(chequered);

  ASSERT_EQ(levels.size(), 3U);
  EXPECT_EQ(levels[0].rgba, chequered.rgba);
  EXPECT_EQ(levels[1].width, 3U);
  EXPECT_EQ(levels[1].height, 1U);
  EXPECT_EQ(levels[2].width, 1U);
  EXPECT_EQ(levels[2].height, 1U);
  EXPECT_EQ(std::to_integer<int>(levels[2].rgba[0]), 188) << "half of the light";
  EXPECT_TRUE(mip_levels({}).empty());
}

TEST(Filling, TakesTheMiddleInTheShapeAskedFor) {
  Pixels picture{4, 2, {}};
  for (const int grey : {10, 20, 30, 40, 50, 60, 70, 80})
    for (const int byte : {grey, grey, grey, 255})
      picture.rgba.push_back(static_cast<std::byte>(byte));

  const Pixels square = fill(picture, 2, 2);

  ASSERT_EQ(square.width, 2U);
  ASSERT_EQ(square.height, 2U);
  const int greys[] = {20, 30, 60, 70};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(std::to_integer<int>(square.rgba[4 * i]), greys[i]);
}

TEST(Filling, NeverMakesAPictureLarger) {
  const Pixels square = fill(chequered(8, 6), 600, 600);

  EXPECT_EQ(square.width, 6U);
  EXPECT_EQ(square.height, 6U);
  EXPECT_TRUE(fill({}, 600, 600).rgba.empty());
}

TEST(Filling, HasTheSizeAskedForWhereThePictureHasRoomAndNeverMore) {
  EXPECT_TRUE(rc::check([] {
    const Pixels picture = chequered(*rc::gen::inRange(1U, 70U), *rc::gen::inRange(1U, 70U));
    const auto width = *rc::gen::inRange(1U, 90U);
    const auto height = *rc::gen::inRange(1U, 90U);

    const Pixels filled = fill(picture, width, height);

    RC_ASSERT(filled.rgba.size() == std::size_t{4} * filled.width * filled.height);
    const bool has_room = picture.width >= width && picture.height >= height;
    if (has_room) RC_ASSERT(filled.width == width && filled.height == height);
    RC_ASSERT(filled.width <= std::min(picture.width, width));
    RC_ASSERT(filled.height <= std::min(picture.height, height));
  }));
}

TEST(WritingAPng, ReplacesTheFileWholeAndLeavesNothingBeside) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "picture.png";
  ASSERT_TRUE(write_png(file, chequered(4, 4)).has_value());

  ASSERT_TRUE(write_png(file, chequered(9, 5)).has_value());

  std::ifstream in(file, std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(in), {}};
  EXPECT_EQ(decode_image(std::as_bytes(std::span(bytes))).value().width, 9U);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(WritingAPng, WhereThereIsNoFolderTellsSoAndLeavesNothing) {
  const test::TemporaryFolder folder;

  const auto written = write_png(folder.path() / "missing" / "picture.png", chequered(4, 4));

  ASSERT_FALSE(written.has_value());
  EXPECT_EQ(written.error().code, Errc::Environment);
  EXPECT_THAT(written.error().what, HasSubstr("picture.png: cannot be written"));
}

}  // namespace
}  // namespace docent::image::image_test
