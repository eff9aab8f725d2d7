#include "content/import/osm/osm_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <set>
#include <unordered_map>

namespace docent::import {
namespace {

class FeatureMaker {
 public:
  explicit FeatureMaker(const OsmData& data) : data_(data) {
    for (const OsmWay& way : data.ways) way_.emplace(way.id, &way);
  }

  std::vector<MapFeature> made() && {
    for (const auto& [id, node] : data_.nodes)
      if (!node.tags.empty())
        features_.push_back({.tags = node.tags,
                             .form = FeatureForm::Point,
                             .line = {node.at},
                             .id = fmt::format("node/{}", id),
                             .placed = node.placed});
    for (const OsmRelation& relation : data_.relations) add_relation(relation);
    for (const OsmWay& way : data_.ways) add_way(way);
    return std::move(features_);
  }

 private:
  std::vector<Vec2> points_of(const std::vector<std::int64_t>& nodes) const {
    std::vector<Vec2> points;
    for (const std::int64_t id : nodes)
      if (const auto node = data_.nodes.find(id); node != data_.nodes.end())
        points.push_back(node->second.at);
    return points;
  }

  void add_way(const OsmWay& way) {
    if (way.tags.empty()) return;
    MapFeature feature{.tags = way.tags,
                       .form = FeatureForm::Line,
                       .line = points_of(way.nodes),
                       .id = fmt::format("way/{}", way.id),
                       .placed = way.placed};
    if (feature.line.size() < 2) return;
    const bool closed =
        way.nodes.size() > 3 && way.nodes.front() == way.nodes.back() && feature.line.size() > 3;
    if (closed && is_area(feature)) {
      feature.form = FeatureForm::Area;
      feature.line.pop_back();
      feature.polygons = {{std::move(feature.line)}};
      feature.line.clear();
    }
    features_.push_back(std::move(feature));
  }

  /// The outer ways joined to rings, each with the inner ones that lie inside it: which is told by
  /// the nesting alone, so all holes go with the first outer ring that holds them.
  void add_relation(const OsmRelation& relation) {
    const auto type = relation.tags.find("type");
    if (type == relation.tags.end() || type->second != "multipolygon") return;
    MapFeature feature{.tags = relation.tags,
                       .form = FeatureForm::Area,
                       .id = fmt::format("relation/{}", relation.id),
                       .placed = relation.placed};
    inherit_tags(relation, feature);
    const std::vector<BuildingRing> outer = rings_of(relation, false),
                                    inner = rings_of(relation, true);
    for (const BuildingRing& ring : outer) feature.polygons.push_back({ring});
    for (const BuildingRing& hole : inner)
      for (std::vector<BuildingRing>& polygon : feature.polygons)
        if (is_inside(polygon.front(), hole.front())) {
          polygon.push_back(hole);
          break;
        }
    if (!feature.polygons.empty()) features_.push_back(std::move(feature));
  }

  /// An old multipolygon bears its tags on its one outer way.
  void inherit_tags(const OsmRelation& relation, MapFeature& feature) {
    if (feature.tags.size() > 1) return;
    for (const OsmMember& member : relation.members)
      if (const auto way = way_.find(member.way); !member.inner && way != way_.end())
        feature.tags.insert(way->second->tags.begin(), way->second->tags.end());
  }

  std::vector<BuildingRing> rings_of(const OsmRelation& relation, bool inner) const {
    std::deque<std::vector<std::int64_t>> left;
    for (const OsmMember& member : relation.members)
      if (const auto way = way_.find(member.way);
          member.inner == inner && way != way_.end() && way->second->nodes.size() > 1)
        left.push_back(way->second->nodes);
    std::vector<BuildingRing> rings;
    while (!left.empty()) {
      std::vector<std::int64_t> ring = std::move(left.front());
      left.pop_front();
      while (ring.front() != ring.back() && append_next(ring, left)) {
      }
      BuildingRing points = points_of(ring);
      if (points.size() > 1 && points.front() == points.back()) points.pop_back();
      if (points.size() >= 3) rings.push_back(std::move(points));
    }
    return rings;
  }

  static bool append_next(std::vector<std::int64_t>& ring,
                          std::deque<std::vector<std::int64_t>>& left) {
    for (auto piece = left.begin(); piece != left.end(); ++piece) {
      if (piece->back() == ring.back()) std::ranges::reverse(*piece);
      if (piece->front() != ring.back()) continue;
      ring.insert(ring.end(), piece->begin() + 1, piece->end());
      left.erase(piece);
      return true;
    }
    return false;
  }

  static bool is_inside(const BuildingRing& ring, Vec2 point) {
    bool inside = false;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
      if ((a.y > point.y) != (b.y > point.y) &&
          point.x < a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x))
        inside = !inside;
    }
    return inside;
  }

  const OsmData& data_;
  std::unordered_map<std::int64_t, const OsmWay*> way_;
  std::vector<MapFeature> features_;
};

ImportedBuilding building_of(const OsmData& data, const BuildingSource& source,
                             const ImportOptions& options) {
  const std::vector<MapFeature> features = features_of(data);
  ImportedBuilding building =
      building_of_map(features, {.file = source.file, .always_degrees = true}, options);
  building.attribution = "© OpenStreetMap contributors";
  return building;
}

}  // namespace

std::vector<MapFeature> features_of(const OsmData& data) {
  return FeatureMaker(data).made();
}

ImportedBuilding read_osm(const BuildingSource& source, const ImportOptions& options) {
  return building_of(read_osm_xml(source.file, source.bytes), source, options);
}

ImportedBuilding read_pbf(const BuildingSource& source, const ImportOptions& options) {
  return building_of(read_osm_pbf(source.file, source.bytes), source, options);
}

}  // namespace docent::import
