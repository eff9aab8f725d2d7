#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "content/import/building/geo_frame.h"
#include "content/import/building/plan_feature.h"

namespace docent::import {

/// A thing on a map as OpenStreetMap and GeoJSON have it: tags and a geometry, in the map's own
/// numbers.
struct MapFeature {
  std::map<std::string, std::string, std::less<>> tags{};
  FeatureForm form = FeatureForm::Point;
  std::vector<Vec2> line{};  ///< Of a Point one.
  std::vector<std::vector<BuildingRing>> polygons{};
  std::string id{};
  Placed placed{};

  /// A tag's value; empty where there is none.
  [[nodiscard]] std::string_view tag(std::string_view key) const;
};

/// Is a closed line with these tags an area?
bool is_area(const MapFeature& feature);

/// Reads Simple Indoor Tagging, and the same said by `kind`, out of features; `seen` says what is
/// known of their numbers (its rings are filled in here).
ImportedBuilding building_of_map(std::span<const MapFeature> features, MapNumbersSeen seen,
                                 const ImportOptions& options);

}  // namespace docent::import
