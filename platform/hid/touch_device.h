#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <memory>
#include <span>
#include <string>

#include "runtime/model/result.h"

struct hid_device_;  // hidapi's handle

namespace docent::hid {

/// One opened hidraw device: bytes in, no meaning.
class TouchDevice {
 public:
  /// Opening can take 50 ms, so not on the frame thread. Fails with a sentence naming the path.
  static Result<TouchDevice> open(const std::string& path);

  /// Waits up to `patience` for the next input report; empty when none came. Called by the device's
  /// own reader thread, because the kernel keeps only 64 reports. The bytes stay valid until the
  /// next read.
  std::span<const std::byte> read(std::chrono::milliseconds patience) noexcept;

  /// False once a read has failed: the device was unplugged.
  bool is_present() const noexcept { return handle_ != nullptr; }

 private:
  struct Close {
    void operator()(hid_device_* device) const noexcept;
  };
  using Handle = std::unique_ptr<hid_device_, Close>;
  explicit TouchDevice(Handle handle) : handle_(std::move(handle)) {}

  Handle handle_;
  std::array<unsigned char, 16384> buffer_{};  // the kernel's largest report
};

}  // namespace docent::hid
