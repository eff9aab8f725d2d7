#include "runtime/video/ebml.h"

#include <bit>

namespace docent::video {

std::optional<VariableNumber> read_variable_number(std::span<const std::byte> bytes) noexcept {
  if (bytes.empty() || bytes[0] == std::byte{0}) return std::nullopt;  // wider than 8 bytes
  const auto first = std::to_integer<std::uint8_t>(bytes[0]);
  const auto width = static_cast<std::size_t>(std::countl_zero(first)) + 1;
  if (bytes.size() < width) return std::nullopt;
  std::uint64_t value = first & (0xFFU >> width);
  for (std::size_t i = 1; i < width; ++i)
    value = value << 8U | std::to_integer<std::uint64_t>(bytes[i]);
  const std::uint64_t ones = (std::uint64_t{1} << (7 * width)) - 1;
  return VariableNumber{.value = value, .width = width, .is_unknown = value == ones};
}

std::optional<Element> read_element(std::span<const std::byte> bytes, std::size_t at,
                                    std::size_t end) noexcept {
  if (at >= end) return std::nullopt;
  const auto within = bytes.first(end);
  // Section 5: an identifier has at most four bytes, and its bits are neither all 0 nor all 1.
  const auto id = read_variable_number(within.subspan(at));
  if (!id || id->width > 4 || id->is_unknown || id->value == 0) return std::nullopt;
  const auto size = read_variable_number(within.subspan(at + id->width));
  if (!size) return std::nullopt;
  Element element{.id = static_cast<std::uint32_t>(id->value | std::uint64_t{1} << (7 * id->width)),
                  .begin = at + id->width + size->width,
                  .end = end,
                  .is_endless = size->is_unknown};
  if (size->is_unknown) return element;
  if (size->value > end - element.begin) return std::nullopt;
  element.end = element.begin + static_cast<std::size_t>(size->value);
  return element;
}

std::optional<std::uint64_t> read_unsigned(std::span<const std::byte> content) noexcept {
  if (content.size() > 8) return std::nullopt;
  std::uint64_t value = 0;
  for (const std::byte byte : content) value = value << 8U | std::to_integer<std::uint64_t>(byte);
  return value;
}

}  // namespace docent::video
