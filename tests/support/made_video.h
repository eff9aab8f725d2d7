#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "runtime/video/webm.h"

namespace docent::test {

/// An EBML element (RFC 8794) with its size in the fewest bytes.
std::string element(std::uint32_t id, const std::string& content);
std::string element(std::uint32_t id, std::uint64_t number);
/// One that ends where what holds it does.
std::string endless(std::uint32_t id, const std::string& content);

/// A video of a bar that goes from left to right over a grey ground.
struct VideoSketch {
  video::Codec codec = video::Codec::Vp9;
  std::uint32_t width = 64, height = 48;
  std::size_t frames = 10;
  std::uint64_t milliseconds_a_frame = 40;
  std::uint32_t says_width = 0, says_height = 0;  ///< Its head; 0: the truth.
  std::uint32_t says_shown_width = 0, says_shown_height = 0, says_unit = 0;  ///< 0: nothing.
  std::uint32_t says_cropped = 0;                                            ///< At its right.
  std::string says_codec{};                                                  ///< Likewise.
  std::string says_kind = "webm";
  bool has_sound = false;
  bool is_streamed = false;  ///< As browsers record: nothing tells its size.
  std::size_t first = 0;     ///< The frames before are left out.
};

/// What libvpx makes of the sketch, frame by frame.
std::vector<std::string> coded_frames(const VideoSketch& sketch);
/// The bytes of a WebM file.
std::string make_video(const VideoSketch& sketch);
/// The same with frames of one's own.
std::string make_video(const VideoSketch& sketch, std::span<const std::string> frames);

inline std::span<const std::byte> bytes_of(const std::string& text) {
  return std::as_bytes(std::span(text));
}

}  // namespace docent::test
