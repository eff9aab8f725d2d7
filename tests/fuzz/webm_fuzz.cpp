#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "platform/vpx/decoder.h"
#include "runtime/video/webm.h"

/// A video of anybody's, to the pixels of its first frames.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto file = std::as_bytes(std::span(data, size));
  const auto video = docent::video::read_webm(file);
  if (!video) {
    if (video.error().what.empty()) __builtin_trap();
    return 0;
  }
  if (docent::video::beyond(*video)) return 0;
  auto decoder = docent::vpx::Decoder::open(*video);
  if (!decoder) return 0;
  docent::Pixels picture{32, 16, std::vector<std::byte>(std::size_t{4} * 32 * 16)};
  std::uint32_t before = 0;
  for (const docent::video::Frame& frame : video->frames) {
    if (frame.size == 0 || std::size_t{frame.at} + frame.size > size) __builtin_trap();
    if (frame.milliseconds < std::exchange(before, frame.milliseconds)) __builtin_trap();
    if (&frame - video->frames.data() >= 4) continue;
    const auto planes = decoder->decode(file.subspan(frame.at, frame.size));
    if (!planes || planes->y == nullptr) continue;
    if (planes->width != video->width || planes->height != video->height) __builtin_trap();
    docent::video::fill_pixels(*planes, picture);
  }
  return 0;
}
