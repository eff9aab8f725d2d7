#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "runtime/model/hours/opening_hours.h"
#include "runtime/model/museum.h"

namespace docent::interface {

/// The most bytes of a line that for_each_line() gives: who sets or says one works on all of it.
inline constexpr std::size_t longest_line = 1000;

/// How many bytes of a line (UTF-8) make its first part: all of a short one, else up to the end of
/// a sentence; up to a blank where none ends in time, and to the end of any letter where there is
/// no blank either. 0 for an empty line alone.
std::size_t end_of_part(std::string_view line) noexcept;

/// Calls `take` with each line of a text that holds anything; with a long one part by part, without
/// the blanks between them.
template <typename Take>
void for_each_line(std::string_view text, const Take& take) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    for (std::string_view line = text.substr(0, end); !line.empty();) {
      const std::size_t part = end_of_part(line);
      take(line.substr(0, part));
      line.remove_prefix(std::min(line.find_first_not_of(' ', part), line.size()));
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

/// `text` with every "{name}" replaced by `value`.
std::string filled_in(std::string_view text, std::string_view name, std::string_view value);

/// A whole number in the digits of a language.
std::string number_in(const Museum& museum, std::uint32_t language, long number);

/// Whose digits a number is written in: those of the language, or 0 to 9, as speech is made of.
enum class Digits : std::uint8_t { Own, Plain };

/// "42 m" in a language: whole metres, at least 1.
std::string distance_in(const Museum& museum, std::uint32_t language, double metres);

/// The word that says so many minutes: "time_one" and "time_two" for those numbers alone, "time_21"
/// where a larger one takes the form of one, "time_few" and "time_many" for what the language
/// distinguishes beyond (plural.h).
std::string_view time_word(std::string_view tag, long minutes) noexcept;
/// "about a minute": rounded so that nobody waits longer than promised.
std::string time_in(const Museum& museum, std::uint32_t language, double seconds,
                    Digits digits = Digits::Own);

/// "30 minutes": so many exactly, as a visitor has them.
std::string minutes_in(const Museum& museum, std::uint32_t language, long minutes,
                       Digits digits = Digits::Own);
/// What a tour is called.
std::string title_in(const Museum& museum, std::uint32_t language, const Tour& tour,
                     Digits digits = Digits::Own);

/// "5 p.m.", "tomorrow, 10 a.m.", "Friday, 10 a.m.": a moment to come, as short as it can be said
/// today; by its date, "3 December", where that is a week off, or nobody knows what day it is.
std::string moment_in(const Museum& museum, std::uint32_t language, LocalMinute moment,
                      std::optional<std::chrono::local_days> today);

}  // namespace docent::interface
