#pragma once

#include <string>

#include "runtime/interface/sheet.h"

namespace docent::interface {

/// What a visitor has typed, or what they can type. Where the box has no room for all of it, its
/// end is seen.
void draw_typed(Sheet& sheet, const PixelBox& box);

/// How much was found, or that one can look through what there is; empty while nobody knows.
std::string found_line(const Sheet& sheet);

}  // namespace docent::interface
