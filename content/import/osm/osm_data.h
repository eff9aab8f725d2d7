#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include "content/import/building/map_feature.h"

namespace docent::import {

using OsmTags = std::map<std::string, std::string, std::less<>>;

struct OsmNode {
  Vec2 at{};  ///< Degrees: longitude, latitude.
  OsmTags tags{};
  Placed placed{};
};
struct OsmWay {
  std::int64_t id = 0;
  std::vector<std::int64_t> nodes{};
  OsmTags tags{};
  Placed placed{};
};
struct OsmMember {
  std::int64_t way = 0;
  bool inner = false;
};
/// A relation; members that are no ways are left out.
struct OsmRelation {
  std::int64_t id = 0;
  std::vector<OsmMember> members{};
  OsmTags tags{};
  Placed placed{};
};

/// An extract of OpenStreetMap as its files hold it.
struct OsmData {
  std::map<std::int64_t, OsmNode> nodes{};
  std::vector<OsmWay> ways{};
  std::vector<OsmRelation> relations{};
};

/// Nodes with tags, ways and multipolygons as features with geometry, in the order of the file.
/// Ways whose nodes are missing lose them; what is left of nothing is left out.
std::vector<MapFeature> features_of(const OsmData& data);

OsmData read_osm_xml(const std::string& file, std::string_view text);
OsmData read_osm_pbf(const std::string& file, std::string_view bytes);

/// Buildings from Simple Indoor Tagging. Throw ContentError with one sentence where the file is
/// damaged or its degrees are none.
ImportedBuilding read_osm(const BuildingSource& source, const ImportOptions& options);
ImportedBuilding read_pbf(const BuildingSource& source, const ImportOptions& options);

}  // namespace docent::import
