#include "content/import/collection/decode_text.h"

#include <array>
#include <cstdint>

#include "content/import/collection/utf8.h"
#include "platform/file/text_encoding.h"

namespace docent::import {

namespace {

/// What the bytes 0x80 to 0x9F are in Windows-1252; the five that it leaves open are themselves.
constexpr std::array<std::uint16_t, 32> windows_1252{
    0x20AC, 0x81,   0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
    0x2039, 0x0152, 0x8D,   0x017D, 0x8F,   0x90,   0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
    0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0x9D,   0x017E, 0x0178};

std::string from_windows_1252(std::string_view bytes) {
  std::string text;
  text.reserve(bytes.size() + bytes.size() / 8);
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    append_utf8(text, byte >= 0x80 && byte < 0xA0 ? windows_1252[byte - 0x80U] : byte);
  }
  return text;
}

std::string from_utf16(std::string_view bytes, bool big) {
  std::string text;
  const auto unit = [&](std::size_t i) -> std::uint32_t {
    const auto low = static_cast<unsigned char>(bytes[i + (big ? 1U : 0U)]);
    const auto high = static_cast<unsigned char>(bytes[i + (big ? 0U : 1U)]);
    return static_cast<std::uint32_t>((high << 8U) | low);
  };
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    std::uint32_t letter = unit(i);
    if (letter >= 0xD800 && letter < 0xDC00 && i + 3 < bytes.size()) {
      const std::uint32_t low = unit(i + 2);
      if (low >= 0xDC00 && low < 0xE000) {
        letter = 0x10000 + ((letter - 0xD800) << 10U) + (low - 0xDC00);
        i += 2;
      }
    }
    append_utf8(text, letter >= 0xD800 && letter < 0xE000 ? 0xFFFD : letter);
  }
  return text;
}

std::string plain(std::string_view name) {
  std::string small;
  for (const char c : name)
    if (c != '-' && c != '_' && c != ' ')
      small += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return small;
}

}  // namespace

DecodedText decode_text(std::string_view bytes, std::string_view encoding) {
  const std::string asked = plain(encoding);
  const bool big = bytes.starts_with("\xFE\xFF"), little = bytes.starts_with("\xFF\xFE");
  if (big || little || asked.starts_with("utf16"))
    return {from_utf16(bytes.substr(big || little ? 2 : 0), big || asked == "utf16be"), "UTF-16"};
  const bool is_utf8 = !file::encoding_fault(bytes);
  const bool wants_1252 = asked == "windows1252" || asked == "cp1252" || asked == "latin1" ||
                          asked == "iso88591" || asked == "ansi";
  if (is_utf8 && !wants_1252) return {std::string(file::without_byte_order_mark(bytes)), "UTF-8"};
  if (asked == "utf8") return {file::shown_as_utf8(file::without_byte_order_mark(bytes)), "UTF-8"};
  return {from_windows_1252(bytes), "Windows-1252"};
}

}  // namespace docent::import
