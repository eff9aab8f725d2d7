#pragma once

#include <string>
#include <string_view>

#include "content/import/building/imported_building.h"
#include "content/import/drawing/drawing.h"

namespace docent::import {

/// The strokes, closed outlines and texts of an SVG picture, y up, in user units. Layers are the
/// names of the nearest groups: Inkscape's label, else id. What is hidden, and what only defines
/// (defs, clip paths, patterns), is left out. The unit is stated only where the picture has a size
/// on paper and a text of it says its scale, `1:200`.
///
/// Throws ContentError with the place for text that is no XML.
Drawing parse_svg(const std::string& file, std::string_view text);

/// Do two directions 60 degrees apart hold nearly all strokes, as in an isometric view?
bool looks_isometric(const Drawing& drawing);

/// A plan in SVG: rooms are its closed outlines, else found in its lines. A view that is no plan is
/// refused, and a plan without scale asks for one.
BuildingOrDiagnostics read_svg(const BuildingSource& source, const ImportOptions& options);

}  // namespace docent::import
