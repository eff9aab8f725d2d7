#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "content/import/floor/imported_plan.h"

namespace docent::import {

/// What the numbers of a GeoJSON file mean.
enum class Coordinates : std::uint8_t {
  Metres,  ///< The floor frame itself; numbers are taken over bit for bit.
  Wgs84,   ///< Longitude and latitude in degrees (RFC 7946), projected about the plan's centre.
};

/// A GeoJSON file in memory.
struct GeoJsonText {
  std::string file;       ///< As the author named it, for messages.
  std::string_view text;  ///< UTF-8.
};

/// Reads the files that together make one floor (RFC 7946): bare geometries, Features and
/// FeatureCollections. Polygons and MultiPolygons are walkable areas; geometries of other types are
/// listed in `left_out`; a third coordinate and every property are ignored.
///
/// Throws ContentError with file, line and column for text that is not JSON, structure that is not
/// GeoJSON, coordinates that are not finite numbers, an outer ring of fewer than three positions,
/// degrees outside the globe, and files that hold no area at all.
ImportedPlan parse_floor_plan(std::span<const GeoJsonText> texts, Coordinates coordinates);

/// The same from disk. Throws ContentError for a file that cannot be read, too.
ImportedPlan read_floor_plan(std::span<const std::string> files, Coordinates coordinates);

}  // namespace docent::import
