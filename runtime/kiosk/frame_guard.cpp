#include "runtime/kiosk/frame_guard.h"

#include <condition_variable>
#include <csignal>
#include <cstdlib>
#include <mutex>
#include <utility>

#include "platform/journal/journal.h"
#include "runtime/kiosk/signals.h"
#include "runtime/model/result.h"

namespace docent::kiosk {
namespace {

using namespace std::chrono_literals;

constexpr auto look_every = 50ms;

[[noreturn]] void end(Display& display, int exit_code) {
  display.abandon();
  std::_Exit(exit_code);
}

bool is_asked_to_end() noexcept {
  return is_signal_waiting(SIGTERM) || is_signal_waiting(SIGINT);
}

}  // namespace

FrameGuard::FrameGuard(Display& display, std::chrono::milliseconds patience)
    : display_(display),
      patience_(patience),
      thread_([this](const std::stop_token& stop) { watch(stop); }) {}

void FrameGuard::watch(const std::stop_token& stop) {
  std::mutex mutex;
  std::unique_lock lock(mutex);
  std::condition_variable_any stopped;
  std::uint64_t seen = 0;
  for (auto waited = 0ms; !stop.stop_requested();) {
    stopped.wait_for(lock, stop, look_every, [] { return false; });
    const std::uint64_t frames = frames_.load(std::memory_order_relaxed);
    waited = std::exchange(seen, frames) == frames ? waited + look_every : 0ms;
    if (frames == 0 && is_asked_to_end()) end(display_, 0);
    if (frames == 0 || waited < patience_) continue;
    if (display_.is_lost()) {
      journal::tell(journal::Message::ScreenLost, display_.loss());
      end(display_, exit_code(Errc::Environment));
    }
    if (is_asked_to_end()) {
      journal::tell(journal::Message::FrameUnfinished,
                    "it ends in the middle of a frame, which the graphics driver has not finished");
      end(display_, 0);
    }
  }
}

}  // namespace docent::kiosk
