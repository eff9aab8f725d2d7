#include "platform/kms/hotplug.h"

#include <linux/filter.h>
#include <linux/netlink.h>
#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <cstdint>

namespace docent::kms {

Hotplug::Hotplug() noexcept
    : socket_(
          socket(AF_NETLINK, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, NETLINK_KOBJECT_UEVENT)) {
  sockaddr_nl address{};
  address.nl_family = AF_NETLINK;
  address.nl_groups = 1;    // the kernel's own messages
  keep_changes_only(fd());  // where it fails, the socket may fill, and screens are looked for
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

bool keep_changes_only(int socket) noexcept {
  constexpr std::uint32_t chan = 0x6368616e, nge_at = 0x6e676540, whole = 0xffffffff;
  // Does it begin with "change@"?
  std::array<sock_filter, 6> steps{
      {BPF_STMT(BPF_LD | BPF_W | BPF_ABS, 0), BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, chan, 0, 3),
       BPF_STMT(BPF_LD | BPF_W | BPF_ABS, 3), BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, nge_at, 0, 1),
       BPF_STMT(BPF_RET | BPF_K, whole), BPF_STMT(BPF_RET | BPF_K, 0)}};
  const sock_fprog program{.len = steps.size(), .filter = steps.data()};
  return setsockopt(socket, SOL_SOCKET, SO_ATTACH_FILTER, &program, sizeof program) == 0;
}

bool tells_of_screens(std::string_view message) noexcept {
  using namespace std::string_view_literals;
  return message.find("\0SUBSYSTEM=drm\0"sv) != std::string_view::npos &&
         message.find("\0ACTION=change\0"sv) != std::string_view::npos;
}

}  // namespace docent::kms
