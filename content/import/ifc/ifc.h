#pragma once

#include <string_view>

#include "content/import/building/imported_building.h"

namespace docent::import {

/// Is this text a building model in STEP form?
bool looks_like_ifc(std::string_view bytes);

/// Reads a building model (IFC 2.x, 2x3, 4, 4x3): storeys, the outlines of spaces, doors where
/// their openings are, openings where spaces end at nothing (virtual boundaries), stairs, ramps,
/// lifts and escalators between storeys. Walls stay walls: spaces do not touch but at doors.
///
/// What is needed of IFC are a dozen records and their placements, so the reader of STEP files is
/// our own: Assimp, in Debian, gives meshes and no spaces, and web-ifc needs a program of its own.
///
/// Throws ContentError for what is no STEP file; a model without spaces is a diagnostic.
BuildingOrDiagnostics read_ifc(const BuildingSource& source, const ImportOptions& options);

}  // namespace docent::import
