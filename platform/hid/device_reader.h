#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <span>
#include <thread>

#include "runtime/input/event_maker.h"
#include "runtime/input/event_queue.h"

namespace docent::hid {

/// Where reports come from. Waits up to the given time; an empty span is none. `is_present` false
/// ends the reading.
struct ReportSource {
  std::function<std::span<const std::byte>(std::chrono::milliseconds patience)> read;
  std::function<bool()> is_present;
};

/// Reads one device on a thread of its own, because the kernel keeps only 64 of its reports.
///
/// The thread never waits for the frame loop while fingers only move: where the loop is behind, it
/// is told where they ended up. So no report is lost, and none is late. Only fingers and keys that
/// go down or up in their hundreds without a frame between them are waited for.
class DeviceReader {
 public:
  /// Begins to read; what was read before must have ended. For the supervisor's thread.
  void start(ReportSource source, input::EventMaker maker);
  /// Asks the thread to end and waits for it, a twentieth of a second at most.
  void stop();
  void request_stop() noexcept { thread_.request_stop(); }
  /// False once the device has gone. Whatever was down has been lifted then.
  bool is_reading() const noexcept { return reading_; }

  /// For the frame thread: the next event, if there is one. Never waits.
  bool pop(input::InputEvent& event) noexcept { return queue_.pop(event); }

  /// Reports read so far, for measurements.
  std::uint64_t reports() const noexcept { return reports_; }

 private:
  void read(const std::stop_token& stop, ReportSource& source, input::EventMaker& maker) noexcept;
  void deliver(std::span<const input::InputEvent> events, const std::stop_token& stop) noexcept;

  std::atomic<bool> reading_{false};
  std::atomic<std::uint64_t> reports_{0};
  input::EventQueue queue_;
  std::jthread thread_;  // last: it ends before what it uses
};

}  // namespace docent::hid
