#pragma once

#include "config/museum_config.h"
#include "content/compile/report.h"
#include "runtime/model/museum.h"

namespace docent::compile {

/// Reads the fonts of [look] into the museum, and finds the languages in which they lead: those of
/// whose letters, as the museum's texts and words have them, they hold 97 in 100. What of such a
/// language is missing comes from the kiosk's own fonts, and is told; so is a language of which a
/// font has more than half and not enough.
void read_typefaces(const config::MuseumConfig& config, Museum& museum, Report& report);

}  // namespace docent::compile
