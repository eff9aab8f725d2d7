#pragma once

#include <csignal>
#include <cstdint>
#include <optional>
#include <utility>

#include "platform/file_descriptor.h"

namespace docent::kms {

/// What the console asks of the program that draws.
enum class ConsoleEvent : std::uint8_t {
  None,
  Leave,   ///< Somebody wants to see another terminal: let go of the card, then allow_leave().
  Return,  ///< This one is shown again.
};

/// Takes the text console out of the way while the kiosk draws: no cursor over the picture, no
/// typed keys in the shell behind it. The console comes back when this goes.
///
/// Who switches to another terminal (`chvt`) gets it as soon as the kiosk has let go of the card.
/// The kernel asks by two real-time signals, which are blocked and read from a descriptor: they
/// interrupt nothing, and no other signal is touched.
class QuietConsole {
 public:
  /// Blocks the two signals for this thread and all that it begins later; call it before the first.
  static void expect_signals() noexcept;
  /// Empty where this process has no virtual console (a unit without a TTY, a remote shell): then
  /// nothing is in the way.
  static std::optional<QuietConsole> take() noexcept;
  QuietConsole(QuietConsole&&) noexcept = default;
  QuietConsole& operator=(QuietConsole&&) = delete;
  ~QuietConsole();

  /// For poll(): there is an event; -1 where there never is.
  int fd() const noexcept { return signals_.get(); }
  /// Waits for nothing.
  ConsoleEvent take_event() const noexcept;
  void allow_leave() const noexcept;
  void confirm_return() const noexcept;

  /// Gives the console back now; any thread may.
  void give_back() const noexcept;

 private:
  QuietConsole(FileDescriptor tty, int mode, int keyboard) noexcept
      : tty_(std::move(tty)), mode_(mode), keyboard_(keyboard) {}
  void be_asked_before_leaving() noexcept;

  FileDescriptor tty_, signals_;
  int mode_, keyboard_;  ///< What they were before.
};

}  // namespace docent::kms
