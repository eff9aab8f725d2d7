#pragma once

#include <optional>

#include "platform/kms/graphics_card.h"

namespace docent::kms {

/// Takes the text console out of the way while the kiosk draws: no cursor over the picture, no
/// typed keys in the shell behind it. The console comes back when this goes.
class QuietConsole {
 public:
  /// Empty where this process has no virtual console (a unit without a TTY, a remote shell): then
  /// nothing is in the way.
  static std::optional<QuietConsole> take() noexcept;
  QuietConsole(QuietConsole&&) noexcept = default;
  QuietConsole& operator=(QuietConsole&&) = delete;
  ~QuietConsole();

  /// Gives the console back now; any thread may.
  void give_back() const noexcept;

 private:
  QuietConsole(FileDescriptor tty, int mode, int keyboard) noexcept
      : tty_(std::move(tty)), mode_(mode), keyboard_(keyboard) {}
  FileDescriptor tty_;
  int mode_, keyboard_;  ///< What they were before.
};

}  // namespace docent::kms
