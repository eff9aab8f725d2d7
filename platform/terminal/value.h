#pragma once

#include <array>
#include <cstdint>
#include <expected>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

/// What an option takes from the command line, and where it goes. A target has to live until the
/// line has been read; it keeps its value where the option is not given.
namespace docent::terminal {

using Words = std::span<const std::string>;

/// What a shell offers in the place of a value.
enum class Offers : std::uint8_t { Nothing, Files, Folders };

struct Value {
  std::string name{};  ///< As help calls it: FILE, X,Y. A flag has none.
  /// Stores the words that were given, at least one; returns a sentence where it cannot, else
  /// nothing. A flag's words are "true" and "false".
  std::function<std::string(Words)> take{};
  std::vector<std::string_view> choices{};  ///< The only words that may be given; empty: any.
  Offers offers = Offers::Nothing;
};

/// The range that a number has to lie in.
struct Limits {
  enum class Of : std::uint8_t { Numbers, WholeNumbers } of = Of::Numbers;
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  enum class Least : std::uint8_t { Included, Excluded } ends = Least::Included;
};
inline constexpr Limits not_negative{.least = 0};
inline constexpr Limits positive{.least = 0, .ends = Limits::Least::Excluded};

/// The parts of a text between separators; at least one.
std::vector<std::string_view> split(std::string_view text, char separator);

/// Reads a number of plain digits; nothing where the text is none, or not finite. Never a negative
/// zero.
std::optional<double> finite_number(std::string_view text) noexcept;

/// Reads a number; gives a sentence where the word is none or lies outside.
std::expected<double, std::string> read_number(std::string_view word, const Limits& limits);
/// Reads numbers; returns a sentence about the first that is none or lies outside.
std::string read_numbers(Words words, Limits limits, std::vector<double>& numbers);
/// Reads as many numbers as `numbers` holds, with commas between; returns a sentence where the word
/// is anything else.
std::string read_list(const std::string& word, std::span<double> numbers);
/// Where a word is among the choices; else a sentence.
std::expected<std::size_t, std::string> find_choice(std::string_view word,
                                                    std::span<const std::string_view> choices);

/// The last of what was given, or all of it where the target holds many.
template <typename Given, typename Target>
void put(const Given& given, Target& target) {
  using Item = typename Given::value_type;
  if constexpr (std::is_same_v<Target, std::vector<std::remove_const_t<Item>>>)
    target.assign(given.begin(), given.end());
  else if constexpr (std::is_arithmetic_v<Target>)
    target = static_cast<Target>(*std::prev(given.end()));
  else
    target = *std::prev(given.end());
}

inline Value flag(bool& target) {
  return {.take = [&target](Words words) {
    target = words.back() == "true";
    return std::string();
  }};
}

/// Any text. The target is a string, a path, an optional of these, or a vector of strings.
template <typename Target>
Value text(std::string_view name, Target& target, Offers offers = Offers::Nothing) {
  return {.name = std::string(name),
          .take =
              [&target](Words words) {
                put(words, target);
                return std::string();
              },
          .offers = offers};
}
template <typename Target>
Value file(std::string_view name, Target& target) {
  return text(name, target, Offers::Files);
}
template <typename Target>
Value folder(std::string_view name, Target& target) {
  return text(name, target, Offers::Folders);
}

/// Texts with commas between.
Value list(std::string_view name, std::vector<std::string>& target);

/// A number within limits. The target is of an arithmetic type, an optional of one, or a vector of
/// doubles.
template <typename Target>
Value number(std::string_view name, Limits limits, Target& target) {
  return {.name = std::string(name), .take = [limits, &target](Words words) {
            std::vector<double> numbers;
            std::string wrong = read_numbers(words, limits, numbers);
            if (wrong.empty()) put(numbers, target);
            return wrong;
          }};
}

/// `n` numbers with commas between, such as X,Y.
template <std::size_t n>
Value numbers(std::string_view name, std::optional<std::array<double, n>>& target) {
  return {.name = std::string(name), .take = [&target](Words words) {
            std::array<double, n> read{};
            std::string wrong = read_list(words.back(), read);
            if (wrong.empty()) target = read;
            return wrong;
          }};
}

/// One of a few words, each of which stands for a value.
template <typename T, typename Target>
Value one_of(std::vector<std::pair<std::string_view, T>> choices, Target& target) {
  Value value;
  for (const auto& [word, meant] : choices) {
    value.name.append(value.name.empty() ? "" : "|").append(word);
    value.choices.push_back(word);
  }
  value.take = [choices = std::move(choices), known = value.choices, &target](Words words) {
    const auto found = find_choice(words.back(), known);
    if (!found) return found.error();
    target = choices[*found].second;
    return std::string();
  };
  return value;
}

}  // namespace docent::terminal
