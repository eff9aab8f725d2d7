#include "platform/kms/hotplug.h"

#include <linux/netlink.h>
#include <sys/socket.h>

#include <array>
#include <cerrno>

namespace docent::kms {

Hotplug::Hotplug() noexcept
    : socket_(
          socket(AF_NETLINK, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, NETLINK_KOBJECT_UEVENT)) {
  sockaddr_nl address{};
  address.nl_family = AF_NETLINK;
  address.nl_groups = 1;  // the kernel's own messages
  if (fd() >= 0 && bind(fd(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
    socket_ = FileDescriptor();
}

bool Hotplug::take() noexcept {
  if (fd() < 0) return false;
  std::array<char, 8192> message;
  for (bool changed = false;;) {
    const ssize_t size = recv(fd(), message.data(), message.size(), 0);
    if (size < 0) return changed || errno == ENOBUFS;  // too many to hold: look
    changed |= tells_of_screens({message.data(), static_cast<std::size_t>(size)});
  }
}

bool tells_of_screens(std::string_view message) noexcept {
  using namespace std::string_view_literals;
  return message.find("\0SUBSYSTEM=drm\0"sv) != std::string_view::npos &&
         message.find("\0ACTION=change\0"sv) != std::string_view::npos;
}

}  // namespace docent::kms
