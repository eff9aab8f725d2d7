#include "platform/x11/window_keys.h"

namespace docent {

// The values are those of the X11 protocol's keysym encoding (X.Org, "X Window System Protocol",
// appendix A).
KeyName key_of_keysym(std::uint32_t keysym) noexcept {
  const auto between = [&](std::uint32_t first, std::uint32_t last) {
    return keysym >= first && keysym <= last;
  };
  if (between('0', '9') || between('A', 'Z')) return {Key::Character, static_cast<char>(keysym)};
  if (between('a', 'z')) return {Key::Character, static_cast<char>(keysym - 'a' + 'A')};
  constexpr std::uint32_t f1 = 0xffbe;
  constexpr std::uint32_t f24 = f1 + 23;
  if (between(f1, f24)) return {Key::Function, static_cast<char>(keysym - f1 + 1)};
  switch (keysym) {
    case 0xff52:
      return {Key::Up};
    case 0xff54:
      return {Key::Down};
    case 0xff51:
      return {Key::Left};
    case 0xff53:
      return {Key::Right};
    case 0xff0d:  // Return
    case 0xff8d:  // KP_Enter
      return {Key::Enter};
    case 0xff1b:  // Escape
    case 0xff08:  // BackSpace
      return {Key::Back};
    case 0xff6a:
      return {Key::Help};
    case 0x1008ff13:
      return {Key::VolumeUp};
    case 0x1008ff11:
      return {Key::VolumeDown};
    default:
      return {};
  }
}

}  // namespace docent
