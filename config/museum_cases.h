#pragma once

#include <vector>

#include "config/museum_config.h"

namespace docent::config {

/// Puts exhibits that say `in` where their cases stand: their floor is the case's, their position
/// becomes one of the floor, and their facing, where they say none, is the case's. Appends what
/// cannot be: a case that is not there, another floor than the case's, a place beside the case.
void stand_in_cases(MuseumConfig& config, std::vector<Diagnostic>& diagnostics);

/// The side of the square that an exhibit takes of the floor where it says no size. Metres.
inline constexpr double ordinary_size = 0.6;

/// Where a case looks that says nothing. Degrees.
inline constexpr double ordinary_facing = 270;

}  // namespace docent::config
