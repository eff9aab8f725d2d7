#pragma once

#include <string_view>

#include "platform/file_descriptor.h"

namespace docent::kms {

/// Hears the kernel's own messages about screens that come and go (NETLINK_KOBJECT_UEVENT); needs
/// no udev daemon. Where the socket is not allowed, nothing is ever heard. Devices that are plugged
/// in and out all the time fill nothing: the kernel keeps messages about changes only.
class Hotplug {
 public:
  Hotplug() noexcept;

  /// For poll(): something can be read; -1 where nothing ever will be.
  int fd() const noexcept { return socket_.get(); }
  /// Reads what has come; true where a graphics card's screens may have changed. Waits for nothing.
  bool take() noexcept;

 private:
  FileDescriptor socket_;
};

/// Has the kernel drop what comes to this socket, unless it is about a change. False where it
/// cannot.
bool keep_changes_only(int socket) noexcept;

/// Is this message, as the kernel sends it (fields that end with a zero byte), about a graphics
/// card's screens?
bool tells_of_screens(std::string_view message) noexcept;

}  // namespace docent::kms
