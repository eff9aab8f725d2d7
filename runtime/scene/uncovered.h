#pragma once

#include <span>

#include "runtime/scene/draw_list.h"

namespace docent::scene {

/// Is nothing seen through this rectangle, but perhaps beside its round corners?
bool is_opaque(const Quad& quad) noexcept;

/// Where anything of this rectangle may be seen: a shadow reaches beyond its own.
Rect reach_of(const Quad& quad) noexcept;

/// Where the model may be seen: what is left of the screen when opaque rectangles of the interface
/// have taken whole edges of it away; empty (without width) where they leave nothing. What they
/// cover elsewhere is in it.
Rect uncovered(std::span<const Quad> quads) noexcept;

}  // namespace docent::scene
