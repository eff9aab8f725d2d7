#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <thread>

#include "runtime/model/result.h"

namespace docent::service {

/// A socket at which anybody who may open it asks a question, one line, and is given the answer. It
/// has a thread of its own; the file goes when this does.
class StatusSocket {
 public:
  /// Calls `answer` with the question, on the socket's own thread; what it throws leaves the
  /// question without an answer.
  using Answer = std::function<std::string(std::string_view question)>;

  /// Makes the socket, which its owner and group may open, and the folder that holds it. A file
  /// that a program left behind is replaced. Fails with a sentence, and also where another program
  /// answers there.
  static Result<StatusSocket> open(const std::filesystem::path& path, Answer answer);
  StatusSocket(StatusSocket&& other) noexcept;
  StatusSocket& operator=(StatusSocket&&) = delete;
  ~StatusSocket();

 private:
  StatusSocket(std::filesystem::path path, int descriptor, Answer answer);

  std::filesystem::path path_;
  int descriptor_ = -1;
  std::jthread thread_;
};

/// Asks the program that answers at `path`. Fails with NotFound where there is none, Environment
/// where it may not be asked or does not answer within a few seconds.
Result<std::string> ask(const std::filesystem::path& path, std::string_view question);

}  // namespace docent::service
