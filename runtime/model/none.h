#pragma once

#include <cstdint>
#include <limits>

namespace docent {

/// What an index says where there is nothing.
inline constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
/// More than any length or time.
inline constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace docent
