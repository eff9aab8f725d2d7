#include "config/colour.h"

#include <fmt/format.h>

#include <charconv>
#include <vector>

#include "config/letters.h"

namespace docent::config {
namespace {

/// All of it, as a number.
std::optional<std::uint32_t> number(std::string_view text, int base) noexcept {
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  return error == std::errc{} && end == text.data() + text.size() && !text.empty()
             ? std::optional(value)
             : std::nullopt;
}

std::string_view trimmed(std::string_view text) noexcept {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

/// "rgb(210, 69, 45)" or "210, 69, 45"
std::optional<std::uint32_t> of_three_numbers(std::string_view text) noexcept {
  if (text.starts_with("rgb(") && text.ends_with(')')) text = text.substr(4, text.size() - 5);
  std::uint32_t colour = 0;
  for (int channel = 0; channel < 3; ++channel) {
    const std::size_t comma = text.find(',');
    if ((comma == std::string_view::npos) != (channel == 2)) return {};
    const auto value = number(trimmed(text.substr(0, comma)), 10);
    if (!value || *value > 0xFF) return {};
    colour = colour << 8U | *value;
    text.remove_prefix(comma == std::string_view::npos ? text.size() : comma + 1);
  }
  return colour;
}

}  // namespace

std::optional<std::uint32_t> parse_colour(std::string_view text) noexcept {
  constexpr std::size_t length = 7;
  return text.size() == length && text.front() == '#' ? number(text.substr(1), 16) : std::nullopt;
}

std::string colour_meant(std::string_view text) {
  constexpr std::size_t digits = 6, short_digits = 3;
  const std::string plain = in_small_letters(std::string(trimmed(text)));
  std::string hex = plain.substr(plain.starts_with('#') ? 1 : plain.starts_with("0x") ? 2 : 0);
  if (hex.size() == short_digits) hex = {hex[0], hex[0], hex[1], hex[1], hex[2], hex[2]};
  const auto colour = hex.size() == digits ? number(hex, 16) : of_three_numbers(plain);
  return colour ? fmt::format("#{:06X}", *colour) : std::string();
}

}  // namespace docent::config
