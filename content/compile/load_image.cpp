#include "content/compile/load_image.h"

#include <cairo.h>
#include <fmt/core.h>
#include <librsvg/rsvg.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "content/content_error.h"
#include "content/import/picture/read_picture.h"
#include "content/read_source.h"
#include "platform/file/file_kind.h"
#include "platform/handle.h"
#include "platform/image/image.h"

namespace docent::compile {

namespace {

constexpr std::uint32_t drawn_side = 768, checked_side = 32;
constexpr std::uint32_t kept_side = 2048;

using CairoSurface = std::unique_ptr<cairo_surface_t, CloseWith<cairo_surface_destroy>>;
using CairoContext = std::unique_ptr<cairo_t, CloseWith<cairo_destroy>>;
using Drawing = std::unique_ptr<RsvgHandle, CloseWith<g_object_unref>>;

content::ContentError unreadable(const std::filesystem::path& file, const std::string& why) {
  return {file.string(), 0, 0, "unreadable-image", why, "export it again as PNG, JPEG or SVG"};
}

std::vector<std::byte> read_bytes(const std::filesystem::path& file) {
  const std::string text = content::read_source(file, "unreadable-image",
                                                "name a PNG, JPEG or SVG file that may be read");
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

/// A kiosk keeps the bytes of all pictures in memory, so they are few: JPEG, but for what is partly
/// clear, which only PNG can say.
std::vector<std::byte> encoded(const std::filesystem::path& file, const Pixels& pixels) {
  auto bytes = image::is_opaque(pixels) ? image::encode_jpeg(pixels) : image::encode_png(pixels);
  if (!bytes) throw unreadable(file, bytes.error().what);
  return std::move(*bytes);
}

/// Cairo's pixels (native words, colours multiplied by opacity) as straight RGBA.
Pixels to_pixels(cairo_surface_t* surface) {
  cairo_surface_flush(surface);
  const auto width = static_cast<std::size_t>(cairo_image_surface_get_width(surface));
  const auto height = static_cast<std::size_t>(cairo_image_surface_get_height(surface));
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface));
  const unsigned char* data = cairo_image_surface_get_data(surface);
  Pixels pixels{.width = static_cast<std::uint32_t>(width),
                .height = static_cast<std::uint32_t>(height),
                .rgba = std::vector<std::byte>(4 * width * height)};
  std::byte* out = pixels.rgba.data();
  for (std::size_t y = 0; y < height; ++y)
    for (std::size_t x = 0; x < width; ++x) {
      std::uint32_t argb = 0;
      std::memcpy(&argb, data + y * stride + 4 * x, sizeof argb);
      const std::uint32_t alpha = argb >> 24U;
      for (const unsigned shift : {16U, 8U, 0U}) {
        const std::uint32_t colour = argb >> shift & 0xFFU;
        *out++ = static_cast<std::byte>(
            alpha == 0 ? 0 : std::min((colour * 255 + alpha / 2) / alpha, 255U));
      }
      *out++ = static_cast<std::byte>(alpha);
    }
  return pixels;
}

/// Width over height of a drawing: of its stated size, else of its view box.
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

/// GLib's sentence about a failure.
std::string take_message(GError* error) {
  std::string message = error != nullptr ? error->message : "unknown reason";
  g_clear_error(&error);
  return message;
}

/// A drawing that librsvg does not take. Its sentence is kept to itself, but for the line.
content::ContentError damaged_drawing(const std::filesystem::path& file,
                                      const std::string& sentence) {
  content::ContentError error = unreadable(file, "this SVG drawing is damaged or cut short");
  if (const std::size_t at = sentence.find("line "); at != std::string::npos)
    if (const long line = std::strtol(sentence.c_str() + at + 5, nullptr, 10); line > 0)
      return unreadable(file, fmt::format("this SVG drawing is damaged in its line {}", line));
  return error;
}

Pixels draw_svg(const std::filesystem::path& file, std::span<const std::byte> bytes,
                std::uint32_t longest) {
  GError* error = nullptr;
  const Drawing drawing(rsvg_handle_new_from_data(reinterpret_cast<const guint8*>(bytes.data()),
                                                  static_cast<gsize>(bytes.size()), &error));
  if (!drawing) throw damaged_drawing(file, take_message(error));
  const double aspect = aspect_of(drawing.get());
  const double width = std::max(1.0, std::round(longest * std::min(1.0, aspect)));
  const double height = std::max(1.0, std::round(longest / std::max(1.0, aspect)));
  const CairoSurface surface(cairo_image_surface_create(
      CAIRO_FORMAT_ARGB32, static_cast<int>(width), static_cast<int>(height)));
  const CairoContext context(cairo_create(surface.get()));
  const RsvgRectangle viewport{0, 0, width, height};
  if (rsvg_handle_render_document(drawing.get(), context.get(), &viewport, &error) == 0)
    throw damaged_drawing(file, take_message(error));
  return to_pixels(surface.get());
}

bool is_png_or_jpeg(std::string_view kind) {
  return kind == "a PNG picture" || kind == "a JPEG picture";
}

/// The pixels of a picture of any kind but PNG and JPEG; a drawing's longest side is `longest`.
Pixels convert(const std::filesystem::path& file, const file::FileKind& kind,
               std::span<const std::byte> bytes, std::uint32_t longest) {
  if (bytes.empty()) throw unreadable(file, "this file is empty");
  if (kind.name == "an SVG drawing") return draw_svg(file, bytes, longest);
  if (kind.name == "a GIF picture") return import::read_gif(bytes);
  if (kind.name == "a WebP picture") return import::read_webp(bytes);
  if (kind.use == file::FileKind::For::Picture) return import::read_heif(bytes);
  if (kind.name.empty())
    throw unreadable(file,
                     "this is no picture that can be read: neither PNG, JPEG, WebP, GIF, HEIC "
                     "nor SVG");
  content::ContentError error =
      unreadable(file, fmt::format("this is {}, and no picture that can be read", kind.name));
  if (!kind.remedy.empty()) error.hint = kind.remedy;
  throw error;
}

file::FileKind kind_of(std::span<const std::byte> bytes) {
  return file::file_kind({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

Pixels decode(const std::filesystem::path& file, std::span<const std::byte> bytes) {
  Result<Pixels> decoded = image::decode_image(bytes);
  if (!decoded) throw unreadable(file, decoded.error().what);
  return std::move(*decoded);
}

}  // namespace

EncodedImage load_image(const std::filesystem::path& file, const std::string& name) {
  EncodedImage image{.name = name, .width = 0, .height = 0, .bytes = read_bytes(file)};
  Pixels pixels;
  bool keep = false;
  const file::FileKind kind = kind_of(image.bytes);
  if (is_png_or_jpeg(kind.name)) {
    pixels = decode(file, image.bytes);
    keep = std::max(pixels.width, pixels.height) <= kept_side;
    if (!keep) pixels = image::shrink(std::move(pixels), drawn_side);
  } else {
    pixels = convert(file, kind, image.bytes, drawn_side);
    if (kind.name != "an SVG drawing") pixels = image::shrink(std::move(pixels), drawn_side);
  }
  image.width = pixels.width;
  image.height = pixels.height;
  if (!keep) image.bytes = encoded(file, pixels);
  return image;
}

std::vector<std::byte> small_picture(const std::filesystem::path& file, const EncodedImage& image,
                                     std::uint32_t side) {
  if (std::max(image.width, image.height) <= side) return {};
  return encoded(file, image::shrink(decode(file, image.bytes), side));
}

Pixels load_pixels(const std::filesystem::path& file, std::uint32_t longest) {
  const std::vector<std::byte> bytes = read_bytes(file);
  const file::FileKind kind = kind_of(bytes);
  return image::shrink(
      is_png_or_jpeg(kind.name) ? decode(file, bytes) : convert(file, kind, bytes, longest),
      longest);
}

void check_image(const std::filesystem::path& file) {
  const std::vector<std::byte> bytes = read_bytes(file);
  const file::FileKind kind = kind_of(bytes);
  if (is_png_or_jpeg(kind.name))
    decode(file, bytes);
  else
    convert(file, kind, bytes, checked_side);
}

EncodedImage blank_image() {
  constexpr std::uint32_t side = 16;
  constexpr std::byte paper[] = {std::byte{0xE9}, std::byte{0xE3}, std::byte{0xD7},
                                 std::byte{0xFF}};
  Pixels pixels{.width = side, .height = side, .rgba = {}};
  for (std::uint32_t i = 0; i < side * side; ++i)
    pixels.rgba.insert(pixels.rgba.end(), std::begin(paper), std::end(paper));
  return {.name = "", .width = side, .height = side, .bytes = encoded("", pixels)};
}

}  // namespace docent::compile
