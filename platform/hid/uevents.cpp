#include "platform/hid/uevents.h"

#include <fmt/format.h>
#include <linux/netlink.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <string_view>
#include <utility>

namespace docent::hid {

Result<Uevents> Uevents::open() {
  const int fd =
      socket(AF_NETLINK, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, NETLINK_KOBJECT_UEVENT);
  sockaddr_nl address{};
  address.nl_family = AF_NETLINK;
  address.nl_groups = 1;  // the kernel's own messages
  if (fd < 0 || bind(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    const int why = errno;
    if (fd >= 0) close(fd);
    return std::unexpected(
        Error{Errc::Environment,
              fmt::format("cannot listen for devices that come and go ({}); allow AF_NETLINK in "
                          "the unit, or devices are looked for every two seconds",
                          std::strerror(why))});
  }
  return Uevents(fd);
}

Uevents::Uevents(Uevents&& other) noexcept : socket_(std::exchange(other.socket_, -1)) {}

Uevents::~Uevents() {
  if (socket_ >= 0) close(socket_);
}

bool Uevents::hidraw_changed(std::chrono::milliseconds patience) noexcept {
  pollfd waiting{.fd = socket_, .events = POLLIN, .revents = 0};
  if (poll(&waiting, 1, static_cast<int>(patience.count())) <= 0) return false;
  bool changed = false;
  std::array<char, 8192> message;
  for (;;) {
    const ssize_t size = recv(socket_, message.data(), message.size(), 0);
    if (size < 0) return changed || errno == ENOBUFS;  // too many messages to hold: look again
    const std::string_view text(message.data(), static_cast<std::size_t>(size));
    changed |= text.find("SUBSYSTEM=hidraw") != std::string_view::npos;
  }
}

}  // namespace docent::hid
