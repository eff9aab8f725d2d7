#include "content/import/geojson/indoor_geojson.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "content/content_error.h"
#include "content/import/floor/json.h"

namespace docent::import {
namespace {

using Kind = JsonValue::Kind;

class FeatureReader {
 public:
  FeatureReader(const std::string& file, std::string_view text) : file_(file), lines_(text) {}

  GeoJsonFeatures read(const JsonValue& root) {
    if (root.kind != Kind::Object) fail(root, "a GeoJSON object belongs here");
    if (const JsonValue* crs = find_member(root, "crs")) read_crs(*crs);
    read_object(root);
    return std::move(read_);
  }

 private:
  [[noreturn]] void fail(const JsonValue& where, const std::string& message) const {
    const auto [line, column] = lines_.at(where.offset);
    throw content::ContentError(file_, line, column, "invalid-geojson", message,
                                "export the plan as GeoJSON again");
  }

  void read_crs(const JsonValue& crs) {
    const JsonValue* properties = find_member(crs, "properties");
    const JsonValue* name = properties == nullptr ? nullptr : find_member(*properties, "name");
    if (name != nullptr) read_.crs = name->string;
  }

  void read_object(const JsonValue& object) {
    if (object.kind != Kind::Object) fail(object, "a GeoJSON object belongs here");
    const JsonValue* type = find_member(object, "type");
    if (type == nullptr || type->kind != Kind::String)
      fail(object, "this object has no \"type\", so it is not GeoJSON");
    if (type->string == "FeatureCollection") return read_all(object, "features");
    if (type->string != "Feature") {
      MapFeature feature;
      set_place(object, feature);
      return read_geometry(object, feature);
    }
    MapFeature feature;
    set_place(object, feature);
    if (const JsonValue* id = find_member(object, "id")) feature.id = text_of(*id);
    if (const JsonValue* properties = find_member(object, "properties")) {
      read_tags(*properties, feature);
      if (const JsonValue* tags = find_member(*properties, "tags")) read_tags(*tags, feature);
    }
    if (feature.id.empty())
      for (const char* key : {"@id", "id", "osm_id"})
        if (feature.id.empty()) feature.id = feature.tag(key);
    const JsonValue* geometry = find_member(object, "geometry");
    if (geometry != nullptr && geometry->kind == Kind::Object)
      read_geometry(*geometry, feature);
    else
      read_.bare.push_back(std::move(feature));
  }

  void read_all(const JsonValue& object, const char* name) {
    const JsonValue* members = find_member(object, name);
    if (members == nullptr || members->kind != Kind::Array)
      fail(object, fmt::format("this object has no array \"{}\"", name));
    for (const JsonValue& member : members->items) read_object(member);
  }

  void set_place(const JsonValue& object, MapFeature& feature) const {
    const auto [line, column] = lines_.at(object.offset);
    feature.placed = {file_, line, column};
  }

  static std::string text_of(const JsonValue& value) {
    if (value.kind == Kind::String) return value.string;
    if (value.kind == Kind::Number) return fmt::format("{:.15g}", value.number);
    if (value.kind == Kind::Boolean) return value.number != 0 ? "yes" : "no";
    if (value.kind != Kind::Array) return {};
    std::string list;
    for (const JsonValue& item : value.items) {
      if (item.kind != Kind::String && item.kind != Kind::Number) return {};
      list += (list.empty() ? "" : ";") + text_of(item);
    }
    return list;
  }

  /// A table of names by language becomes `name:en`.
  static void read_tags(const JsonValue& properties, MapFeature& feature) {
    if (properties.kind != Kind::Object) return;
    for (std::size_t i = 0; i < properties.items.size(); ++i) {
      const JsonValue& value = properties.items[i];
      const std::string& name = properties.names[i];
      if (value.kind != Kind::Object) {
        if (std::string text = text_of(value); !text.empty()) feature.tags[name] = std::move(text);
        continue;
      }
      for (std::size_t k = 0; k < value.items.size(); ++k) {
        std::string text = text_of(value.items[k]);
        if (text.empty()) continue;
        if (!feature.tags.contains(name)) feature.tags[name] = text;
        feature.tags[name + ":" + value.names[k]] = std::move(text);
      }
    }
  }

