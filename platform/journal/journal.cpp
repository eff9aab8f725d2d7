#include "platform/journal/journal.h"

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>

namespace docent::journal {
namespace {

constexpr const char* journal_socket = "/run/systemd/journal/socket";

/// The last problem, in place, so that remembering it takes no memory.
struct LastProblem {
  std::mutex mutex;
  std::array<char, 512> text{};
  std::size_t size = 0;
};

LastProblem& problem() noexcept {
  static LastProblem last;
  return last;
}

void remember(std::string_view sentence) noexcept {
  LastProblem& last = problem();
  const std::lock_guard lock(last.mutex);
  last.size = std::min(sentence.size(), last.text.size());
  std::ranges::copy(sentence.substr(0, last.size), last.text.begin());
}

iovec part(std::string_view text) noexcept {
  return {.iov_base = const_cast<char*>(text.data()), .iov_len = text.size()};
}

}  // namespace

bool is_journal(int descriptor, const char* journal_stream) noexcept {
  if (journal_stream == nullptr) return false;
  struct stat file{};
  if (fstat(descriptor, &file) != 0) return false;
  char* rest = nullptr;
  const unsigned long long device = std::strtoull(journal_stream, &rest, 10);
  if (rest == journal_stream || *rest != ':') return false;
  const unsigned long long inode = std::strtoull(rest + 1, nullptr, 10);
  return device == file.st_dev && inode == file.st_ino;
}

bool send(const char* socket_path, Message message, std::string_view sentence) noexcept {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (std::strlen(socket_path) >= sizeof address.sun_path) return false;
  std::memcpy(address.sun_path, socket_path, std::strlen(socket_path));

  const MessageKind& kind = kind_of(message);
  const char priority = static_cast<char>('0' + static_cast<int>(kind.priority));
  // A field whose value may hold a line feed: its name, its length in 64 bits, little-endian, the
  // value.
  std::array<char, 8> length{};
  for (std::size_t i = 0; i < length.size(); ++i)
    length[i] = static_cast<char>(std::uint64_t{sentence.size()} >> (8 * i) & 0xff);
  std::array<iovec, 8> parts{part("SYSLOG_IDENTIFIER=docent\nMESSAGE_ID="),
                             part(kind.id),
                             part("\nPRIORITY="),
                             part({&priority, 1}),
                             part("\nMESSAGE\n"),
                             part({length.data(), length.size()}),
                             part(sentence),
                             part("\n")};
  msghdr datagram{};
  datagram.msg_name = &address;
  datagram.msg_namelen = sizeof address;
  datagram.msg_iov = parts.data();
  datagram.msg_iovlen = parts.size();
  const int descriptor = socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (descriptor < 0) return false;
  const bool sent = sendmsg(descriptor, &datagram, MSG_DONTWAIT | MSG_NOSIGNAL) >= 0;
  close(descriptor);
  return sent;
}

void tell(Message message, std::string_view sentence) noexcept {
  if (kind_of(message).priority <= Priority::Warning) remember(sentence);
  static const bool to_journal = is_journal(STDERR_FILENO, std::getenv("JOURNAL_STREAM"));
  if (to_journal && send(journal_socket, message, sentence)) return;
  std::fprintf(stderr, "docent: %.*s\n", static_cast<int>(sentence.size()), sentence.data());
}

std::string last_problem() {
  LastProblem& last = problem();
  const std::lock_guard lock(last.mutex);
  return {last.text.data(), last.size};
}

}  // namespace docent::journal
