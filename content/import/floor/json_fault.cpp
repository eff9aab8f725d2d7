#include "content/import/floor/json_fault.h"

#include <fmt/core.h>

#include <algorithm>

namespace docent::import {

namespace {

constexpr std::string_view blanks = " \t\r\n";

/// How many brackets and braces are open at the end of a text, quotes left out of account.
std::size_t open_at_end(std::string_view text) {
  std::size_t open = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted && c == '\\')
      ++i;
    else if (c == '"')
      quoted = !quoted;
    else if (!quoted && (c == '[' || c == '{'))
      ++open;
    else if (!quoted && (c == ']' || c == '}') && open > 0)
      --open;
  }
  return open;
}

bool begins_value(char c) {
  return c == '"' || c == '{' || c == '[' || c == '-' || (c >= '0' && c <= '9');
}
bool ends_value(char c) {
  return c == '"' || c == '}' || c == ']' || (c >= '0' && c <= '9');
}
bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// The word that a place lies in, and where it begins.
std::pair<std::size_t, std::string_view> word_at(std::string_view text, std::size_t offset) {
  std::size_t first = offset, end = offset;
  while (first > 0 && is_letter(text[first - 1])) --first;
  while (end < text.size() && is_letter(text[end])) ++end;
  return {first, text.substr(first, std::min<std::size_t>(end - first, 30))};
}

/// Where the file begins with a heading such as [museum] or [[floor]]; npos where it does not.
std::size_t heading_of_toml(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos || text[first] != '[') return std::string_view::npos;
  const std::size_t name = first + (text.substr(first).starts_with("[[") ? 2 : 1);
  std::size_t end = name;
  while (end < text.size() && (is_letter(text[end]) || text[end] == '_')) ++end;
  const bool is_value = text.substr(name, end - name) == "true" ||
                        text.substr(name, end - name) == "false" ||
                        text.substr(name, end - name) == "null";
  return end > name && !is_value && end < text.size() && text[end] == ']' ? first
                                                                          : std::string_view::npos;
}

}  // namespace

JsonFault explain_json_fault(std::string_view text, std::size_t offset) {
  offset = std::min(offset, text.size());
  const std::size_t next = std::min(text.find_first_not_of(blanks, offset), text.size());
  const std::size_t before =
      offset == 0 ? std::string_view::npos : text.find_last_not_of(blanks, offset - 1);
  const char previous = before == std::string_view::npos ? '\0' : text[before];
  if (next == text.size()) {
    if (before == std::string_view::npos)
      return {0, "the file is empty", "draw the floor and save it as GeoJSON"};
    return {text.size(),
            fmt::format("the file ends too early: {} brackets are still open", open_at_end(text)),
            "it was cut short: save or copy it again"};
  }
  const char here = text[next];
  if (const std::size_t toml = heading_of_toml(text); toml != std::string_view::npos)
    return {toml, "this is TOML, and JSON belongs here",
            "name the plan's own file: floors/ground.geojson"};
  if (ends_value(previous) && open_at_end(text.substr(0, next)) == 0)
    return {next, "the file should end in front of this",
            "two things are in it, one behind the other: keep one"};
  if (previous == ',' && (here == ']' || here == '}'))
    return {before, "a comma stands before the closing bracket", "remove the comma"};
  if (text.substr(next).starts_with("\xE2\x80") || text.substr(next).starts_with("\xC2\xAB"))
    return {next, "this is a word processor's quotation mark",
            "write straight ones, \"like this\"; a plain text editor makes no others"};
  if (here == '\'')
    return {next, "a single quotation mark stands where double ones belong", "write \"like this\""};
  if (here == '/' || here == '#') return {next, "this is a remark, and JSON has none", "remove it"};
  if (begins_value(here) && ends_value(previous))
    return {next, "a comma is missing in front of this", "write one between two things"};
  if (is_letter(here) || is_letter(previous)) {
    const auto [first, word] = word_at(text, is_letter(here) ? next : before);
    const std::size_t behind = text.find_first_not_of(blanks, first + word.size());
    if (behind != std::string_view::npos && text[behind] == ':')
      return {first, fmt::format("'{}' is not in quotation marks", word),
              fmt::format("write \"{}\"", word)};
    for (const std::string_view value : {"true", "false", "null"})
      if (std::ranges::equal(word, value, [](char a, char b) { return (a | 0x20) == b; }))
        return {first, fmt::format("'{}' is no value of JSON", word),
                fmt::format("write {}", value)};
    return {first, fmt::format("'{}' is no value of JSON", word),
            "numbers are written in digits, texts in quotation marks"};
  }
  if (static_cast<unsigned char>(here) < 0x20 || here == '"')
    return {next, "a text is not closed in its line", "end it with a quotation mark"};
  if (static_cast<unsigned char>(here) >= 0x80)
    return {next, "a letter stands where none belongs",
            "delete it, or write it between quotation marks"};
  return {next, fmt::format("'{}' does not belong here", here),
          "delete it, or export the file again"};
}

}  // namespace docent::import
