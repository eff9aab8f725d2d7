#pragma once

#include "config/museum_config.h"
#include "content/compile/report.h"
#include "runtime/model/museum.h"

namespace docent::compile {

/// The museum's own look, of [look]: its colours, whose contrasts are those of a theme
/// (runtime/scene/theme.h), its letters, and its logo, which comes after all other images. Comes
/// after everything that is read, because a typeface leads only in languages whose letters it has.
void compile_livery(const config::MuseumConfig& config, Museum& museum, Report& report);

}  // namespace docent::compile
