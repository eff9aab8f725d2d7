#include "platform/hid/touch_device.h"

#include <fmt/format.h>
#include <hidapi/hidapi.h>

#include <cerrno>
#include <cstring>

namespace docent::hid {

void TouchDevice::Close::operator()(hid_device_* device) const noexcept {
  hid_close(device);
}

Result<TouchDevice> TouchDevice::open(const std::string& path) {
  errno = 0;
  Handle handle(hid_open_path(path.c_str()));
  if (!handle)
    return std::unexpected(Error{
        Errc::Environment,
        fmt::format(
            "{}: cannot open the input device ({}); its user must be allowed to read and to "
            "write it: install docent's udev rule, and DeviceAllow=char-hidraw rw in the unit",
            path, errno != 0 ? std::strerror(errno) : "no such device")});
  return TouchDevice(std::move(handle));
}

std::span<const std::byte> TouchDevice::read(std::chrono::milliseconds patience) noexcept {
  if (!handle_) return {};
  const int count = hid_read_timeout(handle_.get(), buffer_.data(), buffer_.size(),
                                     static_cast<int>(patience.count()));
  if (count < 0) handle_.reset();
  return std::as_bytes(std::span(buffer_)).first(count > 0 ? static_cast<std::size_t>(count) : 0);
}

}  // namespace docent::hid
