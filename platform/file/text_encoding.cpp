#include "platform/file/text_encoding.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace docent::file {
namespace {

using namespace std::string_view_literals;

constexpr const char* save_as_utf8 =
    "save the file again as UTF-8: in Notepad, Save as, Encoding; in Excel, CSV UTF-8; in other "
    "editors it is the encoding";
constexpr std::string_view utf8_mark = "\xEF\xBB\xBF";

/// A form of Unicode that we do not read.
struct WideForm {
  std::string_view name;
  std::string_view mark;
  std::size_t unit;  ///< Bytes of a character (UTF-16: of most).
  std::size_t high;  ///< Which byte of a unit is zero in every letter of English.
};
// The mark of UTF-32 begins as that of UTF-16 does, so it is looked for first.
constexpr std::array<WideForm, 4> wide_forms{{
    {"UTF-32 (little endian)", "\xFF\xFE\0\0"sv, 4, 3},
    {"UTF-32 (big endian)", "\0\0\xFE\xFF"sv, 4, 0},
    {"UTF-16 (little endian)", "\xFF\xFE"sv, 2, 1},
    {"UTF-16 (big endian)", "\xFE\xFF"sv, 2, 0},
}};

unsigned char_at(std::string_view bytes, std::size_t i) {
  return static_cast<unsigned char>(bytes[i]);
}

/// Of UTF-32, the highest byte of each character is zero, and the next at most 16.
bool has_zeros_of_utf32(std::string_view bytes, std::size_t high) {
  const std::size_t next = high == 0 ? 1 : 2;
  for (std::size_t i = 0; i < bytes.size(); i += 4)
    if (char_at(bytes, i + high) != 0 || char_at(bytes, i + next) > 0x10) return false;
  return true;
}

/// Of UTF-16, line ends, digits and brackets have a zero byte even where every word is Chinese, and
/// every file that we read begins with one of these; the other byte is zero in few letters of any
/// language, and both are in none.
bool has_zeros_of_utf16(std::string_view bytes, std::size_t high) {
  std::size_t zeros = 0, others = 0;
  for (std::size_t i = 0; i < bytes.size(); i += 2) {
    const bool is_zero = char_at(bytes, i + high) == 0,
               is_other = char_at(bytes, i + 1 - high) == 0;
    if (is_zero && is_other) return false;
    zeros += is_zero ? 1 : 0;
    others += is_other ? 1 : 0;
  }
  return char_at(bytes, high) == 0 && zeros > bytes.size() / 32 && 16 * others <= zeros;
}

/// Is this the form, to judge by zero bytes?
bool has_zeros_of(const WideForm& form, std::string_view bytes) {
  constexpr std::size_t enough = 4096;
  bytes = bytes.substr(0, std::min(bytes.size() - bytes.size() % form.unit, enough));
  if (bytes.empty()) return false;
  return form.unit == 4 ? has_zeros_of_utf32(bytes, form.high)
                        : has_zeros_of_utf16(bytes, form.high);
}

/// How many bytes the first character of a text has (The Unicode Standard, table 3-7); 0 where they
/// are none of UTF-8.
std::size_t first_character(std::string_view text) {
  const auto byte = [text](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
  };
  const auto continues = [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i)
      if (byte(i) < 0x80 || byte(i) > 0xBF) return false;
    return true;
  };
  const unsigned first = byte(0), second = byte(1);
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first <= 0xDF) return continues(1, 2) ? 2 : 0;
  if (first >= 0xE0 && first <= 0xEF) {
    const bool too_long = first == 0xE0 && second < 0xA0,
               surrogate = first == 0xED && second > 0x9F;
    return continues(1, 3) && !too_long && !surrogate ? 3 : 0;
  }
  if (first >= 0xF0 && first <= 0xF4) {
    const bool too_long = first == 0xF0 && second < 0x90, too_far = first == 0xF4 && second > 0x8F;
    return continues(1, 4) && !too_long && !too_far ? 4 : 0;
  }
  return 0;
}

/// What the bytes 0x80 to 0x9F are in Windows-1252; empty where it has none.
constexpr std::array<std::string_view, 32> windows_1252{
    "€", "",  "‚", "ƒ", "„", "…", "†", "‡", "ˆ", "‰", "Š", "‹", "Œ", "", "Ž", "",
    "",  "‘", "’", "“", "”", "•", "–", "—", "˜", "™", "š", "›", "œ", "", "ž", "Ÿ"};

/// What they are on old Macs, where they are letters; empty where they are none.
constexpr std::array<std::string_view, 32> mac_roman{
    "Ä", "Å", "Ç", "É", "Ñ", "Ö", "Ü", "á", "à", "â", "ä", "ã", "å", "ç", "é", "è",
    "ê", "ë", "í", "ì", "î", "ï", "ñ", "ó", "ò", "ô", "ö", "õ", "ú", "ù", "û", "ü"};

