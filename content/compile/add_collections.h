#pragma once

#include "config/museum_config.h"
#include "content/compile/report.h"

namespace docent::compile {

/// Adds the objects of the museum's sources ([source]: CSV or IIIF) to its exhibits. What staff
/// wrote by hand in a [[exhibit]] of the same id wins, and is said where it differs. An object that
/// nobody gave a place is left out, and they are counted. A text that is missing in one of the
/// museum's languages is told, and is shown in the first that has it.
void add_collections(config::MuseumConfig& config, Report& report);

}  // namespace docent::compile
