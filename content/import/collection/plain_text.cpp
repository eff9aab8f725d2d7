#include "content/import/collection/plain_text.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>

#include "content/import/collection/utf8.h"

namespace docent::import {

namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 34> entities{{
    {"amp", "&"},    {"lt", "<"},     {"gt", ">"},     {"quot", "\""},  {"apos", "'"},
    {"nbsp", " "},   {"ndash", "–"},  {"mdash", "—"},  {"lsquo", "‘"},  {"rsquo", "’"},
    {"ldquo", "“"},  {"rdquo", "”"},  {"hellip", "…"}, {"copy", "©"},   {"eacute", "é"},
    {"egrave", "è"}, {"agrave", "à"}, {"ccedil", "ç"}, {"uuml", "ü"},   {"ouml", "ö"},
    {"auml", "ä"},   {"szlig", "ß"},  {"Uuml", "Ü"},   {"Ouml", "Ö"},   {"Auml", "Ä"},
    {"ntilde", "ñ"}, {"oacute", "ó"}, {"aacute", "á"}, {"iacute", "í"}, {"deg", "°"},
    {"times", "×"},  {"frac12", "½"}, {"euro", "€"},   {"laquo", "«"},
}};

char small(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

void append_letter(std::string& out, std::uint32_t code) {
  if (code == 0 || code > 0x10FFFF || (code >= 0xD800 && code < 0xE000)) return;
  append_utf8(out, code);
}

/// The number of "#233" or "#xE9".
std::optional<std::uint32_t> number_of(std::string_view name) {
  name.remove_prefix(1);
  const bool hexadecimal = name.starts_with('x') || name.starts_with('X');
  if (hexadecimal) name.remove_prefix(1);
  if (name.empty() || name.size() > 7) return {};
  std::uint32_t value = 0;
  for (const char c : name) {
    const char s = small(c);
    const bool is_digit = s >= '0' && s <= '9', is_high = s >= 'a' && s <= 'f';
    if (!is_digit && !(hexadecimal && is_high)) return {};
    value = value * (hexadecimal ? 16 : 10) +
            static_cast<std::uint32_t>(is_digit ? s - '0' : s - 'a' + 10);
  }
  return value;
}

/// Reads an entity at the beginning of a text; returns how many bytes it took, 0 where it is none.
std::size_t take_entity(std::string_view text, std::string& out) {
  const std::size_t end = text.substr(0, 12).find(';');
  if (end == std::string_view::npos || end < 2) return 0;
  const std::string_view name = text.substr(1, end - 1);
  if (name.front() == '#') {
    const auto number = number_of(name);
    if (!number) return 0;
    append_letter(out, *number);
    return end + 1;
  }
  for (const auto& [known, letter] : entities)
    if (known == name) {
      out += letter;
      return end + 1;
    }
  return 0;
}

std::string name_of_tag(std::string_view tag) {
  std::string name;
  for (const char c : tag) {
    if (c == '/' && name.empty()) {
      name += '/';
      continue;
    }
    const char s = small(c);
    if (!(s >= 'a' && s <= 'z') && !(s >= '0' && s <= '9')) break;
    name += s;
  }
  return name;
}

bool ends_a_line(std::string_view name) {
  constexpr std::array<std::string_view, 8> names{"br",  "/p",  "/div", "/li",
                                                  "/h1", "/h2", "/h3",  "/tr"};
  return std::ranges::find(names, name) != names.end();
}

std::size_t find_small(std::string_view text, std::string_view word, std::size_t from) {
  const auto found = std::search(
      text.begin() + static_cast<std::ptrdiff_t>(std::min(from, text.size())), text.end(),
      word.begin(), word.end(), [](char a, char b) { return small(a) == b; });
  return found == text.end() ? std::string_view::npos
                             : static_cast<std::size_t>(found - text.begin());
}

/// Reads a tag at a place that holds `<`; returns where the text goes on, the same place where it
/// is none.
std::size_t skip_tag(std::string_view html, std::size_t at, std::string& out) {
  if (html.substr(at).starts_with("<!--")) {
    const std::size_t end = html.find("-->", at);
    return end == std::string_view::npos ? html.size() : end + 3;
  }
  const std::string name = name_of_tag(html.substr(at + 1));
  const std::size_t end = html.find('>', at);
  if (name.empty() || name == "/" || end == std::string_view::npos) return at;
  if (ends_a_line(name) && !out.empty()) out += '\n';
  if (name != "script" && name != "style") return end + 1;
  const std::size_t closing = find_small(html, "</" + name, end);
  const std::size_t after =
      closing == std::string_view::npos ? std::string_view::npos : html.find('>', closing);
  return after == std::string_view::npos ? html.size() : after + 1;
}

}  // namespace

namespace {

/// Line ends in a row, with the blanks between them, are one.
std::string with_single_line_ends(std::string_view text) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find_first_not_of(" \t\r\n", at), text.size());
    const std::string_view blanks = text.substr(at, end - at);
    if (blanks.find('\n') != std::string_view::npos)
      out += '\n';
    else
      out += blanks;
    const std::size_t next = std::min(text.find_first_of(" \t\r\n", end), text.size());
    out += text.substr(end, next - end);
    at = next;
  }
  return out;
}

}  // namespace

std::string plain_text(std::string_view html) {
  if (html.find_first_of("<&") == std::string_view::npos) return std::string(html);
  std::string out;
  for (std::size_t at = 0; at < html.size();) {
    if (html[at] == '<') {
      if (const std::size_t next = skip_tag(html, at, out); next != at) {
        at = next;
        continue;
      }
    } else if (html[at] == '&') {
      if (const std::size_t taken = take_entity(html.substr(at), out); taken > 0) {
        at += taken;
        continue;
      }
    }
    out += html[at++];
  }
  const std::size_t first = out.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) return {};
  return with_single_line_ends(
      std::string_view(out).substr(first, out.find_last_not_of(" \t\r\n") - first + 1));
}

}  // namespace docent::import
