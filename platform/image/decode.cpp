#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>

#include "platform/image/image.h"
#include "platform/image/jpeg.h"
#include "platform/image/png.h"

namespace docent::image {
namespace {

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
    if (status == SPNG_EMEM)
      return std::unexpected(Error{Errc::Environment, "there is no memory for this PNG"});
    return std::unexpected(Error{Errc::InvalidInput, "this PNG is damaged or cut short"});
  };
  const PngContext reader(spng_ctx_new(0));
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

Result<Pixels> decode_at_least(std::span<const std::byte> file, std::uint32_t least_side) {
  if (begins_with(file, jpeg_mark)) return decode_jpeg(file, {}, JpegPart::Pixels, least_side);
  return decode_image(file);
}

Result<Pixels> read_image_size(std::span<const std::byte> file, const ImageLimits& limits) {
  if (begins_with(file, png_mark)) return decode_png(file, limits, PngPart::Header);
  if (begins_with(file, jpeg_mark)) return decode_jpeg(file, limits, JpegPart::Header);
  return unknown_kind();
}

}  // namespace docent::image
