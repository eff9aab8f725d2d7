#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace docent::import {

/// A JSON value that remembers where it begins, so that a mistake in it can be pointed at.
struct JsonValue {
  enum class Kind : std::uint8_t { Null, Boolean, Number, String, Array, Object };

  Kind kind = Kind::Null;
  std::size_t offset = 0;            ///< Byte in the text at which the value begins.
  double number = 0;                 ///< Of a Number.
  std::string string{};              ///< Of a String.
  std::vector<JsonValue> items{};    ///< Of an Array or an Object, in the order of the text.
  std::vector<std::string> names{};  ///< Of an Object: one per item.
};

/// The member of that name, the last where there are several; null where there is none.
const JsonValue* find_member(const JsonValue& object, std::string_view name) noexcept;

/// Line and column of a byte of a text, both from 1, columns in characters.
struct TextPosition {
  std::uint32_t line = 1, column = 1;
};

/// Answers where bytes stand, by binary search in the lines' beginnings. Borrows nothing.
class LineIndex {
 public:
  explicit LineIndex(std::string_view text);
  [[nodiscard]] TextPosition at(std::size_t offset) const noexcept;

 private:
  std::vector<std::size_t> line_start_;
  std::vector<std::size_t> continued_;  ///< Bytes that begin no character.
};

/// Parses one JSON text (RFC 8259). Throws ContentError with the place for text that is not JSON,
/// numbers that no double can hold, and nesting deeper than 64.
JsonValue parse_json(const std::string& file, std::string_view text);

}  // namespace docent::import
