#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "config/museum_config.h"
#include "content/compile/report.h"

namespace docent::compile {

/// The rules of a museum's time zone as POSIX writes them (time_zone.h), so that kiosks need no
/// tables: those of the IANA zone that staff name, from this machine's tables, or rules that they
/// write themselves. Empty where they say none; what cannot be found is reported.
std::string zone_rules(const config::MuseumConfig& config, Report& report);

/// What the bytes of a table (TZif, RFC 8536) say of the years to come: its last line. Empty where
/// they say nothing or are none.
std::string rules_of_table(std::string_view bytes);

}  // namespace docent::compile
