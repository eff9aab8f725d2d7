#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace docent::test {

enum class ByteOrder : std::uint8_t { Little, Big };

/// A text as UTF-16 (`unit` 2) or UTF-32 (`unit` 4). Characters of the basic plane only; a byte
/// order mark is the first of them, where one is wanted.
inline std::string wide(std::u32string_view text, std::size_t unit, ByteOrder order) {
  std::string bytes;
  for (const char32_t character : text)
    for (std::size_t i = 0; i < unit; ++i) {
      const std::size_t shift = 8 * (order == ByteOrder::Little ? i : unit - 1 - i);
      bytes += static_cast<char>(static_cast<unsigned char>((character >> shift) & 0xFFU));
    }
  return bytes;
}

}  // namespace docent::test
