#pragma once

#include <concepts>

namespace docent::crowd {

/// Conditions taken together without a jump between them: where each is cheap and none foreseeable,
/// that is quicker than && and ||.
template <std::same_as<bool>... Conditions>
constexpr bool all_hold(Conditions... condition) noexcept {
  return (static_cast<unsigned>(condition) & ...) != 0;
}
template <std::same_as<bool>... Conditions>
constexpr bool any_holds(Conditions... condition) noexcept {
  return (static_cast<unsigned>(condition) | ...) != 0;
}

}  // namespace docent::crowd
