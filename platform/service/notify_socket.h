#pragma once

#include <chrono>
#include <string_view>

namespace docent::service {

/// The way to the service manager that started this program: sd_notify(3) in its own words.
class NotifySocket {
 public:
  NotifySocket() = default;  ///< Nobody listens.
  /// What NOTIFY_SOCKET in the environment names: a path, or with '@' an abstract name; null: none.
  explicit NotifySocket(const char* name) noexcept;
  NotifySocket(NotifySocket&& other) noexcept;
  NotifySocket& operator=(NotifySocket&& other) noexcept;
  ~NotifySocket();

  bool is_there() const noexcept { return descriptor_ >= 0; }
  /// Tells lines such as "READY=1\nSTATUS=...". Neither waits nor allocates; where the manager does
  /// not take it at once, false, and it is as if it had not been told.
  bool tell(std::string_view lines) noexcept;

 private:
  int descriptor_ = -1;  ///< Connected.
};

/// How long the manager waits for a sign of life, as WATCHDOG_USEC and WATCHDOG_PID say; 0 where it
/// does not watch this process.
std::chrono::microseconds watchdog_patience(const char* usec, const char* pid) noexcept;

}  // namespace docent::service
