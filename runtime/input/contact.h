#pragma once

#include <cstdint>

namespace docent::input {

/// A finger on the glass. Screen frame; a decoder gives it as the device lies, before rotation.
struct Contact {
  std::uint32_t id = 0;  ///< Stays with the finger while it is down.
  float x = 0, y = 0;    ///< [0, 1].
};

/// Keys that the kiosk understands beside letters, digits and F1...
enum class Key : std::uint8_t {
  None,
  Up,
  Down,
  Left,
  Right,
  Enter,
  Back,
  Help,
  VolumeUp,
  VolumeDown,
  Character,
  Function
};

/// What happened at the glass or the keypad. Scripted visits and devices produce the same events.
struct InputEvent {
  enum class Kind : std::uint8_t {
    Down,
    Move,
    Up,
    Cancel,  ///< A contact has ended that no finger meant: a palm, or its device has gone.
    KeyDown,
    KeyUp
  };
  Kind kind = Kind::Down;
  Contact contact;      ///< For Down, Move, Up and Cancel.
  Key key = Key::None;  ///< For KeyDown and KeyUp.
  char character = 0;   ///< Key::Character: 'A'..'Z', '0'..'9'. Key::Function: its number.
};

}  // namespace docent::input
