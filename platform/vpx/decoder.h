#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>

#include "runtime/model/result.h"
#include "runtime/video/fill_pixels.h"
#include "runtime/video/webm.h"

struct vpx_codec_ctx;  // NOLINT(readability-identifier-naming): as libvpx calls it

namespace docent::vpx {

void close_decoder(vpx_codec_ctx* decoder) noexcept;

/// Turns the coded frames of one video, one after another, into planes. For one thread at a time.
class Decoder {
 public:
  /// Fails where memory is out.
  static Result<Decoder> open(const video::Video& video);

  /// Decodes the next frame. Its planes are valid until the next call; `y` is null where it is
  /// decoded and not to be seen. What is damaged, and what is not as large as the video says, is
  /// answered with a sentence, and the decoder goes on with the next key frame. A key frame that
  /// says that it is larger takes no memory for that.
  Result<video::Planes> decode(std::span<const std::byte> frame);

 private:
  Decoder() = default;
  bool says_its_size(std::span<const std::byte> frame, std::uint32_t& width,
                     std::uint32_t& height) const noexcept;

  std::unique_ptr<vpx_codec_ctx, void (*)(vpx_codec_ctx*) noexcept> decoder_{nullptr,
                                                                             close_decoder};
  video::Codec codec_ = video::Codec::Vp8;
  std::uint32_t width_ = 0, height_ = 0;
};

/// What is seen first of a WebM file that keeps to video::Limits; a sentence where nothing is.
Result<Pixels> first_picture(std::span<const std::byte> file);

}  // namespace docent::vpx
