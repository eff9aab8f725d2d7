#pragma once

#include <vector>

#include "config/museum_config.h"
#include "content/compile/report.h"
#include "runtime/model/museum.h"

namespace docent::compile {

enum class Sounds : std::uint8_t { Make, Check };

/// Reads the recordings of what visitors may listen to, and their captions: brings them level with
/// what is spoken and puts them into `museum.speech`, which has its pieces by then. `before`: what
/// was made last, taken over where nothing changed. What is wrong goes into the report with its
/// place; a check makes nothing.
void compile_sounds(const config::MuseumConfig& config, Sounds use,
                    const std::vector<SpeechSound>& before, Museum& museum, Report& report);

}  // namespace docent::compile
