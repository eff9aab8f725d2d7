#include "platform/image/jpeg.h"

#include <fmt/format.h>

#include <algorithm>
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

/// Eighths, quarters and halves of a picture are read from fewer frequencies of each block.
void use_smallest_scale(Decoder& decoder, std::uint32_t least_side) noexcept {
  decoder.info.scale_num = decoder.info.scale_denom = 1;
  for (const unsigned parts : {8U, 4U, 2U}) {
    const std::uint32_t longest = std::max(decoder.info.image_width, decoder.info.image_height);
    if (least_side == 0 || longest / parts < least_side) continue;
    decoder.info.scale_denom = parts;
    break;
  }
  jpeg_calc_output_dimensions(&decoder.info);
}

bool read_header(Decoder& decoder, std::span<const std::byte> file, std::uint32_t least_side) {
  if (setjmp(decoder.error.jump) != 0) return false;  // NOLINT(cert-err52-cpp)
  jpeg_create_decompress(&decoder.info);
  jpeg_mem_src(&decoder.info, reinterpret_cast<const unsigned char*>(file.data()),
               static_cast<unsigned long>(file.size()));
  jpeg_read_header(&decoder.info, TRUE);
  const bool for_print =
      decoder.info.jpeg_color_space == JCS_CMYK || decoder.info.jpeg_color_space == JCS_YCCK;
  decoder.info.out_color_space = for_print ? JCS_CMYK : JCS_EXT_RGBA;
  use_smallest_scale(decoder, least_side);
  return true;
}

/// Makes RGBA of a row of cyan, magenta, yellow and black, without a press's profile. Adobe's
/// programs, which make nearly all such files, write how much light is left rather than ink.
void from_print_colours(unsigned char* row, std::size_t width, bool is_light) noexcept {
  for (unsigned char* pixel = row; pixel != row + 4 * width; pixel += 4) {
    const unsigned black = is_light ? pixel[3] : 255U - pixel[3];
    for (int i = 0; i < 3; ++i) {
      const unsigned light = is_light ? pixel[i] : 255U - pixel[i];
      pixel[i] = static_cast<unsigned char>((light * black + 127) / 255);
    }
    pixel[3] = 255;
  }
}

bool scan_lines(Decoder& decoder, std::byte* rgba) {
  if (setjmp(decoder.error.jump) != 0) return false;  // NOLINT(cert-err52-cpp)
  jpeg_start_decompress(&decoder.info);
  const std::size_t stride = std::size_t{4} * decoder.info.output_width;
  while (decoder.info.output_scanline < decoder.info.output_height) {
    auto* row = reinterpret_cast<unsigned char*>(rgba + stride * decoder.info.output_scanline);
    jpeg_read_scanlines(&decoder.info, &row, 1);
    if (decoder.info.out_color_space == JCS_CMYK)
      from_print_colours(row, decoder.info.output_width, decoder.info.saw_Adobe_marker != 0);
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
                           JpegPart part, std::uint32_t least_side) {
  Decoder decoder;
  const auto broken = [] {
    return std::unexpected(Error{Errc::InvalidInput, "this JPEG is damaged or cut short"});
  };
  if (!read_header(decoder, file, least_side)) return broken();
  Pixels picture{decoder.info.image_width, decoder.info.image_height, {}};
  if (auto sentence = too_large(picture.width, picture.height, limits); !sentence.empty())
    return std::unexpected(Error{Errc::InvalidInput, std::move(sentence)});
  if (part == JpegPart::Header) return picture;
  picture.width = decoder.info.output_width;
  picture.height = decoder.info.output_height;
  picture.rgba.resize(std::size_t{4} * picture.width * picture.height);
  if (!scan_lines(decoder, picture.rgba.data())) return broken();
  return picture;
}

}  // namespace docent::image
