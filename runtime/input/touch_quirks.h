#pragma once

#include <cstdint>
#include <span>

namespace docent::input {

/// How a touch screen's reports are to be understood. The defaults are those of a Windows 7 screen
/// that keeps to its specification; `usual_rules` (contact_decoder.h) derives from the descriptor
/// what can be derived, and `known_quirks` has what cannot.
struct TouchRules {
  /// Which of a report's contacts say something.
  enum class Valid : std::uint8_t { Always, WithTip, InRange, WithConfidence };
  /// What tells one finger from another.
  enum class Identity : std::uint8_t { Identifier, Position, IdentifierFromOne };
  /// What has become of a contact that a whole frame does not mention.
  enum class Missing : std::uint8_t { IsWaitedFor, HasGone, Rests };
  /// What the contact count is good for.
  enum class Count : std::uint8_t { IsExact, EndsTheFrame };

  Valid valid = Valid::Always;
  Identity identity = Identity::Identifier;
  Missing missing = Missing::IsWaitedFor;
  Count count = Count::IsExact;
  bool first_of_twins = false;   ///< Of two contacts with one id in a frame the first that is down
                                 ///< counts, otherwise the last.
  bool applies_at_once = false;  ///< Every report is news by itself: no frame is waited for.
};

/// One device whose descriptor does not tell how it departs from its specification.
struct TouchQuirk {
  std::uint16_t vendor = 0, product = 0;
  TouchRules rules;
  const char* why = "";
};

/// All of them; the table is touch_quirks.cpp.
std::span<const TouchQuirk> known_quirks() noexcept;

/// The entry of a USB device, or null: most have none.
const TouchQuirk* quirk_of(std::uint16_t vendor, std::uint16_t product) noexcept;

}  // namespace docent::input
