#pragma once

#include "runtime/interface/sheet.h"
#include "runtime/scene/look.h"

namespace docent::interface {

/// A guide as large as a box allows, standing on its lower edge; pressed with `control`.
void draw_figure(Sheet& sheet, const scene::Look& look, const PixelBox& box, float opacity,
                 std::int32_t control);

}  // namespace docent::interface
