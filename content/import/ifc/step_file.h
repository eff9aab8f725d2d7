#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace docent::import {

/// One argument of a record of a STEP file (ISO 10303-21, clause 6).
struct StepValue {
  enum class Kind : std::uint8_t { Absent, Number, Text, Word, Reference, List };
  Kind kind = Kind::Absent;  ///< `$` and `*` are absent; a typed value is what it holds.
  double number = 0;
  std::uint64_t reference = 0;  ///< Of `#12`.
  std::string text{};           ///< UTF-8; of `.WORD.` without the points; a typed list's type.
  std::vector<StepValue> items{};
};

/// A record: `#12=IFCWALL('...',#3);`.
struct StepRecord {
  std::string type{};  ///< In capital letters.
  std::vector<StepValue> arguments{};
  std::uint32_t line = 0;

  /// An argument; an absent one where there are fewer.
  [[nodiscard]] const StepValue& operator[](std::size_t index) const noexcept;
};

/// The records of a STEP file by their numbers.
struct StepFile {
  std::string schema{};  ///< `IFC2X3`; empty where the header names none.
  std::unordered_map<std::uint64_t, StepRecord> records{};
  std::unordered_map<std::string, std::vector<std::uint64_t>> by_type{};  ///< In order of number.

  /// The record that a value refers to; an empty one where there is none.
  [[nodiscard]] const StepRecord& at(const StepValue& value) const noexcept;
  [[nodiscard]] const StepRecord& at(std::uint64_t number) const noexcept;
  [[nodiscard]] const std::vector<std::uint64_t>& all(const std::string& type) const noexcept;
};

/// Reads a whole file. Throws ContentError with its line for what is no STEP file, is cut short, or
/// nests deeper than 64 lists.
StepFile parse_step(const std::string& file, std::string_view bytes);

/// The text of a STEP string between its quotes: `\X2\00FC\X0\` is ü, `''` a quote.
std::string decoded_step_text(std::string_view text);

}  // namespace docent::import
