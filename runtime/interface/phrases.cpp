#include "runtime/interface/phrases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "runtime/interface/control.h"

namespace docent::interface {
namespace {

/// The pieces of a UTF-8 text, one a character.
std::string_view character(std::string_view text, std::size_t index) noexcept {
  const auto is_first_byte = [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  };
  std::size_t begin = 0, seen = 0;
  for (; begin < text.size(); ++begin)
    if (is_first_byte(text[begin]) && seen++ == index) break;
  std::size_t end = std::min(begin + 1, text.size());
  while (end < text.size() && !is_first_byte(text[end])) ++end;
  return text.substr(begin, end - begin);
}

}  // namespace

std::string filled_in(std::string_view text, std::string_view name, std::string_view value) {
  const std::string hole = fmt::format("{{{}}}", name);
  std::string out(text);
  for (std::size_t at = out.find(hole); at != std::string::npos;
       at = out.find(hole, at + value.size()))
    out.replace(at, hole.size(), value);
  return out;
}

std::string number_in(const Museum& museum, std::uint32_t language, long number) {
  std::string_view digits = word(museum, language, "digits");
  if (digits == "digits") digits = "0123456789";
  std::string out;
  for (const char c : fmt::format("{}", number))
    if (c >= '0' && c <= '9')
      out += character(digits, static_cast<std::size_t>(c - '0'));
    else
      out += c;
  return out;
}

std::string distance_in(const Museum& museum, std::uint32_t language, double metres) {
  const long whole = std::max(1L, std::lround(metres));
  return filled_in(word(museum, language, "distance"), "n", number_in(museum, language, whole));
}

std::string time_in(const Museum& museum, std::uint32_t language, double seconds) {
  if (seconds < 15) return std::string(word(museum, language, "time_moment"));
  if (seconds < 40) return std::string(word(museum, language, "time_half"));
  const long minutes = std::max(1L, std::lround(seconds / 60));
  const std::string_view key = minutes == 1    ? "time_one"
                               : minutes == 2  ? "time_two"
                               : minutes <= 10 ? "time_few"
                                               : "time_many";
  return filled_in(word(museum, language, key), "n", number_in(museum, language, minutes));
}

}  // namespace docent::interface
