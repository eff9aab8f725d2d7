#include "content/import/floor/geojson.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "content/content_error.h"
#include "content/import/floor/json.h"
#include "content/import/floor/projection.h"
#include "content/read_source.h"
#include "platform/file/file_kind.h"
#include "runtime/model/none.h"

namespace docent::import {
namespace {

using Kind = JsonValue::Kind;

/// Reads one file's areas into a plan.
class GeoJsonReader {
 public:
  GeoJsonReader(const GeoJsonText& source, Coordinates coordinates, ImportedPlan& plan)
      : file_(source.file),
        lines_(source.text),
        coordinates_(coordinates),
        file_index_(static_cast<std::uint32_t>(plan.files.size())),
        plan_(plan) {
    plan_.files.push_back(file_);
  }

  /// A geometry, a Feature or a FeatureCollection.
  void read_object(const JsonValue& object) {
    const std::string& type = type_of(object);
    if (type == "FeatureCollection") {
      read_all(array_member(object, "features"));
    } else if (type == "Feature") {
      const JsonValue* geometry = find_member(object, "geometry");
      if (geometry == nullptr)
        fail(object, "this Feature has no geometry",
             "write \"geometry\": {\"type\": \"Polygon\", \"coordinates\": [...]}, or remove it");
      if (geometry->kind != Kind::Null) read_object(*geometry);
    } else if (type == "GeometryCollection") {
      read_all(array_member(object, "geometries"));
    } else if (type == "Polygon") {
      read_polygon(array_member(object, "coordinates"));
    } else if (type == "MultiPolygon") {
      for (const JsonValue& polygon : array_member(object, "coordinates").items)
        read_polygon(polygon);
    } else if (is_thin_geometry(type)) {
      plan_.left_out.push_back({type, place(object)});
    } else {
      fail(object, fmt::format("'{}' is not a type of GeoJSON", type), type_hint(type));
    }
  }

 private:
  static bool is_thin_geometry(const std::string& type) {
    return type == "Point" || type == "MultiPoint" || type == "LineString" ||
           type == "MultiLineString";
  }

  static std::string type_hint(const std::string& type) {
    if (type == "Topology")
      return "this is TopoJSON: save it as GeoJSON in the program that made it";
    const auto small = [](std::string_view text) {
      std::string letters;
      for (const char c : text)
        if (c != ' ' && c != '-' && c != '_')
          letters += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
      if (letters.ends_with('s')) letters.pop_back();
      return letters;
    };
    for (const std::string_view known :
         {"FeatureCollection", "Feature", "Polygon", "MultiPolygon", "GeometryCollection"})
      if (small(known) == small(type))
        return fmt::format("write \"{}\": capital letters matter", known);
    return "a floor is a FeatureCollection of Polygons";
  }

  [[noreturn]] void fail(const JsonValue& where, const std::string& message,
                         std::string hint = {}) const {
    const auto [line, column] = lines_.at(where.offset);
    throw content::ContentError(file_, line, column, "invalid-geojson", message, std::move(hint));
  }

  [[nodiscard]] SourcePlace place(const JsonValue& value) const {
    const auto [line, column] = lines_.at(value.offset);
    return {file_index_, line, column};
  }

  [[nodiscard]] const std::string& type_of(const JsonValue& object) const {
    if (object.kind != Kind::Object)
      fail(object, "a GeoJSON object belongs here",
           "a floor is written {\"type\": \"FeatureCollection\", \"features\": [...]}");
    const JsonValue* type = find_member(object, "type");
    if (type == nullptr)
      fail(object, "this object has no \"type\", so it is not GeoJSON",
           "a floor is a FeatureCollection of Polygons; docent-content import reads other plans");
    if (type->kind != Kind::String)
      fail(*type, "a \"type\" must be a text", "write \"type\": \"Polygon\"");
    return type->string;
  }

  [[nodiscard]] const JsonValue& array_member(const JsonValue& object, const char* name) const {
    const JsonValue* member = find_member(object, name);
    if (member == nullptr)
      fail(object, fmt::format("this {} has no \"{}\"", type_of(object), name),
           fmt::format("write \"{}\": [...], or remove it", name));
    if (member->kind != Kind::Array)
      fail(*member, fmt::format("\"{}\" must be a list", name),
           fmt::format("write \"{}\": [...]", name));
    return *member;
  }

