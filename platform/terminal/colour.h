#pragma once

#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

namespace docent::terminal {

enum class ColourUse : std::uint8_t { Off, On };

/// Does this stream lead to a terminal?
bool is_terminal(std::FILE* stream) noexcept;

/// Colour only on a terminal that has any, and not where NO_COLOR is set to anything
/// (no-color.org).
ColourUse colour_use_of(std::FILE* stream) noexcept;

enum class Ink : std::uint8_t { Bold, Error, Warning };

/// The text in that ink, or as it is where there is no colour.
std::string painted(std::string_view text, Ink ink, ColourUse colour);

}  // namespace docent::terminal
