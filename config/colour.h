#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

/// Colours as staff write them.
namespace docent::config {

/// "#D2452D" as 0xRRGGBB.
std::optional<std::uint32_t> parse_colour(std::string_view text) noexcept;

/// What was meant by "D2452D", "#d24" and "rgb(210, 69, 45)", as it is to be written; empty where
/// that is not clear.
std::string colour_meant(std::string_view text);

}  // namespace docent::config
