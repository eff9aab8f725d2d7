#include "content/import/building/level_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

namespace docent::import {
namespace {

/// No building on Earth has more.
constexpr double highest = 300;

std::string_view without_ends(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

/// Takes a number from the front of a text.
std::optional<double> take_number(std::string_view& text) {
  text = without_ends(text);
  if (text.starts_with('+')) text.remove_prefix(1);
  double number = 0;
  const auto [end, fault] =
      std::from_chars(text.data(), text.data() + text.size(), number, std::chars_format::fixed);
  if (fault != std::errc{} || !std::isfinite(number) || std::abs(number) > highest) return {};
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  text = without_ends(text);
  return number + 0.0;  // no minus zero
}

std::optional<double> word_level(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, double>, 18> words{{{"ground", 0},
                                                                       {"ground floor", 0},
                                                                       {"g", 0},
                                                                       {"gf", 0},
                                                                       {"eg", 0},
                                                                       {"l", 0},
                                                                       {"lobby", 0},
                                                                       {"basement", -1},
                                                                       {"b", -1},
                                                                       {"b1", -1},
                                                                       {"b2", -2},
                                                                       {"ug", -1},
                                                                       {"first", 1},
                                                                       {"og", 1},
                                                                       {"second", 2},
                                                                       {"mezzanine", 0.5},
                                                                       {"rez-de-chaussee", 0},
                                                                       {"underground", -1}}};
  std::string lower(text);
  std::ranges::transform(lower, lower.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  const auto word = std::ranges::find(words, lower, &std::pair<std::string_view, double>::first);
  if (word == words.end()) return {};
  return word->second;
}

/// One level, or a range of them.
bool add_part(std::string_view part, std::vector<double>& levels) {
  part = without_ends(part);
  if (part.empty()) return true;
  std::string_view rest = part;
  const auto first = take_number(rest);
  if (!first) {
    const auto word = word_level(part);
    if (word) levels.push_back(*word);
    return word.has_value();
  }
  levels.push_back(*first);
  if (rest.empty()) return true;
  if (!rest.starts_with('-')) return false;
  rest.remove_prefix(1);
  const auto last = take_number(rest);
  if (!last || !rest.empty()) return false;
  const auto [low, high] = std::minmax(*first, *last);
  for (double level = low; level <= high; ++level) levels.push_back(level);
  levels.push_back(*last);
  return true;
}

}  // namespace

std::optional<std::vector<double>> parse_levels(std::string_view text) {
  std::vector<double> levels;
  while (true) {
    const std::size_t end = std::min(text.find_first_of(";,"), text.size());
    if (!add_part(text.substr(0, end), levels)) return {};
    if (end == text.size()) break;
    text.remove_prefix(end + 1);
  }
  std::ranges::sort(levels);
  levels.erase(std::ranges::unique(levels).begin(), levels.end());
  return levels;
}

std::string level_name(double ordinal) {
  return fmt::format("{:g}", ordinal);
}

}  // namespace docent::import
