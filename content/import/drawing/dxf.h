#pragma once

#include <string>
#include <string_view>

#include "content/import/drawing/drawing.h"

namespace docent::import {

/// Is this text a DXF drawing, or a drawing of AutoCAD that is none (DWG, binary DXF), which
/// parse_dxf() refuses by name?
bool looks_like_dxf(std::string_view bytes);

/// The model space of a drawing in the text form of DXF, R12 to 2018: lines, polylines with bulges,
/// arcs, circles, ellipses, splines and texts, with blocks put in their places. Layers that are off
/// or frozen, dimensions, hatches and the like are left out and counted.
///
/// Group codes are few and stable, and what we need of them is less than what GDAL makes of them:
/// it gives neither arcs (door swings) nor which strokes came with a block, and reads one code page
/// a file. So this reader is our own.
///
/// Throws ContentError with file and line for what is no DXF, is cut short, or holds more than
/// two million strokes.
Drawing parse_dxf(const std::string& file, std::string_view bytes);

}  // namespace docent::import
