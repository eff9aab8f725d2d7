#pragma once

#include <chrono>
#include <string_view>
#include <utility>

#include "platform/service/notify_socket.h"

namespace docent::kiosk {

/// What the service manager is told of this program: that it is ready when a visitor sees
/// something, that it lives as long as pictures reach the screen, and what it does. For the frame
/// thread; nothing here waits or allocates. Without a manager all of it does nothing.
class ServiceNotice {
 public:
  using Time = std::chrono::nanoseconds;  ///< Of the monotonic clock.

  /// `started`: when the program began. `patience`: how long the manager waits for a sign of life;
  /// 0: without end.
  ServiceNotice(service::NotifySocket manager, std::chrono::microseconds patience, Time started)
      : manager_(std::move(manager)), patience_(patience), started_(started) {}
  /// As the environment says that a service manager sets.
  static ServiceNotice of_environment(Time started);

  bool has_manager() const noexcept { return manager_.is_there(); }
  bool was_ready() const noexcept { return is_ready_; }

  /// A step of the start was begun: another five minutes for it, since a machine may be slow.
  void starts(std::string_view step) noexcept;
  /// A frame is on the screen. The first makes the service ready. A machine that needed long for
  /// its first frame is given three times as long for each later one.
  void frame_presented(Time now) noexcept { alive(now); }
  /// The loop says that nothing is to be drawn: nothing has changed since the last frame, or there
  /// is no screen to draw on. A sign of life too.
  void idle(Time now) noexcept { alive(now); }
  /// In a line of `systemctl status`.
  void shows(std::string_view museum) noexcept;
  void ends() noexcept { manager_.tell("STOPPING=1"); }

 private:
  void alive(Time now) noexcept;
  bool tell_ready(Time now) noexcept;

  service::NotifySocket manager_;
  std::chrono::microseconds patience_;
  Time started_;
  Time next_sign_{0};
  bool is_ready_ = false;
};

}  // namespace docent::kiosk
