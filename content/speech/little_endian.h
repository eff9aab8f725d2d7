#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace docent::speech {

/// The unsigned number in `count` bytes at a place, at most eight; the bytes are there.
inline std::uint64_t little_endian(std::string_view bytes, std::size_t at, std::size_t count) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < count; ++i)
    value |= std::uint64_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
  return value;
}

}  // namespace docent::speech
