#include "runtime/interface/pages.h"

#include <cmath>

namespace docent::interface {
namespace {

bool begins_letter(char c) noexcept {
  return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
}

/// Where a text may be broken: words with what follows them, and a few signs at a time where it
/// has no spaces.
std::vector<std::string_view> parts_of(std::string_view text) {
  constexpr std::size_t longest = 16;  // letters
  std::vector<std::string_view> parts;
  std::size_t first = 0, letters = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!begins_letter(text[i])) continue;
    if (i > first && (text[i - 1] == ' ' || text[i - 1] == '\n' || letters >= longest)) {
      parts.push_back(text.substr(first, i - first));
      first = i;
      letters = 0;
    }
    ++letters;
  }
  if (first < text.size()) parts.push_back(text.substr(first));
  return parts;
}

}  // namespace

std::vector<std::string_view> pages_of(Sheet& sheet, const TextStyle& style, std::string_view text,
                                       float width, float most_lines) {
  const float most = most_lines * std::round(style.size * style.line_height) + 1;
  std::vector<std::string_view> pages;
  std::size_t first = 0, end = 0;
  for (const std::string_view part : parts_of(text)) {
    const std::size_t next = end + part.size();
    if (end > first && sheet.height_of(style, text.substr(first, next - first), width) > most) {
      pages.push_back(text.substr(first, end - first));
      first = end;
    }
    end = next;
  }
  if (end > first) pages.push_back(text.substr(first, end - first));
  return pages;
}

}  // namespace docent::interface
