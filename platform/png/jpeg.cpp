#include "platform/png/jpeg.h"

#include <fmt/format.h>

#include <csetjmp>
#include <cstdio>

#include <jpeglib.h>

namespace docent {
namespace {

/// libjpeg reports a fatal error by calling back, and the callback may not return: it jumps out.
/// Everything between setjmp and the jump is therefore free of destructors (`scan_lines`).
struct ErrorExit {
  jpeg_error_mgr manager{};  // first: libjpeg hands back a pointer to it
  std::jmp_buf jump{};
  char message[JMSG_LENGTH_MAX] = {};
};

[[noreturn]] void leave(j_common_ptr info) {
  auto* exit = reinterpret_cast<ErrorExit*>(info->err);
  (*info->err->format_message)(info, exit->message);
  std::longjmp(exit->jump, 1);  // NOLINT(cert-err52-cpp): the only way out of libjpeg
}

/// A truncated file is padded by libjpeg with grey and a warning; we would rather know.
void refuse_warnings(j_common_ptr info, int level) {
  if (level < 0) leave(info);
}

struct Decoder {
  jpeg_decompress_struct info{};
  ErrorExit error;

  explicit Decoder() {
    info.err = jpeg_std_error(&error.manager);
    error.manager.error_exit = leave;
    error.manager.emit_message = refuse_warnings;
  }
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;
  ~Decoder() { jpeg_destroy_decompress(&info); }
};

bool read_header(Decoder& decoder, std::span<const std::byte> file) {
  if (setjmp(decoder.error.jump) != 0) return false;  // NOLINT(cert-err52-cpp)
  jpeg_create_decompress(&decoder.info);
  jpeg_mem_src(&decoder.info, reinterpret_cast<const unsigned char*>(file.data()),
               static_cast<unsigned long>(file.size()));
  jpeg_read_header(&decoder.info, TRUE);
  decoder.info.out_color_space = JCS_EXT_RGBA;
  return true;
}

bool scan_lines(Decoder& decoder, std::byte* rgba) {
  if (setjmp(decoder.error.jump) != 0) return false;  // NOLINT(cert-err52-cpp)
  jpeg_start_decompress(&decoder.info);
  const std::size_t stride = std::size_t{4} * decoder.info.output_width;
  while (decoder.info.output_scanline < decoder.info.output_height) {
    auto* row = reinterpret_cast<unsigned char*>(rgba + stride * decoder.info.output_scanline);
    jpeg_read_scanlines(&decoder.info, &row, 1);
  }
  jpeg_finish_decompress(&decoder.info);
  return true;
}

}  // namespace

Result<Pixels> decode_jpeg(std::span<const std::byte> file, const ImageLimits& limits,
                           JpegPart part) {
  Decoder decoder;
  const auto broken = [&] {
    return std::unexpected(Error{
        Errc::InvalidInput, fmt::format("this JPEG cannot be read: {}", decoder.error.message)});
  };
  if (!read_header(decoder, file)) return broken();
  Pixels picture{decoder.info.image_width, decoder.info.image_height, {}};
  if (auto sentence = too_large(picture.width, picture.height, limits); !sentence.empty())
    return std::unexpected(Error{Errc::InvalidInput, std::move(sentence)});
  if (part == JpegPart::Header) return picture;
  picture.rgba.resize(std::size_t{4} * picture.width * picture.height);
  if (!scan_lines(decoder, picture.rgba.data())) return broken();
  return picture;
}

}  // namespace docent
