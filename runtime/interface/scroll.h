#pragma once

#include "runtime/interface/view.h"

namespace docent::interface {

/// Where a rectangle of a part that scrolls is seen when its content has been moved up by `offset`
/// (screen frame); empty where it is not. Does not allocate.
scene::Rect seen_of(const ScrollArea& area, const scene::Rect& rect, float offset) noexcept;
/// The same for what is drawn: moved, with what lies beyond the part's edges cut off.
scene::Quad moved(const ScrollArea& area, scene::Quad quad, float offset) noexcept;
/// Is anything of it seen?
bool is_seen(const ScrollArea& area, const scene::Quad& moved) noexcept;

/// Moves the controls of a view's part that scrolls to where they are with that offset. Of one that
/// is partly beyond the edge only the rest can be touched, and nothing where that is too little for
/// a finger. What turns the part is enabled while there is anything to turn to. Does not allocate.
void place_scrolled(View& view, float offset) noexcept;

/// The offset, nearest to `offset`, with which all of a control is seen, or its beginning where it
/// is longer than the part. The same where the control lies elsewhere.
float offset_showing(const ScrollArea& area, std::int32_t control, float offset) noexcept;

}  // namespace docent::interface
