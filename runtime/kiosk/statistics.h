#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>

#include "runtime/model/result.h"

namespace docent::kiosk {

/// A histogram of durations; a bin is 2 % wider than the one before. Filling it does not allocate.
class Durations {
 public:
  void add(std::chrono::nanoseconds duration) noexcept;
  /// Milliseconds that the given share of the durations did not exceed; 0 where there are none.
  double milliseconds_at(double share) const noexcept;
  double longest_milliseconds() const noexcept;

 private:
  static constexpr std::size_t bin_count = 1024;
  std::array<std::uint32_t, bin_count> bin_{};
  std::uint64_t count_ = 0;
  std::chrono::nanoseconds longest_{0};
};

/// What a run tells of the videos that it played.
struct VideoCounters {
  std::uint64_t shown = 0;               ///< Frames that were seen.
  std::uint64_t dropped = 0;             ///< Frames that came too late.
  std::chrono::nanoseconds decoding{0};  ///< Of all frames: processor time of the thread.
  std::uint64_t decoded = 0;

  VideoCounters& operator+=(const VideoCounters& other) noexcept {
    shown += other.shown;
    dropped += other.dropped;
    decoding += other.decoding;
    decoded += other.decoded;
    return *this;
  }
};

/// What --stats writes: the keys of docent(1).
struct Statistics {
  std::uint64_t frames = 0, touches = 0, routes = 0, collisions = 0, dropped_frames = 0;
  std::uint64_t allocations_in_frames = 0;
  Durations frame_cpu, gl, input_to_frame, gpu;
  std::chrono::nanoseconds start_to_first_frame{0};
  VideoCounters video;  ///< Of the museum that was shown last.
};

/// How many frames a screen of this rate missed while one was made.
std::uint64_t missed_frames(std::chrono::nanoseconds since_last_frame,
                            double frames_per_second) noexcept;

std::string to_json(const Statistics& statistics);

/// Writes a file completely or not at all.
Result<void> write_whole(const std::filesystem::path& file, std::string_view text);

/// CPU time of this thread.
std::chrono::nanoseconds thread_cpu_now() noexcept;

}  // namespace docent::kiosk
