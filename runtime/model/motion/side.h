#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace docent {

/// A side of a body: its own left is at +x where it faces +z.
enum class Side : std::uint8_t { Left, Right };
constexpr std::array<Side, 2> both_sides{Side::Left, Side::Right};
constexpr std::size_t index_of(Side side) noexcept {
  return static_cast<std::size_t>(side);
}
constexpr Side other(Side side) noexcept {
  return side == Side::Left ? Side::Right : Side::Left;
}
/// +1 for left, -1 for right: the sign of x on that side.
constexpr float sign_of(Side side) noexcept {
  return side == Side::Left ? 1.0F : -1.0F;
}

}  // namespace docent
