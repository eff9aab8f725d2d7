#pragma once

#include <concepts>

namespace docent::crowd {

/// "And" and "or" of conditions without a branch between them. Quicker than && and || where every
/// condition is cheap and the processor cannot predict it.
template <std::same_as<bool>... Conditions>
constexpr bool all_hold(Conditions... condition) noexcept {
  return (static_cast<unsigned>(condition) & ...) != 0;
}
template <std::same_as<bool>... Conditions>
constexpr bool any_holds(Conditions... condition) noexcept {
  return (static_cast<unsigned>(condition) | ...) != 0;
}

}  // namespace docent::crowd
