#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "runtime/input/contact.h"
#include "runtime/input/report_descriptor.h"

namespace docent::input {

/// A key as the kiosk names it.
struct KeyName {
  Key key = Key::None;
  char character = 0;  ///< Key::Character: 'A'..'Z', '0'..'9'. Key::Function: its number.

  bool operator==(const KeyName&) const = default;
};

/// The key behind a usage of the Keyboard or Consumer page (HID Usage Tables 1.12, sections 10 and
/// 15); Key::None for one that the kiosk does not use.
KeyName key_of(Usage usage) noexcept;

/// "UP", "ENTER", "A", "7", "F13": as docent(1) and visits write it.
std::string to_string(KeyName key);
/// The reverse; Key::None for an unknown name.
KeyName key_from_string(std::string_view name) noexcept;

/// A key that a keypad sends, and the one that it means.
struct KeyMeaning {
  KeyName sent, meant;

  bool operator==(const KeyMeaning&) const = default;
};

/// The key fields of a descriptor's keyboards, keypads and consumer controls; empty when it has
/// none.
std::vector<ReportField> find_keys(const ReportDescriptor& descriptor);

/// A key that went down or came up.
struct KeyEdge {
  KeyName key;
  bool down = false;

  bool operator==(const KeyEdge&) const = default;
};

/// Turns keyboard and consumer reports into edges. One per device; take() does not allocate.
class KeyDecoder {
 public:
  KeyDecoder(const ReportDescriptor& descriptor, std::vector<ReportField> fields);

  /// Takes one input report and writes the edges that it made, releases first; returns how many.
  std::size_t take(std::span<const std::byte> report, std::span<KeyEdge> out) noexcept;
  /// The device has gone: all keys that are down go up.
  std::size_t release(std::span<KeyEdge> out) noexcept;

 private:
  static constexpr std::size_t key_slots = 256;  ///< A small number for every KeyName.
  static std::size_t slot_of(KeyName key) noexcept;
  static KeyName key_at(std::size_t slot) noexcept;
  std::bitset<key_slots> down_in_any_report() const noexcept;

  bool numbered_;
  std::vector<ReportField> fields_;
  /// Per report id, the keys that are down: a report tells only of its own keys. A key that two
  /// reports name goes down with the first of them and up with the last.
  std::array<std::bitset<key_slots>, 256> down_by_report_{};
};

}  // namespace docent::input
