#include <gif_lib.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <vector>

#include "content/import/picture/picture_error.h"

namespace docent::import {

namespace {

struct CloseGif {
  void operator()(GifFileType* file) const noexcept { DGifCloseFile(file, nullptr); }
};

int read_from_span(GifFileType* file, GifByteType* out, int count) {
  auto& rest = *static_cast<std::span<const std::byte>*>(file->UserData);
  const std::size_t taken = std::min(rest.size(), static_cast<std::size_t>(std::max(count, 0)));
  std::memcpy(out, rest.data(), taken);
  rest = rest.subspan(taken);
  return static_cast<int>(taken);
}

content::ContentError damaged() {
  return picture_error("this GIF is damaged or cut short");
}

/// Reads records up to the first picture, noting the colour that is clear; -1 for none.
int skip_to_first_frame(GifFileType* file) {
  int clear = -1;
  for (GifRecordType type{};;) {
    if (DGifGetRecordType(file, &type) == GIF_ERROR) throw damaged();
    if (type == IMAGE_DESC_RECORD_TYPE) return clear;
    if (type == TERMINATE_RECORD_TYPE) throw picture_error("this GIF holds no picture");
    if (type != EXTENSION_RECORD_TYPE) continue;
    int code = 0;
    GifByteType* extension = nullptr;
    if (DGifGetExtension(file, &code, &extension) == GIF_ERROR) throw damaged();
    while (extension != nullptr) {
      GraphicsControlBlock control{};
      if (code == GRAPHICS_EXT_FUNC_CODE &&
          DGifExtensionToGCB(extension[0], extension + 1, &control) == GIF_OK)
        clear = control.TransparentColor;
      if (DGifGetExtensionNext(file, &extension) == GIF_ERROR) throw damaged();
    }
  }
}

/// Puts a row of colour numbers into the picture.
void put_row(const std::vector<GifPixelType>& row, const ColorMapObject& colours, int clear,
             std::byte* out) {
  for (const GifPixelType number : row) {
    if (number < colours.ColorCount && number != clear) {
      const GifColorType& colour = colours.Colors[number];
      out[0] = std::byte{colour.Red};
      out[1] = std::byte{colour.Green};
      out[2] = std::byte{colour.Blue};
      out[3] = std::byte{255};
    }
    out += 4;
  }
}

/// The rows of an interlaced GIF come in four passes.
std::vector<std::size_t> row_order(std::size_t height, bool interlaced) {
  std::vector<std::size_t> order;
  constexpr std::size_t starts[] = {0, 4, 2, 1}, steps[] = {8, 8, 4, 2};
  for (int pass = interlaced ? 0 : 3; pass < 4; ++pass)
    for (std::size_t y = interlaced ? starts[pass] : 0; y < height;
         y += interlaced ? steps[pass] : 1)
      order.push_back(y);
  return order;
}

}  // namespace

Pixels read_gif(std::span<const std::byte> bytes, const PictureLimits& limits) {
  int error = 0;
  const std::unique_ptr<GifFileType, CloseGif> file(DGifOpen(&bytes, read_from_span, &error));
  if (!file) throw damaged();
  const int clear = skip_to_first_frame(file.get());
  if (DGifGetImageDesc(file.get()) == GIF_ERROR) throw damaged();
  const GifImageDesc& frame = file->Image;
  const auto width = static_cast<std::size_t>(std::max(frame.Width, 0));
  const auto height = static_cast<std::size_t>(std::max(frame.Height, 0));
  check_picture_size(width, height, limits);
  const ColorMapObject* colours = frame.ColorMap != nullptr ? frame.ColorMap : file->SColorMap;
  if (colours == nullptr) throw picture_error("this GIF has no colours");
  Pixels pixels{.width = static_cast<std::uint32_t>(width),
                .height = static_cast<std::uint32_t>(height),
                .rgba = std::vector<std::byte>(4 * width * height)};
  std::vector<GifPixelType> row(width);
  for (const std::size_t y : row_order(height, frame.Interlace)) {
    if (DGifGetLine(file.get(), row.data(), static_cast<int>(width)) == GIF_ERROR) throw damaged();
    put_row(row, *colours, clear, pixels.rgba.data() + 4 * width * y);
  }
  return pixels;
}

}  // namespace docent::import
