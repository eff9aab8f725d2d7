#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace docent::test {

/// What a reader of a language understands by left, right, ahead and behind, by numbers and by
/// what things are called. Written down here once more, so a word in the wrong line of a language's
/// file is found. Words as they stand within a sentence; ways to say one thing are parted by "|".
struct Reader {
  std::string_view tag;
  std::array<std::string_view, 6> side;   ///< A door: in the order of directions::Side.
  std::array<std::string_view, 6> nth;    ///< The first to the sixth door.
  std::array<std::string_view, 5> where;  ///< A thing: in the order of directions::Where.
  std::string_view on_wall, in_case;
  std::array<std::string_view, 4> ride;  ///< In the order of ConnectionKind.
  std::string_view up, down, then, free_of_steps;
  std::string_view open_quote, close_quote;
  std::string_view stop;  ///< Ends a sentence; empty where a blank does.
  std::string_view digits;
  /// What must never stand beside a name, since it hangs on how the name begins or ends: {room}
  /// stands for any name.
  std::vector<std::string_view> never;
  std::string (*minutes)(const std::string& digits, long number);
  std::string (*metres)(const std::string& digits, long number);
};

const Reader& reader_of(std::string_view language);

/// The number, in the digits of the reader's language.
std::string written(const Reader& reader, long number);
/// The number that a text begins with.
long number_in(const Reader& reader, std::string_view text);
std::vector<std::string> names_in(const Reader& reader, std::string_view text);
std::string without_names(const Reader& reader, std::string_view text);
/// The text with its first letter small, as it would be within a sentence.
std::string within_a_sentence(std::string text);
/// A letter that has a capital, and is none.
bool begins_small(std::string_view text);
/// Which of several things a text says first; the longer where two begin together. `said.size()`:
/// none.
template <std::size_t count>
std::size_t said_first(const std::array<std::string_view, count>& said, std::string_view text);
/// Where one of the ways to say a thing begins, and how long it is; npos: not said.
struct Found {
  std::size_t at = std::string_view::npos, size = 0;
};
Found find_said(std::string_view ways_to_say, std::string_view text);

template <std::size_t count>
std::size_t said_first(const std::array<std::string_view, count>& said, std::string_view text) {
  std::size_t first = count;
  Found best;
  for (std::size_t i = 0; i < count; ++i) {
    const Found found = find_said(said[i], text);
    if (found.at == std::string_view::npos) continue;
    if (found.at < best.at || (found.at == best.at && found.size > best.size)) {
      best = found;
      first = i;
    }
  }
  return first;
}

}  // namespace docent::test
