#pragma once

#include <span>
#include <string>
#include <string_view>

#include "content/import/building/imported_building.h"

namespace docent::import {

/// What these bytes are, and whether we read it: `GeoJSON`, `an AutoCAD drawing (DWG)`.
struct FormatFound {
  std::string_view name{};
  bool readable = false;
};
FormatFound format_of(std::string_view bytes);

/// Reads the files that together say one building, each by the reader that its content calls for.
/// All are laid out in one frame; levels of one ordinal become one. Throws ContentError, or gives
/// every mistake of a reader that finds several.
BuildingOrDiagnostics read_building(std::span<const BuildingSource> sources,
                                    const ImportOptions& options);

}  // namespace docent::import
