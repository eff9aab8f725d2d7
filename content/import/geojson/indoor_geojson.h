#pragma once

#include <string>
#include <vector>

#include "content/import/building/imported_building.h"
#include "content/import/building/map_feature.h"

namespace docent::import {

/// Features of a GeoJSON text with their properties as tags (also those under `tags`), and the
/// old `crs` member's name. Throws ContentError with the place.
struct GeoJsonFeatures {
  std::vector<MapFeature> features{};
  std::vector<MapFeature> bare{};  ///< Those without a geometry.
  std::string crs{};
};
GeoJsonFeatures read_geojson_features(const std::string& file, std::string_view text);

/// A building from GeoJSON with `level`, `indoor` or `kind`, and doors as points or lines.
ImportedBuilding read_indoor_geojson(const BuildingSource& source, const ImportOptions& options);

/// How many areas of a plan say that they are rooms: such a plan is imported, not compiled.
std::size_t count_rooms(const GeoJsonFeatures& plan);

}  // namespace docent::import
