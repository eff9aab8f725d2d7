#pragma once

#include "config/museum_config.h"
#include "content/compile/report.h"
#include "runtime/model/museum.h"

namespace docent::compile {

/// Reads the captions (WebVTT) of the museum's videos, whose pictures are those of the config in
/// its order. What is wrong with a file goes into the report with its place there; and so does that
/// a video has captions in some of the museum's languages only.
void compile_captions(const config::MuseumConfig& config, Museum& museum, Report& report);

}  // namespace docent::compile
