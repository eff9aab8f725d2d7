#include "content/draw/picture_file.h"

#include <cairo.h>
#include <librsvg/rsvg.h>

#include <cmath>
#include <fstream>
#include <memory>
#include <string>

#include "content/content_error.h"

namespace docent::draw {
namespace {

template <auto close>
struct CloseWith {
  void operator()(auto* handle) const noexcept { close(handle); }
};
using Drawing = std::unique_ptr<RsvgHandle, CloseWith<g_object_unref>>;
using Surface = std::unique_ptr<cairo_surface_t, CloseWith<cairo_surface_destroy>>;
using Painter = std::unique_ptr<cairo_t, CloseWith<cairo_destroy>>;

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& message) {
  throw content::ContentError(Errc::Environment, file.string(), "unwritable-picture", message,
                              "is the folder there, writable, and the disk not full?");
}

cairo_status_t take_bytes(void* closure, const unsigned char* bytes, unsigned size) {
  static_cast<std::string*>(closure)->append(reinterpret_cast<const char*>(bytes), size);
  return CAIRO_STATUS_SUCCESS;
}

std::string to_png(const std::filesystem::path& file, std::string_view svg) {
  GError* error = nullptr;
  const Drawing drawing(
      rsvg_handle_new_from_data(reinterpret_cast<const guint8*>(svg.data()), svg.size(), &error));
  if (drawing == nullptr) {
    const std::string reason = error != nullptr ? error->message : "unknown";
    g_clear_error(&error);
    fail(file, "the drawing cannot be painted: " + reason);
  }
  double width = 0, height = 0;
  rsvg_handle_get_intrinsic_size_in_pixels(drawing.get(), &width, &height);
  const Surface surface(cairo_image_surface_create(
      CAIRO_FORMAT_RGB24, static_cast<int>(std::ceil(width)), static_cast<int>(std::ceil(height))));
  const Painter painter(cairo_create(surface.get()));
  const RsvgRectangle page{0, 0, width, height};
  rsvg_handle_render_document(drawing.get(), painter.get(), &page, nullptr);
  std::string png;
  if (cairo_surface_write_to_png_stream(surface.get(), take_bytes, &png) != CAIRO_STATUS_SUCCESS)
    fail(file, "the picture cannot be painted; it may be too large");
  return png;
}

void write_whole(const std::filesystem::path& file, std::string_view bytes) {
  const std::filesystem::path partial = file.string() + ".partial";
  {
    std::ofstream stream(partial, std::ios::binary);
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    stream.close();
    if (!stream) {
      std::error_code ignored;
      std::filesystem::remove(partial, ignored);
      fail(file, "the picture cannot be written");
    }
  }
  std::error_code error;
  std::filesystem::rename(partial, file, error);
  if (error) fail(file, "the picture cannot be written: " + error.message());
}

}  // namespace

void write_picture(const std::filesystem::path& file, std::string_view svg) {
  if (file.extension() == ".svg")
    write_whole(file, svg);
  else if (file.extension() == ".png")
    write_whole(file, to_png(file, svg));
  else
    throw content::ContentError(Errc::WrongUsage, file.string(), "unknown-picture-format",
                                "a drawing is written to a file that ends in .svg or .png");
}

}  // namespace docent::draw
