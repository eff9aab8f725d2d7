#include "runtime/kiosk/signals.h"

#include <csignal>
#include <ctime>

namespace docent::kiosk {
namespace {

sigset_t only(int signal) noexcept {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, signal);
  return set;
}

}  // namespace

void expect_signal(int signal) noexcept {
  const sigset_t set = only(signal);
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
}

bool take_signal(int signal) noexcept {
  const sigset_t set = only(signal);
  const timespec at_once{};
  return sigtimedwait(&set, nullptr, &at_once) == signal;
}

bool is_signal_waiting(int signal) noexcept {
  sigset_t waiting;
  return sigpending(&waiting) == 0 && sigismember(&waiting, signal) == 1;
}

}  // namespace docent::kiosk
