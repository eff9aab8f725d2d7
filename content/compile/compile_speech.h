#pragma once

#include <cstdint>
#include <vector>

#include "config/museum_config.h"
#include "content/compile/report.h"
#include "runtime/model/museum.h"

namespace docent::compile {

/// Whether sound is made, or only recordings are read.
enum class Speech : std::uint8_t { Check, Make };

/// Gives the museum its voice, and says which languages have none, and why. `before` is what was
/// made last.
void compile_speech(const config::MuseumConfig& config, Speech use,
                    const std::vector<SpeechSound>& before, unsigned jobs, Museum& museum,
                    Report& report);

}  // namespace docent::compile
