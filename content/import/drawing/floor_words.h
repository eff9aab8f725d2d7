#pragma once

#include <optional>
#include <string_view>

namespace docent::import {

/// The ordinal of the floor that a title or the name of a file speaks of, in one of many
/// languages: `GROUND FLOOR`, `2. OG`, `Plan_Niveau-1`, `1er étage`, `Piano terra`, `3 этаж`. The
/// ground is 0. Nothing where it speaks of none, or only of the top.
std::optional<double> floor_said(std::string_view text);

}  // namespace docent::import
