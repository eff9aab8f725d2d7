#include "runtime/kiosk/pin_command.h"

#include <fmt/format.h>
#include <termios.h>
#include <unistd.h>

#include <iostream>
#include <string>

#include "platform/pin/pin.h"
#include "runtime/kiosk/options.h"

namespace docent::kiosk {
namespace {

/// While it lives, what is typed is not shown.
class Unseen {
 public:
  Unseen() noexcept {
    is_terminal_ = tcgetattr(STDIN_FILENO, &before_) == 0;
    termios quiet = before_;
    quiet.c_lflag &= ~static_cast<tcflag_t>(ECHO);
    if (is_terminal_) tcsetattr(STDIN_FILENO, TCSAFLUSH, &quiet);
  }
  Unseen(const Unseen&) = delete;
  Unseen& operator=(const Unseen&) = delete;
  ~Unseen() {
    if (is_terminal_) tcsetattr(STDIN_FILENO, TCSAFLUSH, &before_);
  }

 private:
  termios before_{};
  bool is_terminal_ = false;
};

std::string ask(std::string_view question) {
  const bool shown = isatty(STDIN_FILENO) != 0;
  if (shown) fmt::print(stderr, "{}: ", question);
  std::string line;
  std::getline(std::cin, line);
  if (shown) fmt::print(stderr, "\n");
  if (!line.empty() && line.back() == '\r') line.pop_back();
  return line;
}

int make_pin() {
  std::string pin;
  std::string again;
  {
    const Unseen unseen;
    pin = ask("A PIN for staff, 4 to 12 figures");
    again = isatty(STDIN_FILENO) != 0 ? ask("The same again") : pin;
  }
  if (pin != again) return say({Errc::InvalidInput, "the two are not the same: nothing is made"});
  const Result<std::string> hash = pin::hash(pin);
  if (!hash) return say(hash.error());
  fmt::print("staff_pin = \"{}\"\n", *hash);
  return 0;
}

}  // namespace

terminal::Command pin_command() {
  return {.name = "pin",
          .manual = "asks for a PIN of the staff's and prints the line for kiosk.toml",
          .run = make_pin};
}

}  // namespace docent::kiosk
