#pragma once

#include <expected>
#include <string>

namespace docent {

/// Why something could not be made. The kind decides the exit code; the sentence is for people.
enum class Errc {
  InvalidInput,  ///< What people wrote is wrong: exit 1.
  WrongUsage,    ///< The command line is wrong: exit 2.
  Environment,   ///< A device, the disk, a permission: exit 3.
  NotFound,      ///< A file that should be there is not: exit 3.
  WrongVersion,  ///< A database of another schema: exit 1.
  Damaged,       ///< A database that is cut short or altered: exit 1.
};

/// `what` says what is wrong, where, and what to do, in one sentence an operator can act on.
struct Error {
  Errc code = Errc::InvalidInput;
  std::string what;
};

/// An error's sentence without the file that it begins with, for where the file is named already.
inline std::string without_file(const Error& error, const std::string& file) {
  return error.what.starts_with(file + ": ") ? error.what.substr(file.size() + 2) : error.what;
}

template <typename T>
using Result = std::expected<T, Error>;

/// The exit code for an error: 1, 2 or 3, as docent(1) lists them.
constexpr int exit_code(Errc code) noexcept {
  switch (code) {
    case Errc::InvalidInput:
    case Errc::WrongVersion:
    case Errc::Damaged:
      return 1;
    case Errc::WrongUsage:
      return 2;
    case Errc::Environment:
    case Errc::NotFound:
      break;
  }
  return 3;
}

}  // namespace docent
