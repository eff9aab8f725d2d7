#include "content/write/toml_edit.h"

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

namespace docent::write {

namespace {

std::optional<std::size_t> start_of_line(std::string_view text, std::uint32_t line) {
  std::size_t at = 0;
  for (std::uint32_t i = 1; i < line; ++i) {
    at = text.find('\n', at);
    if (at == std::string_view::npos) return {};
    ++at;
  }
  return at;
}

bool is_continuation(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

/// The byte of a line's character, where it is a quotation mark.
std::optional<std::size_t> value_at(std::string_view text, std::uint32_t line,
                                    std::uint32_t column) {
  const auto start = start_of_line(text, line);
  if (!start) return {};
  std::size_t at = *start;
  if (line == 1 && text.starts_with("\xEF\xBB\xBF")) at += 3;
  for (std::uint32_t i = 1; i < column && at < text.size(); ++i) do
      ++at;
    while (at < text.size() && is_continuation(text[at]));
  if (at >= text.size() || (text[at] != '"' && text[at] != '\'')) return {};
  return at;
}

/// The byte behind a text value that begins at a quotation mark.
std::size_t end_of_value(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const std::string three(3, quote);
  const bool is_long = text.substr(at).starts_with(three);
  for (std::size_t i = at + (is_long ? 3 : 1); i < text.size(); ++i) {
    if (quote == '"' && text[i] == '\\') {
      ++i;
    } else if (is_long ? text.substr(i).starts_with(three) : text[i] == quote) {
      std::size_t end = i + (is_long ? 3 : 1);
      while (is_long && end < text.size() && text[end] == quote && end < i + 5) ++end;
      return end;
    }
  }
  return text.size();
}

}  // namespace

std::string toml_text(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\')
      out += std::string("\\") + c;
    else if (c == '\n')
      out += "\\n";
    else if (c == '\t')
      out += "\\t";
    else if (byte < 0x20 || byte == 0x7F)
      out += fmt::format("\\u{:04X}", byte);
    else
      out += c;
  }
  return out + '"';
}

std::string edited(std::string_view toml, std::vector<TomlEdit> edits) {
  std::vector<std::pair<std::size_t, TomlEdit>> placed;
  for (TomlEdit& edit : edits)
    if (const auto at = value_at(toml, edit.line, edit.column))
      placed.emplace_back(*at, std::move(edit));
  std::ranges::stable_sort(placed, std::greater<>(), [](const auto& each) { return each.first; });
  std::string text(toml);
  for (const auto& [at, edit] : placed) {
    const std::size_t end = end_of_value(text, at);
    if (edit.kind == TomlEdit::Kind::Replace) {
      text.replace(at, end - at, edit.with);
      continue;
    }
    const std::size_t line_end = std::min(text.find('\n', end), text.size());
    const bool windows = line_end > 0 && line_end < text.size() && text[line_end - 1] == '\r';
    if (line_end == text.size())
      text += "\n" + edit.with + "\n";
    else
      text.insert(line_end + 1, edit.with + (windows ? "\r\n" : "\n"));
  }
  return text;
}

std::string key_before(std::string_view toml, std::uint32_t line, std::uint32_t column) {
  const auto at = value_at(toml, line, column);
  if (!at) return {};
  std::string_view before =
      toml.substr(*start_of_line(toml, line), *at - *start_of_line(toml, line));
  if (before.starts_with("\xEF\xBB\xBF")) before.remove_prefix(3);
  const std::size_t equals = before.find('=');
  if (equals == std::string_view::npos || before.find_first_of("{[,") != std::string_view::npos)
    return {};
  before = before.substr(0, equals);
  while (before.ends_with(' ') || before.ends_with('\t')) before.remove_suffix(1);
  return std::string(before);
}

}  // namespace docent::write
