#pragma once

#include "content/import/building/imported_building.h"

namespace docent::import {

/// Reads the labelled plans of Luperto and Amigoni: spaces with a polygon in pixels, y down, a
/// scale, and portals as line segments, many of which are single points.
ImportedBuilding read_building_xml(const BuildingSource& source, const ImportOptions& options);

}  // namespace docent::import
