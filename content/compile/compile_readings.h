#pragma once

#include "config/museum_config.h"
#include "runtime/model/museum.h"

namespace docent::compile {

/// Notes how the museum's Chinese titles and names are read, in Pinyin, and whatever staff say of
/// other texts ([[speech]] with a `reading`): visitors type that.
void compile_readings(const config::MuseumConfig& config, Museum& museum);

}  // namespace docent::compile
