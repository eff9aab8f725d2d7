#include "content/import/drawing/dxf_text.h"

#include <algorithm>
#include <charconv>
#include <cstdint>

namespace docent::import {
namespace {

void append_utf8(std::string& out, std::uint32_t code) {
  if (code < 0x20 || (code >= 0xd800 && code < 0xe000)) return;
  if (code < 0x80) {
    out += static_cast<char>(code);
  } else if (code < 0x800) {
    out += static_cast<char>(0xc0 | (code >> 6));
    out += static_cast<char>(0x80 | (code & 0x3f));
  } else {
    out += static_cast<char>(0xe0 | (code >> 12));
    out += static_cast<char>(0x80 | ((code >> 6) & 0x3f));
    out += static_cast<char>(0x80 | (code & 0x3f));
  }
}

/// `\U+00e9` at the front of `text`: its letter is appended and it is taken away.
bool take_letter(std::string_view& text, std::string& out) {
  if (text.size() < 7 || !(text.starts_with("\\U+") || text.starts_with("\\u+"))) return false;
  std::uint32_t code = 0;
  const auto [end, error] = std::from_chars(text.data() + 3, text.data() + 7, code, 16);
  if (error != std::errc{} || end != text.data() + 7) return false;
  append_utf8(out, code);
  text.remove_prefix(7);
  return true;
}

/// `%%d`, `%%c`, `%%p`, `%%u` at the front.
bool take_percent(std::string_view& text, std::string& out) {
  if (text.size() < 3 || !text.starts_with("%%")) return false;
  switch (text[2]) {
    case 'd':
    case 'D':
      out += "°";
      break;
    case 'c':
    case 'C':
      out += "⌀";
      break;
    case 'p':
    case 'P':
      out += "±";
      break;
    case '%':
      out += '%';
      break;
    default:
      break;  // Underlines and the like.
  }
  text.remove_prefix(3);
  return true;
}

/// A code of MTEXT behind its backslash.
void take_code(std::string_view& text, std::string& out) {
  const char code = text.front();
  text.remove_prefix(1);
  switch (code) {
    case 'P':
    case 'X':
    case 'N':
      out += '\n';
      return;
    case '~':
      out += ' ';
      return;
    case '\\':
    case '{':
    case '}':
      out += code;
      return;
    case 'L':
    case 'l':
    case 'O':
    case 'o':
    case 'K':
    case 'k':
      return;
    default:
      break;
  }
  const std::size_t end = std::min(text.find(';'), text.size());
  if (code == 'S')  // A fraction: 1#2, 1/2, or 2^ for a raised 2.
    for (const char c : text.substr(0, end))
      if (c != '^') out += c == '#' ? '/' : c;
  text.remove_prefix(std::min(end + 1, text.size()));
}

}  // namespace

std::string without_controls(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    if (take_letter(text, out) || take_percent(text, out)) continue;
    out += text.front();
    text.remove_prefix(1);
  }
  return out;
}

std::string without_formatting(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    if (take_letter(text, out) || take_percent(text, out)) continue;
    const char c = text.front();
    text.remove_prefix(1);
    if (c == '\\' && !text.empty())
      take_code(text, out);
    else if (c == '^' && !text.empty()) {  // A control character: ^I is a tabulator.
      out += text.front() == ' ' ? '^' : ' ';
      text.remove_prefix(1);
    } else if (c != '{' && c != '}')
      out += c;
  }
  return out;
}

TextExtent extent_of(std::string_view text) {
  TextExtent extent{0, 1};
  int column = 0;
  for (const char c : text) {
    if (c == '\n') {
      ++extent.lines;
      column = 0;
    } else if ((static_cast<unsigned char>(c) & 0xc0) != 0x80) {
      extent.columns = std::max(extent.columns, ++column);
    }
  }
  return extent;
}

}  // namespace docent::import
