#pragma once

#include "config/museum_config.h"
#include "content/compile/report.h"
#include "runtime/model/museum.h"

namespace docent::compile {

/// Reads the exhibits' images, each file once, and ties the exhibits to them. The museum's exhibits
/// are those of the config, in its order. Problems go into the report, with the place of `image`.
void compile_images(const config::MuseumConfig& config, unsigned jobs, Museum& museum,
                    Report& report);

}  // namespace docent::compile
