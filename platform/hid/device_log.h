#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <span>
#include <string>

namespace docent::hid {

/// Decides what the journal is told about devices that cannot be used: each reason once, and not
/// before it has lasted for `patience`, because a device that is being plugged in may refuse for a
/// moment.
class DeviceLog {
 public:
  using Time = std::chrono::steady_clock::time_point;
  static constexpr std::chrono::seconds patience{2};

  /// A device cannot be used because of `reason`. Gives the sentence to say now, if any.
  std::optional<std::string> failed(const std::string& path, const std::string& reason, Time now);
  /// The device can be used: its next failure is news again.
  void works(const std::string& path);
  /// Forgets the devices that are no longer present.
  void keep(std::span<const std::string> present);
  /// Is there a device that failed when last looked at?
  bool has_failures() const noexcept { return !failures_.empty(); }

 private:
  struct Failure {
    std::string reason;
    Time since;
    bool said = false;
  };
  std::map<std::string, Failure> failures_;
};

}  // namespace docent::hid
