#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace docent::video {

/// An element of an EBML document (RFC 8794): where its content lies.
struct Element {
  std::uint32_t id = 0;  ///< With its marker, as specifications write it.
  std::size_t begin = 0, end = 0;
  bool is_endless = false;  ///< Its size is unknown (section 6.2): `end` is that of what holds it.
};

/// A number of variable size (section 4), and how many bytes it takes: 1 to 8.
struct VariableNumber {
  std::uint64_t value = 0;  ///< Without its marker.
  std::size_t width = 0;
  bool is_unknown = false;  ///< All of its bits are ones.
};

/// That at the beginning of `bytes`; nothing where they end before it does.
std::optional<VariableNumber> read_variable_number(std::span<const std::byte> bytes) noexcept;

/// The element that begins at `at`; nothing where it does not end by `end`, or none begins there.
/// `end` is at most the size of `bytes`.
std::optional<Element> read_element(std::span<const std::byte> bytes, std::size_t at,
                                    std::size_t end) noexcept;

/// An unsigned integer of at most eight bytes (section 7.2); none are 0.
std::optional<std::uint64_t> read_unsigned(std::span<const std::byte> content) noexcept;

}  // namespace docent::video
