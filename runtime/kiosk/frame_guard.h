#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <thread>

#include "platform/display.h"

namespace docent::kiosk {

/// Ends the program where the frame thread cannot. Signals are taken between two frames, so one
/// that asks to end would wait for all that a start does; and a graphics driver may never return
/// from a frame whose display has gone (Mesa without its X server).
///
/// Before the first frame nothing is left behind: SIGTERM and SIGINT end the program at once.
/// Afterwards a frame that was begun has `patience` to end. Borrows the display.
class FrameGuard {
 public:
  /// On a screen: within the second that SIGTERM gives.
  static constexpr std::chrono::milliseconds on_screen{600};
  /// In memory there is no driver that waits, and what is recorded is to be whole.
  static constexpr std::chrono::milliseconds in_memory = std::chrono::milliseconds::max();

  FrameGuard(Display& display, std::chrono::milliseconds patience);

  void frame_made() noexcept { frames_.fetch_add(1, std::memory_order_relaxed); }

 private:
  void watch(const std::stop_token& stop);

  Display& display_;
  std::chrono::milliseconds patience_;
  std::atomic<std::uint64_t> frames_{0};
  std::jthread thread_;
};

}  // namespace docent::kiosk
