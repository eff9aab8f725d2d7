#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

#include "runtime/model/museum.h"

namespace docent::kiosk {

/// What the staff's screens say.
enum class StaffWord : std::uint8_t {
  Title,
  Delete,
  Enter,
  Close,
  Back,
  Wrong,  ///< {n}: seconds.
  Wait,   ///< {n}: seconds.
  Calibrate,
  Diagnose,
  Exit,
  Mark,
  Felt,
  Far,
  Confirm,
  Keep,
  Moved,  ///< {n}: per cent; {seconds}.
  Kept,
  KeptForNow,
  OldBack,
  Version,
  Shows,
  ShowsWhat,  ///< {title}, {floors}, {exhibits}, {languages}.
  Database,
  Screen,
  Frames,
  FramesMade,  ///< {made}, {late}.
  FrameTime,
  FrameTakes,  ///< {n}, {most}, {drawing}: milliseconds.
  Touches,
  SinceStart,  ///< {n}.
  TouchScreen,
  Keypad,
  Ignored,
  Devices,
  NoDevices,
};
inline constexpr std::size_t staff_words_count = static_cast<std::size_t>(StaffWord::NoDevices) + 1;

/// Them in one language.
struct StaffWords {
  std::string language = "en";  ///< BCP 47.
  bool right_to_left = false;
  std::array<std::string, 10> digits;
  std::array<std::string, staff_words_count> words;

  std::string_view operator[](StaffWord word) const noexcept {
    return words[static_cast<std::size_t>(word)];
  }
  /// The text with the language's own digits.
  std::string in_digits(std::string_view text) const;
  /// The word with every "{name}" filled in, numbers in the language's own digits.
  std::string filled(StaffWord word,
                     std::initializer_list<std::pair<std::string_view, std::string>> values) const;
  /// "1 of 4", as visitors read it on the pages of a list.
  std::string one_of(std::size_t number, std::size_t total) const;

  std::string page_of;  ///< {n}, {total}.
};

/// As a museum's words files say it. A museum without such words in the language speaks its first
/// one to its staff, and English where that has none either.
StaffWords staff_words(const Museum& museum, std::uint32_t language);

/// The key of a word in the words files.
std::string_view key_of(StaffWord word) noexcept;

}  // namespace docent::kiosk
