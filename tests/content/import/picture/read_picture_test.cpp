#include "content/import/picture/read_picture.h"

#include <gtest/gtest.h>
#include <libheif/heif.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include <jpeglib.h>

#include "content/content_error.h"
#include "platform/file/file_kind.h"
#include "platform/image/image.h"

/// The encoder that makes the HEIC to try keeps a kilobyte for ever; the reader uses no encoder.
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libx265";
}

namespace docent::import::read_picture_test {
namespace {

using namespace std::string_view_literals;

std::span<const std::byte> bytes_of(std::string_view text) {
  return std::as_bytes(std::span(text));
}

std::array<int, 4> colour_at(const Pixels& pixels, std::size_t index) {
  std::array<int, 4> colour{};
  for (std::size_t i = 0; i < 4; ++i)
    colour[i] = std::to_integer<int>(pixels.rgba.at(4 * index + i));
  return colour;
}

// One red pixel, and a green one in a second frame.
constexpr std::string_view gif =
    "GIF89a\1\0\1\0\x80\0\0\xff\0\0\0\xff\0,\0\0\0\0\1\0\1\0\0\2\2\x44\1\0,\0\0\0\0\1\0\1\0\0\2\2\x4c\1\0;"sv;
// One clear pixel, without loss.
constexpr std::string_view webp =
    "RIFF\x1a\0\0\0WEBPVP8L\x0d\0\0\0\x2f\0\0\0\x10\x07\x10\x11\x11\x88\x88\xfe\x07\0"sv;

TEST(ReadPicture, OfAGifThatMovesItIsTheFirstFrame) {
  const Pixels pixels = read_gif(bytes_of(gif));

  EXPECT_EQ(pixels.width, 1U);
  EXPECT_EQ(colour_at(pixels, 0), (std::array{255, 0, 0, 255}));
}

TEST(ReadPicture, WebpIsTaken) {
  const Pixels pixels = read_webp(bytes_of(webp));

  EXPECT_EQ(pixels.width, 1U);
  EXPECT_EQ(pixels.rgba.size(), 4U);
}

heif_error append(heif_context* /*context*/, const void* data, std::size_t size, void* out) {
  static_cast<std::string*>(out)->append(static_cast<const char*>(data), size);
  return {heif_error_Ok, heif_suberror_Unspecified, ""};
}

/// A HEIC picture of 64 x 32 pixels of one grey; empty where this libheif writes none.
std::string heic(std::uint8_t grey) {
  std::string bytes;
  heif_context* context = heif_context_alloc();
  heif_encoder* encoder = nullptr;
  heif_image* image = nullptr;
  heif_image_handle* handle = nullptr;
  if (heif_context_get_encoder_for_format(context, heif_compression_HEVC, &encoder).code == 0) {
    heif_image_create(64, 32, heif_colorspace_RGB, heif_chroma_interleaved_RGB, &image);
    heif_image_add_plane(image, heif_channel_interleaved, 64, 32, 8);
    int stride = 0;
    std::uint8_t* row = heif_image_get_plane(image, heif_channel_interleaved, &stride);
    std::fill(row, row + 32 * stride, grey);
    if (heif_context_encode_image(context, image, encoder, nullptr, &handle).code == 0) {
      heif_writer writer{.writer_api_version = 1, .write = append};
      heif_context_write(context, &writer, &bytes);
      heif_image_handle_release(handle);
    }
    heif_image_release(image);
    heif_encoder_release(encoder);
  }
  heif_context_free(context);
  return bytes;
}

TEST(ReadPicture, HeicOfATelephoneIsTaken) {
  const std::string bytes = heic(200);
  if (bytes.empty()) GTEST_SKIP() << "this libheif writes no HEIC to try";

  const Pixels pixels = read_heif(bytes_of(bytes));

  EXPECT_EQ(file::file_kind(bytes).use, file::FileKind::For::Picture);
  EXPECT_EQ(pixels.width, 64U);
  EXPECT_EQ(pixels.height, 32U);
  EXPECT_NEAR(colour_at(pixels, 100)[0], 200, 4);
}

/// A JPEG of one colour for print, as Adobe's programs write it.
std::vector<std::byte> cmyk_jpeg(std::array<unsigned char, 4> light) {
  jpeg_compress_struct info{};
  jpeg_error_mgr errors{};
  info.err = jpeg_std_error(&errors);
  jpeg_create_compress(&info);
  unsigned char* out = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&info, &out, &size);
  info.image_width = info.image_height = 8;
  info.input_components = 4;
  info.in_color_space = JCS_CMYK;
  jpeg_set_defaults(&info);
  info.write_Adobe_marker = TRUE;
  jpeg_start_compress(&info, TRUE);
  std::vector<unsigned char> row;
  for (int i = 0; i < 8; ++i) row.insert(row.end(), light.begin(), light.end());
  unsigned char* rows = row.data();
  for (int i = 0; i < 8; ++i) jpeg_write_scanlines(&info, &rows, 1);
  jpeg_finish_compress(&info);
  jpeg_destroy_compress(&info);
  const auto* first = reinterpret_cast<const std::byte*>(out);
  std::vector<std::byte> bytes(first, first + size);
  std::free(out);
  return bytes;
}

TEST(ReadPicture, AJpegForPrintIsShownInColours) {
  const Result<Pixels> pixels = image::decode_image(cmyk_jpeg({250, 100, 20, 255}));

  ASSERT_TRUE(pixels.has_value());
  const auto colour = colour_at(*pixels, 9);
  EXPECT_NEAR(colour[0], 250, 6);
  EXPECT_NEAR(colour[1], 100, 6);
  EXPECT_NEAR(colour[2], 20, 6);
  EXPECT_EQ(colour[3], 255);
}

TEST(ReadPicture, WhatIsCutAnywhereIsRefusedWithASentence) {
  for (const std::string_view whole : {gif, webp})
    for (std::size_t length = 0; length + 20 < whole.size(); ++length) try {
        if (whole == gif)
          read_gif(bytes_of(whole.substr(0, length)));
        else
          read_webp(bytes_of(whole.substr(0, length)));
      } catch (const content::ContentError& error) {
        EXPECT_FALSE(std::string_view(error.what()).empty());
      }
}

TEST(ReadPicture, WhatIsTooLargeIsRefused) {
  EXPECT_THROW(read_gif(bytes_of(gif), {.side = 0}), content::ContentError);
  EXPECT_THROW(read_webp(bytes_of(webp), {.pixels = 0}), content::ContentError);
}

RC_GTEST_PROP(ReadPicture, AnyBytesAreSafe, (const std::string& tail)) {
  for (const std::string_view head : {"GIF89a"sv, webp.substr(0, 20),
                                      "\0\0\0\x18"
                                      "ftypheic"sv}) {
    const std::string bytes = std::string(head) + tail;
    for (const auto read : {read_gif, read_webp, read_heif}) try {
        read(bytes_of(bytes), {});
      } catch (const content::ContentError& error) {
        RC_ASSERT(!std::string_view(error.what()).empty());
      }
  }
}

}  // namespace
}  // namespace docent::import::read_picture_test
