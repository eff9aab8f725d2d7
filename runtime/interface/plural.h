#pragma once

#include <array>
#include <string_view>

namespace docent::interface {

/// The plural forms of Unicode CLDR.
inline constexpr std::array<std::string_view, 6> plural_forms{"zero", "one",  "two",
                                                              "few",  "many", "other"};

/// Which of a language's plural forms a whole number below a million takes: one of those (CLDR 42,
/// cardinal rules). A language that CLDR does not know has "one" and "other", as most have. `tag`:
/// BCP 47.
std::string_view plural_form(std::string_view tag, long number) noexcept;

}  // namespace docent::interface
