#include "platform/service/status_socket.h"

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <optional>
#include <thread>
#include <utility>

#include "runtime/model/last_catch.h"

namespace docent::service {
namespace {

constexpr timeval to_ask{.tv_sec = 1, .tv_usec = 0};     // for who has connected
constexpr timeval to_answer{.tv_sec = 5, .tv_usec = 0};  // for who answers
constexpr std::chrono::milliseconds a_moment{50};
constexpr std::size_t longest_question = 64;

/// A file descriptor that is closed.
class Descriptor {
 public:
  explicit Descriptor(int number) noexcept : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0) close(number_);
  }
  int number() const noexcept { return number_; }
  int release() noexcept { return std::exchange(number_, -1); }

 private:
  int number_;
};

std::unexpected<Error> failure(const std::filesystem::path& path, const std::string& what,
                               Errc code = Errc::Environment) {
  return std::unexpected(Error{code, path.string() + ": " + what});
}

std::optional<sockaddr_un> address_of(const std::filesystem::path& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.native().size() >= sizeof address.sun_path) return std::nullopt;
  std::memcpy(address.sun_path, path.c_str(), path.native().size());
  return address;
}

int new_socket() noexcept {
  return socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
}

bool connects(int descriptor, const sockaddr_un& address) noexcept {
  return connect(descriptor, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
}

void be_patient(int descriptor, const timeval& patience) noexcept {
  setsockopt(descriptor, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  setsockopt(descriptor, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
}

bool send_all(int descriptor, std::string_view text) noexcept {
  while (!text.empty()) {
    const ssize_t sent = ::send(descriptor, text.data(), text.size(), MSG_NOSIGNAL);
    if (sent <= 0) return false;
    text.remove_prefix(static_cast<std::size_t>(sent));
  }
  return true;
}

/// One line, without its end; what there is where nothing more comes.
std::string read_question(int descriptor) {
  std::string question;
  char letter = 0;
  while (question.size() < longest_question && recv(descriptor, &letter, 1, 0) == 1 &&
         letter != '\n')
    question += letter;
  return question;
}

/// Until the socket is shut down, which wakes accept().
void serve(int listening, const StatusSocket::Answer& answer) noexcept {
  while (true) {
    const Descriptor asker(accept4(listening, nullptr, nullptr, SOCK_CLOEXEC));
    if (asker.number() < 0) {
      if (errno == EINVAL) return;
      std::this_thread::sleep_for(a_moment);  // no descriptor left, or somebody who left again
      continue;
    }
    be_patient(asker.number(), to_ask);
    guarded("answering how the kiosk is",
            [&] { send_all(asker.number(), answer(read_question(asker.number()))); });
  }
}

}  // namespace

Result<StatusSocket> StatusSocket::open(const std::filesystem::path& path, Answer answer) {
  const auto address = address_of(path);
  if (!address) return failure(path, "this name is too long for a socket");
  std::error_code ignored;
  std::filesystem::create_directories(path.parent_path(), ignored);
  if (const Descriptor other(new_socket()); connects(other.number(), *address))
    return failure(path, "another kiosk answers there already");
  unlink(path.c_str());
  Descriptor listening(new_socket());
  if (bind(listening.number(), reinterpret_cast<const sockaddr*>(&*address), sizeof *address) != 0)
    return failure(path, std::string("cannot be made (") + std::strerror(errno) + ")");
  constexpr int waiting_askers = 8;
  if (chmod(path.c_str(), 0660) != 0 || listen(listening.number(), waiting_askers) != 0)
    return failure(path, std::string("cannot be opened (") + std::strerror(errno) + ")");
  return StatusSocket(path, listening.release(), std::move(answer));
}

StatusSocket::StatusSocket(std::filesystem::path path, int descriptor, Answer answer)
    : path_(std::move(path)),
      descriptor_(descriptor),
      thread_([descriptor, a = std::move(answer)] { serve(descriptor, a); }) {}

StatusSocket::StatusSocket(StatusSocket&& other) noexcept
    : path_(std::move(other.path_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      thread_(std::move(other.thread_)) {}

StatusSocket::~StatusSocket() {
  if (descriptor_ < 0) return;
  shutdown(descriptor_, SHUT_RDWR);
  if (thread_.joinable()) thread_.join();
  close(descriptor_);
  unlink(path_.c_str());
}

Result<std::string> ask(const std::filesystem::path& path, std::string_view question) {
  const auto address = address_of(path);
  if (!address) return failure(path, "this name is too long for a socket");
  const Descriptor asking(new_socket());
  if (!connects(asking.number(), *address))
    return errno == ENOENT || errno == ECONNREFUSED
               ? failure(path, "nobody answers there", Errc::NotFound)
               : failure(path, std::string("cannot be asked (") + std::strerror(errno) + ")");
  be_patient(asking.number(), to_answer);
  std::string answer;
  std::array<char, 4096> some{};
  ssize_t got = -1;
  if (send_all(asking.number(), std::string(question) + "\n"))
    while ((got = recv(asking.number(), some.data(), some.size(), 0)) > 0)
      answer.append(some.data(), static_cast<std::size_t>(got));
  if (got < 0 || answer.empty()) return failure(path, "the kiosk does not answer");
  return answer;
}

}  // namespace docent::service
