#include "content/compiler/load_image.h"

#include <cairo.h>
#include <fmt/core.h>
#include <librsvg/rsvg.h>

#include <algorithm>
#include <cmath>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include <jpeglib.h>  // after <cstdio>, which it needs and does not include

#include "content/content_error.h"
#include "platform/handle.h"

namespace docent {

namespace {

constexpr double longest_side = 1024;
constexpr std::uint32_t largest_side = 4096;

using Surface2 = std::unique_ptr<cairo_surface_t, CloseWith<cairo_surface_destroy>>;
using Painter = std::unique_ptr<cairo_t, CloseWith<cairo_destroy>>;
using Drawing = std::unique_ptr<RsvgHandle, CloseWith<g_object_unref>>;

ContentError unreadable(const std::filesystem::path& file, const std::string& why) {
  return {file.string(), 0, 0, "unreadable-image", why, "export it again as PNG, JPEG or SVG"};
}

std::vector<std::byte> read_bytes(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  const std::vector<char> chars{std::istreambuf_iterator<char>(in), {}};
  if (!in && !in.eof()) throw unreadable(file, "the image cannot be opened");
  const auto bytes = std::as_bytes(std::span(chars));
  return {bytes.begin(), bytes.end()};
}

cairo_status_t append(void* to, const unsigned char* data, unsigned int size) {
  auto& bytes = *static_cast<std::vector<std::byte>*>(to);
  const auto* first = reinterpret_cast<const std::byte*>(data);
  bytes.insert(bytes.end(), first, first + size);
  return CAIRO_STATUS_SUCCESS;
}

cairo_status_t take(void* from, unsigned char* data, unsigned int size) {
  auto& rest = *static_cast<std::span<const std::byte>*>(from);
  if (rest.size() < size) return CAIRO_STATUS_READ_ERROR;
  std::memcpy(data, rest.data(), size);
  rest = rest.subspan(size);
  return CAIRO_STATUS_SUCCESS;
}

/// Fills in the size of a PNG by decoding it whole.
void check_png(const std::filesystem::path& file, EncodedImage& image) {
  std::span<const std::byte> rest = image.bytes;
  const Surface2 surface(cairo_image_surface_create_from_png_stream(take, &rest));
  if (cairo_surface_status(surface.get()) != CAIRO_STATUS_SUCCESS)
    throw unreadable(file, "the PNG image is damaged");
  image.width = static_cast<std::uint32_t>(cairo_image_surface_get_width(surface.get()));
  image.height = static_cast<std::uint32_t>(cairo_image_surface_get_height(surface.get()));
}

/// libjpeg's way to fail: it calls back and must not be returned to.
struct JpegFailure {
  jpeg_error_mgr manager;
  std::jmp_buf escape;
};

[[noreturn]] void escape_from_jpeg(j_common_ptr decoder) {
  std::longjmp(reinterpret_cast<JpegFailure*>(decoder->err)->escape, 1);
}

void ignore_message(j_common_ptr /*decoder*/) {}

/// Decodes a JPEG whole, row by row into `row`; false where it is damaged. Between setjmp and
/// longjmp nothing may need destroying, so the buffer is the caller's.
bool decode_jpeg(EncodedImage& image, std::vector<JSAMPLE>& row) {
  jpeg_decompress_struct decoder{};
  JpegFailure failure{};
  decoder.err = jpeg_std_error(&failure.manager);
  failure.manager.error_exit = escape_from_jpeg;
  failure.manager.output_message = ignore_message;
  if (setjmp(failure.escape) != 0) {  // NOLINT(cert-err52-cpp): the library offers no other way
    jpeg_destroy_decompress(&decoder);
    return false;
  }
  jpeg_create_decompress(&decoder);
  jpeg_mem_src(&decoder, reinterpret_cast<const unsigned char*>(image.bytes.data()),
               static_cast<unsigned long>(image.bytes.size()));
  jpeg_read_header(&decoder, TRUE);
  image.width = decoder.image_width;
  image.height = decoder.image_height;
  jpeg_start_decompress(&decoder);
  row.resize(std::size_t{decoder.output_width} *
             static_cast<std::size_t>(decoder.output_components));
  while (decoder.output_scanline < decoder.output_height) {
    JSAMPROW rows[] = {row.data()};
    jpeg_read_scanlines(&decoder, rows, 1);
  }
  jpeg_finish_decompress(&decoder);
  const bool whole = failure.manager.num_warnings == 0;  // a file cut short is only a warning
  jpeg_destroy_decompress(&decoder);
  return whole;
}

/// Draws a vector drawing on `painter` at the size of the surface.
void paint(const std::filesystem::path& file, RsvgHandle* drawing, cairo_t* painter, double width,
           double height) {
  const RsvgRectangle viewport{0, 0, width, height};
  GError* error = nullptr;
  if (rsvg_handle_render_document(drawing, painter, &viewport, &error) == 0) {
    const std::string why = error != nullptr ? error->message : "unknown reason";
    g_clear_error(&error);
    throw unreadable(file, fmt::format("the SVG drawing cannot be drawn: {}", why));
  }
}

/// Width over height of a drawing.
double aspect_of(RsvgHandle* drawing) {
  double width = 0;
  double height = 0;
  if (rsvg_handle_get_intrinsic_size_in_pixels(drawing, &width, &height) != 0 && width > 0 &&
      height > 0)
    return width / height;
  gboolean has_width = 0;
  gboolean has_height = 0;
  gboolean has_box = 0;
  RsvgLength ignored{};
  RsvgRectangle box{};
  rsvg_handle_get_intrinsic_dimensions(drawing, &has_width, &ignored, &has_height, &ignored,
                                       &has_box, &box);
  return has_box != 0 && box.width > 0 && box.height > 0 ? box.width / box.height : 1;
}

void draw_svg(const std::filesystem::path& file, EncodedImage& image) {
  GError* error = nullptr;
  const Drawing drawing(
      rsvg_handle_new_from_data(reinterpret_cast<const guint8*>(image.bytes.data()),
                                static_cast<gsize>(image.bytes.size()), &error));
  if (!drawing) {
    const std::string why = error != nullptr ? error->message : "unknown reason";
    g_clear_error(&error);
    throw unreadable(file, fmt::format("the image is no PNG, JPEG or SVG: {}", why));
  }
  const double aspect = aspect_of(drawing.get());
  const double width = std::max(1.0, std::round(longest_side * std::min(1.0, aspect)));
  const double height = std::max(1.0, std::round(longest_side / std::max(1.0, aspect)));
  image.width = static_cast<std::uint32_t>(width);
  image.height = static_cast<std::uint32_t>(height);
  const Surface2 surface(cairo_image_surface_create(
      CAIRO_FORMAT_ARGB32, static_cast<int>(image.width), static_cast<int>(image.height)));
  const Painter painter(cairo_create(surface.get()));
  paint(file, drawing.get(), painter.get(), width, height);
  image.bytes.clear();
  cairo_surface_write_to_png_stream(surface.get(), append, &image.bytes);
}

bool begins_with(const std::vector<std::byte>& bytes, std::string_view magic) {
  return bytes.size() >= magic.size() && std::memcmp(bytes.data(), magic.data(), magic.size()) == 0;
}

}  // namespace

EncodedImage load_image(const std::filesystem::path& file, const std::string& name) {
  EncodedImage image{.name = name, .width = 0, .height = 0, .bytes = read_bytes(file)};
  if (begins_with(image.bytes, "\x89PNG\r\n\x1a\n")) {
    check_png(file, image);
  } else if (begins_with(image.bytes, "\xff\xd8\xff")) {
    std::vector<JSAMPLE> row;
    if (!decode_jpeg(image, row)) throw unreadable(file, "the JPEG image is damaged");
  } else {
    draw_svg(file, image);
  }
  if (std::max(image.width, image.height) > largest_side)
    throw ContentError(file.string(), 0, 0, "image-too-large",
                       fmt::format("the image is {} x {} pixels, and {} a side are the most",
                                   image.width, image.height, largest_side),
                       "scale it down; 1024 pixels are enough for a kiosk");
  return image;
}

EncodedImage blank_image() {
  constexpr int side = 64;
  const Surface2 surface(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, side, side));
  const Painter painter(cairo_create(surface.get()));
  cairo_set_source_rgb(painter.get(), 0.91, 0.89, 0.84);
  cairo_paint(painter.get());
  EncodedImage image{.name = "", .width = side, .height = side, .bytes = {}};
  cairo_surface_write_to_png_stream(surface.get(), append, &image.bytes);
  return image;
}

}  // namespace docent
