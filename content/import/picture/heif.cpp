#include <libheif/heif.h>

#include <cstring>
#include <memory>
#include <vector>

#include "content/import/picture/picture_error.h"
#include "platform/handle.h"

namespace docent::import {

namespace {

using Context = std::unique_ptr<heif_context, CloseWith<heif_context_free>>;
using Handle = std::unique_ptr<const heif_image_handle, CloseWith<heif_image_handle_release>>;
using Image = std::unique_ptr<const heif_image, CloseWith<heif_image_release>>;

/// Throws where libheif failed. Its sentences are not for museum staff.
void check(const heif_error& error) {
  if (error.code == heif_error_Unsupported_feature || error.code == heif_error_Unsupported_filetype)
    throw picture_error("this HEIC or AVIF picture is of a kind that cannot be read here");
  if (error.code != heif_error_Ok)
    throw picture_error("this HEIC or AVIF picture is damaged or cut short");
}

}  // namespace

Pixels read_heif(std::span<const std::byte> bytes, const PictureLimits& limits) {
  const Context context(heif_context_alloc());
  check(heif_context_read_from_memory_without_copy(context.get(), bytes.data(), bytes.size(),
                                                   nullptr));
  heif_image_handle* found = nullptr;
  check(heif_context_get_primary_image_handle(context.get(), &found));
  const Handle handle(found);
  check_picture_size(static_cast<std::uint64_t>(heif_image_handle_get_width(found)),
                     static_cast<std::uint64_t>(heif_image_handle_get_height(found)), limits);
  heif_image* decoded = nullptr;
  check(heif_decode_image(found, &decoded, heif_colorspace_RGB, heif_chroma_interleaved_RGBA,
                          nullptr));
  const Image image(decoded);
  int stride = 0;
  const std::uint8_t* rows =
      heif_image_get_plane_readonly(decoded, heif_channel_interleaved, &stride);
  const auto width =
      static_cast<std::size_t>(heif_image_get_width(decoded, heif_channel_interleaved));
  const auto height =
      static_cast<std::size_t>(heif_image_get_height(decoded, heif_channel_interleaved));
  if (rows == nullptr) throw picture_error("this HEIC or AVIF picture has no pixels");
  Pixels pixels{.width = static_cast<std::uint32_t>(width),
                .height = static_cast<std::uint32_t>(height),
                .rgba = std::vector<std::byte>(4 * width * height)};
  for (std::size_t y = 0; y < height; ++y)
    std::memcpy(pixels.rgba.data() + 4 * width * y, rows + static_cast<std::size_t>(stride) * y,
                4 * width);
  return pixels;
}

}  // namespace docent::import
