#pragma once

#include "config/museum_config.h"
#include "runtime/model/museum.h"

namespace docent::compile {

/// Builds what is drawn of every floor, once its plan, exhibits and images are in the museum.
/// `config` says what rooms are paved with; null for plans without a museum.
void compile_scenery(const config::MuseumConfig* config, Museum& museum);

}  // namespace docent::compile
