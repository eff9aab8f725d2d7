#pragma once

#include <cstddef>
#include <vector>

#include "config/museum_config.h"
#include "runtime/model/geometry/floor_plan.h"

namespace docent::compile {

/// The doors that staff wrote down for a floor, in their order.
std::vector<Door> doors_of(const config::MuseumConfig& config, std::size_t floor);

/// What they wrote, in the same order.
std::vector<const config::DoorSection*> door_sections(const config::MuseumConfig& config,
                                                      std::size_t floor);

}  // namespace docent::compile
