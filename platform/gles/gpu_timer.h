#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace docent::gles {

/// How long the GPU works on a frame (EXT_disjoint_timer_query). The answer comes a few frames
/// later and is never waited for. Where the driver has no timers, no answer comes. For the frame
/// thread, with its context current from construction to destruction; does not allocate after
/// construction.
class GpuTimer {
 public:
  GpuTimer();
  ~GpuTimer();
  GpuTimer(const GpuTimer&) = delete;
  GpuTimer& operator=(const GpuTimer&) = delete;

  void begin() noexcept;
  void end() noexcept;
  /// The next frame's time, oldest first, if the GPU has finished it.
  std::optional<std::chrono::nanoseconds> take() noexcept;

 private:
  static constexpr std::size_t most_in_flight = 8;
  using GetResult = void (*)(std::uint32_t, std::uint32_t, std::uint64_t*);

  GetResult get_result_ = nullptr;  ///< Null where there are no timers.
  std::array<std::uint32_t, most_in_flight> query_{};
  std::size_t asked_ = 0, answered_ = 0;
  bool running_ = false;
};

}  // namespace docent::gles
