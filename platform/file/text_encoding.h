#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace docent::file {

/// Why the bytes of a file are not the text that we read, which is UTF-8, with or without a byte
/// order mark.
struct EncodingFault {
  std::uint32_t line = 0, column = 0;  ///< From 1, in characters; 0 where it is the whole file.
  std::string message;                 ///< A sentence without its subject: "is UTF-16, ...".
  std::string hint;                    ///< What to do about it.
};

/// Finds text of two or four bytes a character, as some editors and spreadsheets save it: UTF-16 or
/// UTF-32 of either byte order, known by its mark or by where its zero bytes stand.
std::optional<EncodingFault> wide_encoding(std::string_view bytes);

/// Finds what else is not UTF-8, too, such as the letters of Latin-1: the first place.
std::optional<EncodingFault> encoding_fault(std::string_view bytes);

/// The text with the replacement character, U+FFFD, for each byte that is not UTF-8: to be shown.
std::string shown_as_utf8(std::string_view bytes);

/// The text behind the byte order mark of UTF-8, which some editors put before it.
std::string_view without_byte_order_mark(std::string_view text) noexcept;

}  // namespace docent::file
