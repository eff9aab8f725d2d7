#include "platform/image/jpeg.h"

#include <fmt/format.h>

#include <csetjmp>
#include <cstdio>
#include <cstdlib>

#include <jpeglib.h>

namespace docent::image {
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

struct Encoder {
  jpeg_compress_struct info{};
  ErrorExit error;
  unsigned char* bytes = nullptr;  ///< libjpeg's, from malloc.
  unsigned long size = 0;

  explicit Encoder() {
    info.err = jpeg_std_error(&error.manager);
    error.manager.error_exit = leave;
  }
  Encoder(const Encoder&) = delete;
  Encoder& operator=(const Encoder&) = delete;
  ~Encoder() {
    jpeg_destroy_compress(&info);
    std::free(bytes);
  }
};

bool compress(Encoder& encoder, const Pixels& picture) {
  if (setjmp(encoder.error.jump) != 0) return false;  // NOLINT(cert-err52-cpp)
  jpeg_create_compress(&encoder.info);
  jpeg_mem_dest(&encoder.info, &encoder.bytes, &encoder.size);
  encoder.info.image_width = picture.width;
  encoder.info.image_height = picture.height;
  encoder.info.input_components = 4;
  encoder.info.in_color_space = JCS_EXT_RGBX;
  jpeg_set_defaults(&encoder.info);
  constexpr int quality = 92;
  jpeg_set_quality(&encoder.info, quality, TRUE);
  encoder.info.comp_info[0].h_samp_factor = encoder.info.comp_info[0].v_samp_factor = 1;
  encoder.info.optimize_coding = TRUE;
  jpeg_start_compress(&encoder.info, TRUE);
  const std::size_t stride = std::size_t{4} * picture.width;
  while (encoder.info.next_scanline < picture.height) {
    const std::byte* row = picture.rgba.data() + stride * encoder.info.next_scanline;
    // libjpeg's rows are not const by heritage; it only reads them.
    auto* samples = const_cast<unsigned char*>(reinterpret_cast<const unsigned char*>(row));
    jpeg_write_scanlines(&encoder.info, &samples, 1);
  }
  jpeg_finish_compress(&encoder.info);
  return true;
}

}  // namespace

Result<std::vector<std::byte>> encode_jpeg(const Pixels& picture) {
  Encoder encoder;
  if (!compress(encoder, picture))
    return std::unexpected(
        Error{Errc::Environment, fmt::format("a JPEG cannot be made: {}", encoder.error.message)});
  const auto* first = reinterpret_cast<const std::byte*>(encoder.bytes);
  return std::vector<std::byte>(first, first + encoder.size);
}

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

}  // namespace docent::image
