#pragma once

#include <optional>

#include "runtime/directions/doorways.h"
#include "runtime/interface/control.h"
#include "runtime/interface/shown_way.h"
#include "runtime/path/building/building_map.h"

namespace docent::plan {

/// The way from the kiosk to what the visitor of that state has chosen, in facts; none where
/// nothing is chosen or no way leads there just now. Takes as long as one query.
std::optional<interface::ShownWay> find_shown_way(const Museum& museum,
                                                  const path::BuildingMap& building,
                                                  const directions::Doorways& doorways,
                                                  const interface::InterfaceState& state);

}  // namespace docent::plan
