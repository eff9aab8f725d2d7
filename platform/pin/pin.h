#pragma once

#include <string>
#include <string_view>

#include "runtime/model/result.h"

namespace docent::pin {

inline constexpr std::size_t least_figures = 4, most_figures = 12;

/// Is it 4 to 12 figures?
bool is_pin(std::string_view text) noexcept;

/// The line's value for kiosk.toml: "$argon2id$v=19$m=16384,...". Every call gives another one.
/// Fails with a sentence where it is no PIN, or the machine lacks the memory (16 MB).
Result<std::string> hash(std::string_view pin);

/// Is `pin` the one that `hash` was made of? Takes its time: not for the frame thread.
bool matches(std::string_view pin, const std::string& hash) noexcept;

}  // namespace docent::pin
