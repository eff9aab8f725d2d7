#pragma once

#include "content/import/building/imported_building.h"

namespace docent::import {

/// Reads IndoorGML 1.0 (OGC 14-005r5): cells are rooms, transitions between cells of one level are
/// doors (where the boundary that is their dual lies, else where their line leaves the cell), those
/// between levels are stairs or lifts. Levels are told apart by the height of the cells' floors.
ImportedBuilding read_indoorgml(const BuildingSource& source, const ImportOptions& options);

/// Reads the rooms of CityGML 2 in detail LoD4: floors, and doors in their walls.
ImportedBuilding read_citygml(const BuildingSource& source, const ImportOptions& options);

}  // namespace docent::import
