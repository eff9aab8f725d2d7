#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace docent::interface {

/// What a visitor has typed to search for: letters as the keys have them, none of which is beyond
/// the first 65,536 of Unicode. What is beyond `count` is zero, so that equal texts are equal.
struct Typed {
  static constexpr std::size_t most = 28;

  std::array<char16_t, most> letter{};
  std::uint8_t count = 0;

  std::u16string_view letters() const noexcept { return {letter.data(), count}; }
  constexpr bool is_full() const noexcept { return count == most; }

  bool operator==(const Typed&) const = default;
};

/// A full text takes up no more. A space at the beginning, or after another, is none.
constexpr void type(Typed& typed, char16_t letter) noexcept {
  const bool is_idle =
      letter == u' ' && (typed.count == 0 || typed.letter[typed.count - std::size_t{1}] == u' ');
  if (!typed.is_full() && !is_idle) typed.letter[typed.count++] = letter;
}
constexpr void erase(Typed& typed) noexcept {
  if (typed.count > 0) typed.letter[--typed.count] = 0;
}

/// What was found for it, the best first. What is beyond `count` is zero.
struct Found {
  static constexpr std::size_t most = 60;

  std::array<std::uint32_t, most> entry{};  ///< What they mean: finder.h.
  std::uint8_t count = 0;
  std::uint32_t total = 0;  ///< Of which `count` are kept.
  bool is_current = true;   ///< Else it is being looked for.

  std::span<const std::uint32_t> entries() const noexcept { return std::span(entry).first(count); }

  bool operator==(const Found&) const = default;
};

}  // namespace docent::interface
