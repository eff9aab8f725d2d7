#include "platform/kms/console.h"

#include <fcntl.h>
#include <linux/kd.h>
#include <linux/vt.h>
#include <sys/ioctl.h>
#include <sys/signalfd.h>
#include <unistd.h>

namespace docent::kms {
namespace {

int leave_signal() noexcept {
  return SIGRTMIN;
}
int return_signal() noexcept {
  return SIGRTMIN + 1;
}

sigset_t console_signals() noexcept {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, leave_signal());
  sigaddset(&set, return_signal());
  return set;
}

}  // namespace

void QuietConsole::expect_signals() noexcept {
  const sigset_t set = console_signals();
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
}

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
  QuietConsole console(std::move(tty), mode, keyboard);
  console.be_asked_before_leaving();
  return console;
}

void QuietConsole::be_asked_before_leaving() noexcept {
  const sigset_t set = console_signals();
  signals_ = FileDescriptor(signalfd(-1, &set, SFD_NONBLOCK | SFD_CLOEXEC));
  if (signals_.get() < 0) return;
  vt_mode wanted{};
  wanted.mode = VT_PROCESS;
  wanted.relsig = static_cast<short>(leave_signal());
  wanted.acqsig = static_cast<short>(return_signal());
  if (ioctl(tty_.get(), VT_SETMODE, &wanted) != 0) signals_ = FileDescriptor();
}

ConsoleEvent QuietConsole::take_event() const noexcept {
  signalfd_siginfo info{};
  if (fd() < 0 || read(fd(), &info, sizeof info) != sizeof info) return ConsoleEvent::None;
  return static_cast<int>(info.ssi_signo) == leave_signal() ? ConsoleEvent::Leave
                                                            : ConsoleEvent::Return;
}

void QuietConsole::allow_leave() const noexcept {
  ioctl(tty_.get(), VT_RELDISP, 1);
}

void QuietConsole::confirm_return() const noexcept {
  ioctl(tty_.get(), VT_RELDISP, VT_ACKACQ);
}

QuietConsole::~QuietConsole() {
  if (tty_.get() >= 0) give_back();  // less than 0: moved from
}

void QuietConsole::give_back() const noexcept {
  vt_mode automatic{};
  automatic.mode = VT_AUTO;
  ioctl(tty_.get(), VT_SETMODE, &automatic);
  ioctl(tty_.get(), KDSKBMODE, keyboard_);
  ioctl(tty_.get(), KDSETMODE, mode_);
}

}  // namespace docent::kms
