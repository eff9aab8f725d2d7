#include "platform/x11/window_keys.h"

namespace docent::x11 {

// The values are those of the X11 protocol's keysym encoding (X.Org, "X Window System Protocol",
// appendix A).
input::KeyName key_of_keysym(std::uint32_t keysym) noexcept {
  const auto between = [&](std::uint32_t first, std::uint32_t last) {
    return keysym >= first && keysym <= last;
  };
  if (between('0', '9') || between('A', 'Z'))
    return {input::Key::Character, static_cast<char>(keysym)};
  if (between('a', 'z')) return {input::Key::Character, static_cast<char>(keysym - 'a' + 'A')};
  constexpr std::uint32_t f1 = 0xffbe;
  constexpr std::uint32_t f24 = f1 + 23;
  if (between(f1, f24)) return {input::Key::Function, static_cast<char>(keysym - f1 + 1)};
  switch (keysym) {
    case 0xff52:
      return {input::Key::Up};
    case 0xff54:
      return {input::Key::Down};
    case 0xff51:
      return {input::Key::Left};
    case 0xff53:
      return {input::Key::Right};
    case 0xff0d:  // Return
    case 0xff8d:  // KP_Enter
      return {input::Key::Enter};
    case 0xff1b:  // Escape
    case 0xff08:  // BackSpace
      return {input::Key::Back};
    case 0xff6a:
      return {input::Key::Help};
    case 0x1008ff13:
      return {input::Key::VolumeUp};
    case 0x1008ff11:
      return {input::Key::VolumeDown};
    default:
      return {};
  }
}

}  // namespace docent::x11
