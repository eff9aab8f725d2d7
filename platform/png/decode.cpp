#include <fmt/format.h>
#include <spng.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "platform/png/image.h"
#include "platform/png/jpeg.h"

namespace docent {
namespace {

struct FreeContext {
  void operator()(spng_ctx* context) const noexcept { spng_ctx_free(context); }
};
using PngReader = std::unique_ptr<spng_ctx, FreeContext>;

bool begins_with(std::span<const std::byte> file, std::span<const unsigned char> mark) {
  return file.size() >= mark.size() &&
         std::equal(mark.begin(), mark.end(), file.begin(),
                    [](unsigned char a, std::byte b) { return std::byte{a} == b; });
}
constexpr std::array<unsigned char, 8> png_mark{0x89, 'P', 'N', 'G', 0x0d, 0x0a, 0x1a, 0x0a};
constexpr std::array<unsigned char, 3> jpeg_mark{0xff, 0xd8, 0xff};

enum class PngPart : std::uint8_t { Header, Pixels };

Result<Pixels> decode_png(std::span<const std::byte> file, const ImageLimits& limits,
                          PngPart part) {
  const auto broken = [](int status) {
    return std::unexpected(Error{
        Errc::InvalidInput, fmt::format("this PNG cannot be read: {}", spng_strerror(status))});
  };
  const PngReader reader(spng_ctx_new(0));
  if (!reader) return broken(SPNG_EMEM);
  constexpr std::size_t largest_chunk = std::size_t{16} << 20;
  spng_set_chunk_limits(reader.get(), largest_chunk, largest_chunk);
  spng_set_crc_action(reader.get(), SPNG_CRC_ERROR, SPNG_CRC_ERROR);
  if (const int status = spng_set_png_buffer(reader.get(), file.data(), file.size()))
    return broken(status);
  spng_ihdr header{};
  if (const int status = spng_get_ihdr(reader.get(), &header)) return broken(status);
  if (auto sentence = too_large(header.width, header.height, limits); !sentence.empty())
    return std::unexpected(Error{Errc::InvalidInput, std::move(sentence)});

  Pixels picture{header.width, header.height, {}};
  if (part == PngPart::Header) return picture;
  picture.rgba.resize(std::size_t{4} * header.width * header.height);
  if (const int status = spng_decode_image(reader.get(), picture.rgba.data(), picture.rgba.size(),
                                           SPNG_FMT_RGBA8, SPNG_DECODE_TRNS))
    return broken(status);
  return picture;
}

Result<Pixels> unknown_kind() {
  return std::unexpected(Error{Errc::InvalidInput,
                               "this picture is neither a PNG nor a JPEG; save it as one of them"});
}

/// IEC 61966-2-1.
float to_linear(std::byte encoded) {
  static const auto table = [] {
    std::array<float, 256> values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double e = static_cast<double>(i) / 255.0;
      values[i] = static_cast<float>(e <= 0.04045 ? e / 12.92 : std::pow((e + 0.055) / 1.055, 2.4));
    }
    return values;
  }();
  return table[std::to_integer<std::size_t>(encoded)];
}

std::byte to_encoded(float linear) {
  const float c = std::clamp(linear, 0.0F, 1.0F);
  const float e = c <= 0.0031308F ? 12.92F * c : 1.055F * std::pow(c, 1 / 2.4F) - 0.055F;
  return static_cast<std::byte>(std::lround(255.0F * e));
}

/// The mean of a block of pixels, weighted by their opacity.
void average(const Pixels& source, std::uint32_t x0, std::uint32_t x1, std::uint32_t y0,
             std::uint32_t y1, std::byte* out) {
  float red = 0, green = 0, blue = 0, alpha = 0;
  for (std::uint32_t y = y0; y < y1; ++y) {
    for (std::uint32_t x = x0; x < x1; ++x) {
      const std::byte* pixel = &source.rgba[4 * (std::size_t{y} * source.width + x)];
      const float opacity = static_cast<float>(std::to_integer<int>(pixel[3])) / 255.0F;
      red += opacity * to_linear(pixel[0]);
      green += opacity * to_linear(pixel[1]);
      blue += opacity * to_linear(pixel[2]);
      alpha += opacity;
    }
  }
  const float weight = alpha > 0 ? 1 / alpha : 0;
  const auto count = static_cast<float>((x1 - x0) * (y1 - y0));
  out[0] = to_encoded(red * weight);
  out[1] = to_encoded(green * weight);
  out[2] = to_encoded(blue * weight);
  out[3] = static_cast<std::byte>(std::lround(255.0F * alpha / count));
}

}  // namespace

std::string too_large(std::uint64_t width, std::uint64_t height, const ImageLimits& limits) {
  if (width == 0 || height == 0) return "this picture has no pixels";
  if (width <= limits.side && height <= limits.side && width * height <= limits.pixels) return {};
  return fmt::format(
      "this picture is {} x {} pixels; at most {} a side and {} in all can be taken, so save it "
      "smaller",
      width, height, limits.side, limits.pixels);
}

Result<Pixels> decode_image(std::span<const std::byte> file, const ImageLimits& limits) {
  if (begins_with(file, png_mark)) return decode_png(file, limits, PngPart::Pixels);
  if (begins_with(file, jpeg_mark)) return decode_jpeg(file, limits, JpegPart::Pixels);
  return unknown_kind();
}

Result<Pixels> read_image_size(std::span<const std::byte> file, const ImageLimits& limits) {
  if (begins_with(file, png_mark)) return decode_png(file, limits, PngPart::Header);
  if (begins_with(file, jpeg_mark)) return decode_jpeg(file, limits, JpegPart::Header);
  return unknown_kind();
}

Pixels shrink(Pixels picture, std::uint32_t longest_side) {
  const std::uint32_t longest = std::max(picture.width, picture.height);
  if (longest <= longest_side || longest_side == 0) return picture;
  const auto scaled = [&](std::uint32_t side) {
    return std::max(1U, static_cast<std::uint32_t>(
                            (std::uint64_t{side} * longest_side + longest / 2) / longest));
  };
  Pixels small{scaled(picture.width), scaled(picture.height), {}};
  small.rgba.resize(std::size_t{4} * small.width * small.height);
  const auto edge = [](std::uint32_t i, std::uint32_t from, std::uint32_t to) {
    return static_cast<std::uint32_t>(std::uint64_t{i} * from / to);
  };
  for (std::uint32_t y = 0; y < small.height; ++y) {
    const std::uint32_t y0 = edge(y, picture.height, small.height);
    const std::uint32_t y1 = std::max(y0 + 1, edge(y + 1, picture.height, small.height));
    for (std::uint32_t x = 0; x < small.width; ++x) {
      const std::uint32_t x0 = edge(x, picture.width, small.width);
      const std::uint32_t x1 = std::max(x0 + 1, edge(x + 1, picture.width, small.width));
      average(picture, x0, x1, y0, y1, &small.rgba[4 * (std::size_t{y} * small.width + x)]);
    }
  }
  return small;
}

}  // namespace docent
