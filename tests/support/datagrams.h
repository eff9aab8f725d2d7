#pragma once

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <optional>
#include <string>

#include "tests/support/temporary_folder.h"

namespace docent::test {

/// A socket of this test's own on which datagrams arrive, as a service manager's or the journal's
/// does.
class Datagrams {
 public:
  Datagrams() : descriptor_(socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strcpy(address.sun_path, path().c_str());
    EXPECT_EQ(bind(descriptor_, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  }
  Datagrams(const Datagrams&) = delete;
  Datagrams& operator=(const Datagrams&) = delete;
  ~Datagrams() { close(descriptor_); }

  std::string path() const { return (folder_.path() / "socket").string(); }

  /// The next that has arrived; waits for nothing.
  std::optional<std::string> next() const {
    std::array<char, 4096> space{};
    const ssize_t size = recv(descriptor_, space.data(), space.size(), MSG_DONTWAIT);
    if (size < 0) return std::nullopt;
    return std::string(space.data(), static_cast<std::size_t>(size));
  }

 private:
  TemporaryFolder folder_;
  int descriptor_;
};

}  // namespace docent::test
