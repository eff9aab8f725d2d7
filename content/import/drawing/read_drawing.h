#pragma once

#include "content/import/building/imported_building.h"
#include "content/import/drawing/drawing.h"

namespace docent::import {

/// A plan in DXF: its rooms and doors, found in the lines or taken from closed outlines. Throws
/// ContentError where the file cannot be read; what is wrong with its content is in the
/// diagnostics.
BuildingOrDiagnostics read_dxf(const BuildingSource& source, const ImportOptions& options);

/// The same of a drawing that is in memory.
BuildingOrDiagnostics read_drawing(Drawing drawing, const BuildingSource& source,
                                   const ImportOptions& options);

}  // namespace docent::import