  void read_all(const JsonValue& objects) {
    for (const JsonValue& object : objects.items) read_object(object);
  }

  void read_polygon(const JsonValue& rings) {
    if (rings.kind != Kind::Array)
      fail(rings, "a polygon must be a list of rings", std::string(ring_form));
    if (rings.items.empty()) return;  // RFC 7946, 3.1: an empty array is a null geometry.
    ImportedPolygon polygon{.outer = read_ring(rings.items.front()), .holes = {}};
    if (distinct_vertices(polygon.outer) < 3)
      fail(rings.items.front(),
           fmt::format("the outer ring has {} different points, and an area needs three",
                       distinct_vertices(polygon.outer)),
           "draw the floor's outline, or remove this polygon");
    for (std::size_t i = 1; i < rings.items.size(); ++i)
      polygon.holes.push_back(read_ring(rings.items[i]));
    plan_.polygons.push_back(std::move(polygon));
  }

  /// Counts to three.
  static std::size_t distinct_vertices(const ImportedRing& ring) {
    std::vector<Vec2> seen;
    for (const Vec2 vertex : ring.vertex) {
      if (std::ranges::find(seen, vertex) == seen.end()) seen.push_back(vertex);
      if (seen.size() == 3) break;
    }
    return seen.size();
  }

  [[nodiscard]] ImportedRing read_ring(const JsonValue& positions) {
    if (positions.kind != Kind::Array)
      fail(positions, "a ring must be a list of points", std::string(ring_form));
    if (positions.items.empty()) fail(positions, "this ring has no points", "remove it");
    note_doubtful_height(positions);
    ImportedRing ring;
    ring.vertex.reserve(positions.items.size());
    ring.place.reserve(positions.items.size());
    for (const JsonValue& position : positions.items) {
      ring.vertex.push_back(read_position(position));
      ring.place.push_back(place(position));
    }
    if (ring.vertex.size() > 1 && ring.vertex.front() == ring.vertex.back()) {
      ring.vertex.pop_back();
      ring.place.pop_back();
    }
    return ring;
  }

  [[nodiscard]] Vec2 read_position(const JsonValue& position) const {
    if (position.kind != Kind::Array)
      fail(position, "a point must be a list of two numbers",
           fmt::format("are there too few brackets? {}", ring_form));
    if (position.items.size() < 2)
      fail(position, "a point needs two numbers: x and y, or longitude and latitude",
           "write it as [12.5, 4.0]");
    if (position.items.size() > 3)
      fail(position, fmt::format("a position of {} numbers", position.items.size()),
           "decimals are written with a full stop: [0.5, 4.0], not [0,5, 4,0]");
    const Vec2 point{read_coordinate(position.items[0]), read_coordinate(position.items[1])};
    if (coordinates_ == Coordinates::Wgs84 && (std::abs(point.x) > 180 || std::abs(point.y) > 90))
      fail(position, fmt::format("[{}, {}] is no longitude and latitude", point.x, point.y),
           "is the plan in metres? Then leave --coordinates wgs84 away");
    return point;
  }

  [[nodiscard]] double read_coordinate(const JsonValue& value) const {
    if (value.kind != Kind::Number || !std::isfinite(value.number))
      fail(value, "a coordinate must be a finite number",
           value.kind == Kind::Array ? fmt::format("are there too many brackets? {}", ring_form)
                                     : "write it without quotation marks: [12.5, 4.0]");
    // Beyond this, squares of distances lose the millimetre: no floor on Earth is there.
    constexpr double farthest = 1e8;
    if (std::abs(value.number) > farthest)
      fail(value, fmt::format("the coordinate {} is farther away than any floor", value.number),
           "move the plan near to [0, 0], and write it in metres");
    return value.number;
  }

