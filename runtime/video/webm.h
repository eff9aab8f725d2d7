#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "runtime/model/result.h"

namespace docent::video {

enum class Codec : std::uint8_t { Vp8, Vp9 };

/// A frame as it is coded: a part of the file.
struct Frame {
  std::uint32_t at = 0, size = 0;  ///< Bytes, from the file's beginning.
  std::uint32_t milliseconds = 0;  ///< From the first frame; never before the frame before.
  bool is_key = false;             ///< Can be decoded without those before it.
  bool is_shown = true;            ///< VP8 has frames that only others are made from.
};

/// What the head of a video says, and where its frames lie.
struct Video {
  Codec codec = Codec::Vp8;
  std::uint32_t width = 0, height = 0;  ///< As the head says; frames may say otherwise.
  double pixel_shape = 1;               ///< How wide a pixel is for its height; over 0.
  bool is_cropped = false;              ///< Something at its edges is not to be seen.
  bool has_sound = false;               ///< Another track holds it; nothing here plays it.
  std::vector<Frame> frames;            ///< At least one; the first is a key frame.

  /// The last frame is seen as long as the mean of the others.
  std::chrono::milliseconds duration() const noexcept;
  std::size_t shown() const noexcept;  ///< Frames.
};

/// What a kiosk plays beside all else that it does, on two cores without a fan.
struct Limits {
  std::uint32_t longest_side = 1280, shortest_side = 720;  ///< Pixels; either may be the width.
  std::uint32_t least_side = 16;
  double frames_a_second = 30;
  double squeeze = 0.01;  ///< By so much a circle may be wider or less wide than high.
  std::chrono::seconds duration{60};
  std::size_t bytes = std::size_t{12} << 20U;
};

/// Reads where the frames of a WebM file lie (RFC 8794, EBML; RFC 9559, Matroska; the parts of it
/// that the WebM project allows). Of several tracks of pictures it is the first. Any bytes are
/// safe: what is damaged, cut short, larger than `limits.bytes` or coded in another way is answered
/// with a sentence without the file's name. Takes memory for the frames alone.
Result<Video> read_webm(std::span<const std::byte> file, const Limits& limits = {});

/// What of it no kiosk plays, as a sentence; nothing where all is well.
std::optional<std::string> beyond(const Video& video, const Limits& limits = {});

}  // namespace docent::video