  void read_geometry(const JsonValue& geometry, MapFeature& feature) {
    const JsonValue* type = find_member(geometry, "type");
    if (type == nullptr || type->kind != Kind::String)
      fail(geometry, "this geometry has no \"type\"");
    if (type->string == "GeometryCollection") {
      const JsonValue* parts = find_member(geometry, "geometries");
      if (parts == nullptr || parts->kind != Kind::Array)
        fail(geometry, "this GeometryCollection has no \"geometries\"");
      for (const JsonValue& part : parts->items) {
        if (part.kind != Kind::Object) fail(part, "a geometry belongs here");
        if (++parts_ > 100'000) fail(part, "there are too many geometries");
        read_geometry(part, feature);
      }
      return;
    }
    const JsonValue* coordinates = find_member(geometry, "coordinates");
    if (coordinates == nullptr || coordinates->kind != Kind::Array)
      fail(geometry, fmt::format("this {} has no \"coordinates\"", type->string));
    read_coordinates(type->string, *coordinates, feature, geometry);
  }

  void read_coordinates(const std::string& type, const JsonValue& coordinates,
                        const MapFeature& feature, const JsonValue& geometry) {
    const auto each = [&](const char* part) {
      for (const JsonValue& item : items_of(coordinates))
        read_coordinates(part, item, feature, geometry);
    };
    if (type == "MultiPoint") return each("Point");
    if (type == "MultiLineString") return each("LineString");
    MapFeature made = feature;
    if (type == "Point") {
      made.form = FeatureForm::Point;
      if (coordinates.items.empty()) return;
      made.line = {position(coordinates)};
    } else if (type == "LineString") {
      made.form = FeatureForm::Line;
      made.line = positions(coordinates);
      if (made.line.empty()) return;
    } else if (type == "Polygon") {
      made.form = FeatureForm::Area;
      add_polygon(coordinates, made);
    } else if (type == "MultiPolygon") {
      made.form = FeatureForm::Area;
      for (const JsonValue& polygon : items_of(coordinates)) add_polygon(polygon, made);
    } else {
      fail(geometry, fmt::format("'{}' is not a type of GeoJSON", type));
    }
    if (made.form == FeatureForm::Area && made.polygons.empty()) return;
    read_.features.push_back(std::move(made));
  }

  void add_polygon(const JsonValue& polygon, MapFeature& feature) const {
    std::vector<BuildingRing> rings;
    for (const JsonValue& ring : items_of(polygon)) {
      BuildingRing drawn = positions(ring);
      if (drawn.size() > 1 && drawn.front() == drawn.back()) drawn.pop_back();
      if (drawn.size() >= 3)
        rings.push_back(std::move(drawn));
      else if (rings.empty())
        return;
    }
    if (!rings.empty()) feature.polygons.push_back(std::move(rings));
  }

  const std::vector<JsonValue>& items_of(const JsonValue& value) const {
    if (value.kind != Kind::Array) fail(value, "an array of positions belongs here");
    return value.items;
  }

  std::vector<Vec2> positions(const JsonValue& line) const {
    std::vector<Vec2> points;
    for (const JsonValue& item : items_of(line)) points.push_back(position(item));
    return points;
  }

  Vec2 position(const JsonValue& value) const {
    if (value.kind != Kind::Array || value.items.size() < 2)
      fail(value, "a position must be an array of two numbers");
    for (std::size_t i = 0; i < 2; ++i)
      if (value.items[i].kind != Kind::Number || !std::isfinite(value.items[i].number) ||
          std::abs(value.items[i].number) > 1e9)
        fail(value.items[i], "a coordinate must be a number that lies on Earth");
    return {value.items[0].number, value.items[1].number};
  }

  const std::string& file_;
  LineIndex lines_;
  GeoJsonFeatures read_;
  std::size_t parts_ = 0;
};

}  // namespace

GeoJsonFeatures read_geojson_features(const std::string& file, std::string_view text) {
  return FeatureReader(file, text).read(parse_json(file, text));
}

ImportedBuilding read_indoor_geojson(const BuildingSource& source, const ImportOptions& options) {
  std::string_view text = source.bytes;
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  GeoJsonFeatures read = read_geojson_features(source.file, text);
  if (!source.level.empty())
    for (MapFeature& feature : read.features) feature.tags.try_emplace("level", source.level);
  return building_of_map(read.features, {.file = source.file, .crs = read.crs}, options);
}

std::size_t count_rooms(const GeoJsonFeatures& plan) {
  return static_cast<std::size_t>(
      std::ranges::count_if(plan.features, [](const MapFeature& feature) {
        const std::string_view indoor = feature.tag("indoor");
        return feature.form == FeatureForm::Area &&
               (indoor == "room" || indoor == "corridor" || indoor == "area");
      }));
}

}  // namespace docent::import
