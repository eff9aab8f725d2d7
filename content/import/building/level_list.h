#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace docent::import {

/// The ordinals that a level tag names, from the lowest up, each once: numbers, lists `0;1`, ranges
/// `-1-2` and `0-3`, blanks anywhere, words such as `ground` and `basement`. Empty where it names
/// none; nothing where a part of it cannot be understood.
std::optional<std::vector<double>> parse_levels(std::string_view text);

/// An ordinal as people write it: `0`, `-1`, `0.5`.
std::string level_name(double ordinal);

}  // namespace docent::import
