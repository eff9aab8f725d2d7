#pragma once

#include <chrono>

#include "runtime/model/result.h"

namespace docent::hid {

/// Listens to the kernel's own messages about devices that come and go (NETLINK_KOBJECT_UEVENT);
/// needs no udev daemon.
class Uevents {
 public:
  /// Fails with a sentence where the socket is not allowed (say by a systemd unit whose
  /// RestrictAddressFamilies lacks AF_NETLINK).
  static Result<Uevents> open();
  Uevents(Uevents&& other) noexcept;
  Uevents& operator=(Uevents&&) = delete;
  Uevents(const Uevents&) = delete;
  Uevents& operator=(const Uevents&) = delete;
  ~Uevents();

  /// Waits up to `patience`; true when a hidraw device came or went meanwhile.
  bool hidraw_changed(std::chrono::milliseconds patience) noexcept;

 private:
  explicit Uevents(int socket) : socket_(socket) {}
  int socket_;
};

}  // namespace docent::hid
