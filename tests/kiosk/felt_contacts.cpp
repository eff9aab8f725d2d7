// What the kiosk's own readers feel of one touch screen, as tests/kiosk/kernel_contacts.py compares
// it with the kernel: a line for each event, with the time of the monotonic clock in nanoseconds at
// which it arrived, `down`, `move` or `up`, and the contact's identifier, x and y.
//
//     felt_contacts /dev/hidrawN

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <string>
#include <thread>

#include "platform/clock/monotonic_clock.h"
#include "platform/hid/input_devices.h"

namespace {

using docent::input::InputEvent;

const char* name_of(InputEvent::Kind kind) noexcept {
  switch (kind) {
    case InputEvent::Kind::Down:
      return "down";
    case InputEvent::Kind::Move:
      return "move";
    case InputEvent::Kind::Up:
    case InputEvent::Kind::Cancel:
      return "up";
    default:
      return "key";
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  auto devices = docent::hid::InputDevices::open({argv[1]});
  if (!devices) {
    fmt::print(stderr, "felt_contacts: {}\n", devices.error().what);
    return 1;
  }
  fmt::print("ready\n");
  std::fflush(stdout);
  std::array<InputEvent, 256> events;
  for (;;) {
    const std::size_t count = devices->arrived(events);
    const auto now = docent::clock::monotonic_now().count();
    for (std::size_t i = 0; i < count; ++i)
      fmt::print("{} {} {} {:.6f} {:.6f}\n", now, name_of(events[i].kind), events[i].contact.id,
                 events[i].contact.x, events[i].contact.y);
    if (count > 0) std::fflush(stdout);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}