  /// Of some points of a ring there may be a height (RFC 7946, 3.1.1); but [13,6, 4.8] is one point
  /// with a decimal comma.
  void note_doubtful_height(const JsonValue& positions) {
    const auto has = [](std::size_t size) {
      return [size](const JsonValue& p) { return p.kind == Kind::Array && p.items.size() == size; };
    };
    if (std::ranges::none_of(positions.items, has(2))) return;
    const auto is_whole = [](const JsonValue& v) {
      return v.kind == Kind::Number && v.number == std::trunc(v.number);
    };
    const auto is_doubtful = [&](const JsonValue& p) {
      return has(3)(p) && is_whole(p.items[1]) && (is_whole(p.items[0]) || is_whole(p.items[2]));
    };
    const auto first = std::ranges::find_if(positions.items, is_doubtful);
    if (first != positions.items.end()) plan_.doubtful_heights.push_back(place(*first));
  }

  static constexpr std::string_view ring_form =
      "a polygon is written [[[0, 0], [10, 0], [10, 8], [0, 0]]]";

  std::string file_;
  LineIndex lines_;
  Coordinates coordinates_;
  std::uint32_t file_index_;
  ImportedPlan& plan_;
};

template <typename Function>
void for_each_vertex(ImportedPlan& plan, const Function& function) {
  for (ImportedPolygon& polygon : plan.polygons) {
    std::ranges::for_each(polygon.outer.vertex, function);
    for (ImportedRing& hole : polygon.holes) std::ranges::for_each(hole.vertex, function);
  }
}

/// Lays the plan flat about the centre of the box that holds it.
void project(ImportedPlan& plan) {
  Vec2 low{infinity, infinity}, high{-infinity, -infinity};
  const Vec2 first = plan.polygons.front().outer.vertex.front();
  // Longitudes near the first one, so that a floor may lie across the 180th meridian.
  const auto unwrapped = [first](Vec2 p) {
    return Vec2{first.x + std::remainder(p.x - first.x, 360.0), p.y};
  };
  for_each_vertex(plan, [&](Vec2& vertex) {
    low = glm::min(low, unwrapped(vertex));
    high = glm::max(high, unwrapped(vertex));
  });
  const LocalProjection projection((low + high) / 2.0);
  for_each_vertex(plan, [&](Vec2& vertex) { vertex = projection.to_floor(vertex); });
}

/// Says what a file is that is no GeoJSON, and what reads it.
void refuse_other_kinds(const GeoJsonText& source) {
  const file::FileKind kind = file::file_kind(source.text);
  if (kind.name.empty()) return;
  throw content::ContentError(
      source.file, 1, 1, "not-geojson",
      fmt::format("this is {}, and a floor is GeoJSON", kind.name),
      kind.use == file::FileKind::For::Plan || kind.name == "an SVG drawing"
          ? fmt::format("docent-content import {} -o MUSEUM makes a museum's files of it",
                        source.file)
      : kind.use == file::FileKind::For::Picture
          ? "draw the floor as areas over it, in metres, and save it as GeoJSON"
          : std::string(kind.remedy));
}

}  // namespace

ImportedPlan parse_floor_plan(std::span<const GeoJsonText> texts, Coordinates coordinates) {
  ImportedPlan plan;
  for (const GeoJsonText& source : texts) {
    refuse_other_kinds(source);
    GeoJsonReader(source, coordinates, plan).read_object(parse_json(source.file, source.text));
  }
  if (plan.polygons.empty())
    throw content::ContentError(
        plan.files.empty() ? "" : plan.files.front(), 1, 1, "no-floor",
        "there is no Polygon or MultiPolygon, so there is no floor to walk on",
        "draw the walkable floor as areas, not as lines");
  if (coordinates == Coordinates::Wgs84) project(plan);
  return plan;
}

ImportedPlan read_floor_plan(std::span<const std::string> files, Coordinates coordinates) {
  std::vector<std::string> contents;
  contents.reserve(files.size());
  for (const std::string& file : files)
    contents.push_back(content::read_source(file, "missing-file"));
  std::vector<GeoJsonText> texts;
  texts.reserve(files.size());
  for (std::size_t i = 0; i < files.size(); ++i)
    texts.push_back({files[i], file::without_byte_order_mark(contents[i])});
  return parse_floor_plan(texts, coordinates);
}

}  // namespace docent::import
