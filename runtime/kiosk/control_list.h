#pragma once

#include <span>
#include <string>

#include "runtime/interface/on_glass.h"

namespace docent::kiosk {

/// What lies on the glass as JSON: an array with an object for each control and label
/// (docent-visit(5), "controls").
std::string to_json(std::span<const interface::OnGlass> items);

}  // namespace docent::kiosk
