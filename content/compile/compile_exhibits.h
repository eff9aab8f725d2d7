#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "config/museum_config.h"
#include "content/compile/compile_floor.h"
#include "content/compile/report.h"
#include "runtime/model/museum.h"

namespace docent::compile {

LocalText plain_texts(const config::LocatedTexts& texts);

/// The floor's most open place, looking north: where a kiosk stands that nobody placed.
Placement most_open_place(const Floor& floor);

/// Makes rooms, the kiosk's place, exhibits and strollers of what staff wrote, and puts them
/// into the museum, whose floors are there already. `floors` has one entry per floor of the config,
/// without walls where the plan was no use: what stands on such a floor is not placed. Problems go
/// into the report.
void compile_exhibits(const config::MuseumConfig& config, std::span<const CompiledFloor> floors,
                      Museum& museum, Report& report);

}  // namespace docent::compile
