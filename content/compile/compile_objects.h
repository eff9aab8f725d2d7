#pragma once

#include <cstdint>

#include "config/museum_config.h"
#include "content/compile/report.h"
#include "runtime/model/museum.h"

namespace docent::compile {

/// Reads the exhibits' own shapes, each file once for each height and axis that staff say of it,
/// and ties the exhibits to them. The museum's exhibits are those of the config, in its order.
/// Problems go into the report, with the place of `model`. A check makes only what is touched, and
/// measures the others: what would be guessed or left out is told as it is when all is made.
enum class Objects : std::uint8_t { Make, Check };
void compile_objects(const config::MuseumConfig& config, Objects use, unsigned jobs, Museum& museum,
                     Report& report);

}  // namespace docent::compile
