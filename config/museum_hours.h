#pragma once

#include <vector>

#include "config/museum_config.h"

namespace docent::config {

/// Appends what is wrong with the hours and holidays of a museum: each at the letter where it can
/// no longer be read.
void check_hours(const MuseumConfig& config, std::vector<Diagnostic>& diagnostics);

}  // namespace docent::config
