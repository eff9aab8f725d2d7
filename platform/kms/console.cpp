#include "platform/kms/console.h"

#include <fcntl.h>
#include <linux/kd.h>
#include <sys/ioctl.h>

namespace docent::kms {

std::optional<QuietConsole> QuietConsole::take() noexcept {
  FileDescriptor tty(open("/dev/tty", O_RDWR | O_CLOEXEC | O_NOCTTY));
  int mode = 0;
  int keyboard = 0;
  if (tty.get() < 0 || ioctl(tty.get(), KDGETMODE, &mode) != 0 ||
      ioctl(tty.get(), KDGKBMODE, &keyboard) != 0)
    return std::nullopt;
  if (ioctl(tty.get(), KDSETMODE, KD_GRAPHICS) != 0) return std::nullopt;
  constexpr int off = 0x04;  // K_OFF: keys reach the kiosk through hidraw alone
  ioctl(tty.get(), KDSKBMODE, off);
  return QuietConsole(std::move(tty), mode, keyboard);
}

QuietConsole::~QuietConsole() {
  if (tty_.get() >= 0) give_back();  // less than 0: moved from
}

void QuietConsole::give_back() const noexcept {
  ioctl(tty_.get(), KDSKBMODE, keyboard_);
  ioctl(tty_.get(), KDSETMODE, mode_);
}

}  // namespace docent::kms
