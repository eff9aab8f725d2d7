#pragma once

#include "config/museum_config.h"
#include "content/compile/report.h"
#include "runtime/model/museum.h"

namespace docent::compile {

/// Adds the museum's languages with the words of the interface: the museum's own, and for what they
/// leave out those that docent ships in that language. Reports words that no language has, that no
/// screen says, that are empty or hold other placeholders than the shipped ones, and a direction of
/// writing that is another language's.
void add_languages(const config::MuseumConfig& config, Museum& museum, Report& report);

}  // namespace docent::compile
