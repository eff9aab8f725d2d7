#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "content/import/drawing/drawing.h"
#include "content/import/drawing/layer_kind.h"
#include "content/import/drawing/rooms.h"

namespace docent::import {

/// A layer of closed outlines with a text in most, or called so: its outlines are the rooms.
std::optional<std::uint32_t> layer_of_outlines(const Drawing& drawing,
                                               const std::vector<LayerKind>& kinds);

/// Takes the outlines of a layer as they are.
FoundPlan rooms_of_outlines(const Drawing& drawing, std::uint32_t layer, FoundPlans& found);

}  // namespace docent::import