/// Those of Windows-1252 that words hold; the others are quotation marks and the like.
bool is_letter_of_1252(unsigned char byte) {
  constexpr std::string_view letters = "\x8A\x8C\x8E\x9A\x9C\x9E\x9F";
  return letters.find(static_cast<char>(byte)) != std::string_view::npos;
}

bool is_quote_of_1252(unsigned char byte) {
  return (byte >= 0x91 && byte <= 0x97) || byte == 0x80 || byte == 0x84 || byte == 0x85;
}

/// How many bytes in a row are no ASCII.
std::size_t run_of_high_bytes(std::string_view text) {
  const auto end = std::ranges::find_if(
      text, [](char c) { return (static_cast<unsigned char>(c) & 0x80U) == 0; });
  return static_cast<std::size_t>(end - text.begin());
}

/// What bytes that are no UTF-8 may be; `rest` begins with the first of them.
std::string sentence_about(std::string_view rest) {
  const auto byte = static_cast<unsigned char>(rest.front());
  constexpr std::size_t word = 4;  // letters of one word: European languages have few in a row
  if (run_of_high_bytes(rest) >= word && !is_quote_of_1252(byte))
    return "is not UTF-8 but in an older encoding of another script, such as Windows-1256 "
           "(Arabic), "
           "GBK or Big5 (Chinese), Shift JIS (Japanese) or Windows-1251 (Cyrillic)";
  const std::array<char, 2> letter{static_cast<char>(0xC0U | (byte >> 6U)),
                                   static_cast<char>(0x80U | (byte & 0x3FU))};
  const std::string_view meant =
      byte < 0xA0 ? windows_1252[byte - 0x80U] : std::string_view(letter.data(), letter.size());
  if (byte < 0xA0 && !is_quote_of_1252(byte)) {
    const std::string_view on_macs = mac_roman[byte - 0x80U];
    if (!is_letter_of_1252(byte))
      return fmt::format(
          "is not UTF-8 but, it seems, Mac OS Roman: the byte 0x{:02X} here is '{}' in it", byte,
          on_macs);
    return fmt::format(
        "is not UTF-8 but, it seems, Windows-1252 or Mac OS Roman: the byte 0x{:02X} here is '{}' "
        "or '{}' in it",
        byte, meant, on_macs);
  }
  return fmt::format("is not UTF-8 but, it seems, {}: the byte 0x{:02X} here is '{}' in it",
                     byte < 0xA0 ? "Windows-1252" : "Windows-1252 (or Latin-1)", byte, meant);
}

}  // namespace

std::optional<EncodingFault> wide_encoding(std::string_view bytes) {
  const auto is_meant = [bytes](const WideForm& form) { return bytes.starts_with(form.mark); };
  const auto looks_so = [bytes](const WideForm& form) { return has_zeros_of(form, bytes); };
  auto form = std::ranges::find_if(wide_forms, is_meant);
  if (form == wide_forms.end()) form = std::ranges::find_if(wide_forms, looks_so);
  if (form == wide_forms.end()) return std::nullopt;
  return EncodingFault{.line = 1,
                       .column = 1,
                       .message = fmt::format("is {}, and only UTF-8 is read", form->name),
                       .hint = save_as_utf8};
}

std::optional<EncodingFault> encoding_fault(std::string_view bytes) {
  if (auto wide = wide_encoding(bytes)) return wide;
  std::string_view rest = without_byte_order_mark(bytes);
  for (std::uint32_t line = 1, column = 1; !rest.empty(); ++column) {
    const std::size_t size = first_character(rest);
    if (rest.front() == '\0')
      return EncodingFault{.line = line,
                           .column = column,
                           .message = "is not a text: it holds zero bytes",
                           .hint = "is this the right file?"};
    if (size == 0)
      return EncodingFault{
          .line = line, .column = column, .message = sentence_about(rest), .hint = save_as_utf8};
    if (rest.front() == '\n') ++line, column = 0;
    rest.remove_prefix(size);
  }
  return std::nullopt;
}

std::string shown_as_utf8(std::string_view bytes) {
  std::string shown;
  while (!bytes.empty()) {
    const std::size_t size = first_character(bytes);
    shown += size > 0 ? bytes.substr(0, size) : "\uFFFD";
    bytes.remove_prefix(std::max<std::size_t>(size, 1));
  }
  return shown;
}

std::string_view without_byte_order_mark(std::string_view text) noexcept {
  if (text.starts_with(utf8_mark)) text.remove_prefix(utf8_mark.size());
  return text;
}

}  // namespace docent::file
