#include "platform/service/notify_socket.h"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace docent::service {

NotifySocket::NotifySocket(const char* name) noexcept {
  if (name == nullptr || (name[0] != '/' && name[0] != '@')) return;
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::size_t length = std::strlen(name);
  if (length >= sizeof address.sun_path) return;
  std::memcpy(address.sun_path, name, length);
  if (name[0] == '@') address.sun_path[0] = '\0';
  const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + length);
  descriptor_ = socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (descriptor_ < 0) return;
  if (connect(descriptor_, reinterpret_cast<const sockaddr*>(&address), size) == 0) return;
  close(descriptor_);
  descriptor_ = -1;
}

NotifySocket::NotifySocket(NotifySocket&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)) {}

NotifySocket& NotifySocket::operator=(NotifySocket&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

NotifySocket::~NotifySocket() {
  if (descriptor_ >= 0) close(descriptor_);
}

bool NotifySocket::tell(std::string_view lines) noexcept {
  return is_there() && ::send(descriptor_, lines.data(), lines.size(),
                              MSG_DONTWAIT | MSG_NOSIGNAL) == static_cast<ssize_t>(lines.size());
}

std::chrono::microseconds watchdog_patience(const char* usec, const char* pid) noexcept {
  if (usec == nullptr) return {};
  if (pid != nullptr && std::strtol(pid, nullptr, 10) != getpid()) return {};
  return std::chrono::microseconds(std::strtoll(usec, nullptr, 10));
}

}  // namespace docent::service
