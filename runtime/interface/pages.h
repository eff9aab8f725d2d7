#pragma once

#include <string_view>
#include <vector>

#include "runtime/interface/sheet.h"

namespace docent::interface {

/// As much of a text at a time as so many lines of that width hold, at least a part of a word;
/// together they are the text, in which they lie.
std::vector<std::string_view> pages_of(Sheet& sheet, const TextStyle& style, std::string_view text,
                                       float width, float most_lines);

}  // namespace docent::interface
