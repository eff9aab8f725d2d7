#include "content/import/building/map_feature.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <set>

#include "content/import/building/level_list.h"
#include "runtime/model/place_kind.h"

namespace docent::import {
namespace {

using std::string_view;

bool one_of(string_view value, std::initializer_list<string_view> values) {
  return std::ranges::find(values, value) != values.end();
}

/// What it is called by `indoor`, else by `kind` and its like.
string_view indoor_of(const MapFeature& feature) {
  if (const string_view indoor = feature.tag("indoor"); !indoor.empty() && indoor != "yes")
    return indoor;
  for (const string_view key : {"kind", "type", "category", "buildingpart"})
    if (const string_view value = feature.tag(key); !value.empty()) return value;
  return feature.tag("indoor");
}

bool is_outline(const MapFeature& feature) {
  return one_of(indoor_of(feature), {"level", "outline", "building", "floor"}) ||
         feature.tag("osmAG:areaType") == "structure";
}

FeatureRole area_role(const MapFeature& feature) {
  const string_view indoor = indoor_of(feature);
  if (is_outline(feature)) return FeatureRole::Outline;
  if (one_of(indoor, {"wall", "walls"})) return FeatureRole::Wall;
  if (one_of(indoor, {"column", "pillar", "obstacle", "fixture", "case", "void", "shaft"}))
    return FeatureRole::Obstacle;
  if (one_of(indoor, {"door", "opening", "passage"})) return FeatureRole::Door;
  if (one_of(indoor, {"corridor", "hallway", "walkway"})) return FeatureRole::Corridor;
  if (one_of(indoor, {"area", "hall", "open", "lobby", "verticalpassage"}))
    return indoor == "verticalpassage" ? FeatureRole::Room : FeatureRole::Hall;
  if (one_of(indoor, {"room", "stairs", "elevator", "lift", "escalator", "ramp", "toilets",
                      "toilet", "restroom", "gallery", "office", "shop"}))
    return FeatureRole::Room;
  if (feature.tag("highway") == "elevator") return FeatureRole::Room;
  const string_view room = feature.tag("room");
  if (one_of(room, {"corridor", "hallway"})) return FeatureRole::Corridor;
  if (!room.empty() && room != "no") return FeatureRole::Room;
  if (place_kind_named(indoor)) return FeatureRole::Room;
  return FeatureRole::Other;
}

FeatureRole role_of(const MapFeature& feature) {
  if (feature.form == FeatureForm::Area) return area_role(feature);
  const string_view indoor = indoor_of(feature);
  const auto is_set = [&](string_view key) {
    return !feature.tag(key).empty() && feature.tag(key) != "none";
  };
  if (one_of(indoor, {"door", "opening", "passage"}) || is_set("door") || is_set("entrance") ||
      feature.tag("railway") == "train_station_entrance")
    return FeatureRole::Door;
  if (feature.form == FeatureForm::Point) return FeatureRole::Other;
  if (one_of(indoor, {"wall", "walls"}) || feature.tag("barrier") == "wall")
    return FeatureRole::Wall;
  if (one_of(feature.tag("highway"), {"footway", "corridor", "pedestrian", "path"}))
    return FeatureRole::Way;
  return FeatureRole::Other;
}

/// Stairs, lifts and their like; empty for anything else.
string_view connection_of(const MapFeature& feature) {
  const string_view highway = feature.tag("highway"), room = feature.tag("room"),
                    kind = indoor_of(feature), stairs = feature.tag("stairs"),
                    conveying = feature.tag("conveying");
  if (highway == "elevator" || one_of(room, {"elevator", "lift"}) ||
      one_of(kind, {"elevator", "lift"}) || feature.tag("elevator") == "yes")
    return "lift";
  const bool steps = highway == "steps" || room == "stairs" || kind == "stairs" ||
                     kind == "escalator" || (!stairs.empty() && stairs != "no");
  if (steps) {
    const bool moves = !conveying.empty() && conveying != "no";
    return moves || kind == "escalator" ? "escalator" : "stairs";
  }
  if (kind == "ramp" || (!feature.tag("ramp").empty() && feature.tag("ramp") != "no" &&
                         feature.form == FeatureForm::Area))
    return "ramp";
  return {};
}

/// `0.9`, `0.9 m`, `90 cm`.
double width_of(const MapFeature& feature) {
  for (const string_view key : {"width", "door:width", "entrance:width"}) {
    const string_view text = feature.tag(key);
    double width = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), width);
    if (fault != std::errc{} || !(width > 0)) continue;
    const string_view unit = text.substr(static_cast<std::size_t>(end - text.data()));
    if (unit.find("cm") != string_view::npos) return width / 100;
    if (unit.find("mm") != string_view::npos) return width / 1000;
    return width;
  }
  return 0;
}

Titles titles_of(const MapFeature& feature) {
  Titles titles;
  for (const auto& [key, value] : feature.tags) {
    if (!key.starts_with("name:") || value.empty()) continue;
    const std::string tag = key.substr(5);
    const bool plain = tag.size() >= 2 && tag.size() <= 3 &&
                       std::ranges::all_of(tag, [](char c) { return c >= 'a' && c <= 'z'; });
    if (plain) titles[tag] = value;
  }
  return titles;
}

std::vector<std::string> places_of(const MapFeature& feature, FeatureRole role) {
  std::vector<std::string> places;
  for (const PlaceKind kind : place_kinds_of_osm([&](string_view key) { return feature.tag(key); }))
    places.emplace_back(info_of(kind).name);
  // Any door is an `entrance` of something; those that lead out say main or emergency, or are one.
  if (places.empty() && role != FeatureRole::Door)
    if (const auto kind = place_kind_named(indoor_of(feature)))
      places.emplace_back(info_of(*kind).name);
  return places;
}

class MapReader {
 public:
  MapReader(const GeoFrame& frame, std::vector<Doubt>& doubts) : frame_(frame), doubts_(doubts) {}

  PlanFeature read(const MapFeature& feature) {
    PlanFeature made{.role = role_of(feature), .form = feature.form};
    for (const Vec2 point : feature.line) made.line.push_back(frame_.to_floor(point));
    for (const auto& polygon : feature.polygons) {
      auto& rings = made.polygons.emplace_back();
      for (const BuildingRing& ring : polygon) {
        auto& laid = rings.emplace_back();
        for (const Vec2 point : ring) laid.push_back(frame_.to_floor(point));
      }
    }
    if (made.role == FeatureRole::Door && made.form == FeatureForm::Area) take_middle(made);
    made.name = name_of(feature);
    made.titles = titles_of(feature);
    made.source_id = feature.id;
    made.short_name = feature.tag("level:ref");
    made.placed = feature.placed;
    made.width = width_of(feature);
    made.from = feature.tag("osmAG:from");
    made.to = feature.tag("osmAG:to");
    made.connection = connection_of(feature);
    made.places = places_of(feature, made.role);
    set_direction(feature, made);
    set_levels(feature, made);
    return made;
  }

 private:
  static std::string name_of(const MapFeature& feature) {
    for (const string_view key : {"name", "ref", "title", "label"})
      if (const string_view name = feature.tag(key); !name.empty()) return std::string(name);
    return {};
  }

  /// A door drawn as an area: the middle line along its longer sides.
  static void take_middle(PlanFeature& door) {
    door.form = FeatureForm::Line;
    if (door.polygons.empty() || door.polygons[0].empty()) return;
    const BuildingRing& ring = door.polygons[0][0];
    Vec2 centre{}, along{1, 0};
    double longest = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      centre += ring[i] / static_cast<double>(ring.size());
      const Vec2 edge = ring[(i + 1) % ring.size()] - ring[i];
      if (glm::length(edge) <= longest) continue;
      longest = glm::length(edge);
      along = edge;
    }
    door.line = {centre - along / 2.0, centre + along / 2.0};
    door.polygons.clear();
  }

  static void set_direction(const MapFeature& feature, PlanFeature& made) {
    const string_view conveying = feature.tag("conveying"), incline = feature.tag("incline"),
                      oneway = feature.tag("oneway");
    if (one_of(conveying, {"forward", "backward"}))
      made.direction = conveying;
    else if (made.connection == "escalator" && oneway == "yes")
      made.direction = "forward";
    else if (made.connection == "escalator" && oneway == "-1")
      made.direction = "backward";
    if (incline == "up" || (!incline.empty() && incline[0] >= '0' && incline[0] <= '9'))
      made.up = true;
    if (incline == "down" || incline.starts_with('-')) made.up = false;
  }

  void set_levels(const MapFeature& feature, PlanFeature& made) {
    for (const string_view key : {"level", "repeat_on", "levels", "floor", "storey"}) {
      const string_view text = feature.tag(key);
      if (text.empty() || (key != "level" && key != "repeat_on" && !made.levels.empty())) continue;
      const auto levels = parse_levels(text);
      if (levels) {
        made.levels.insert(made.levels.end(), levels->begin(), levels->end());
      } else if (doubts_.size() < 1000) {
        doubts_.push_back(
            {"unreadable-level", "", made.line.empty() ? Vec2{} : made.line.front(),
             fmt::format("{} says {} = '{}', which names no level", feature.id, key, text),
             "write numbers: 0, -1, 0;1 or -1-2"});
      }
    }
    std::ranges::sort(made.levels);
    made.levels.erase(std::ranges::unique(made.levels).begin(), made.levels.end());
  }

  const GeoFrame& frame_;
  std::vector<Doubt>& doubts_;
};

/// The corners that tell the frame: of rooms, where there are some.
void see(std::span<const MapFeature> features, MapNumbersSeen& seen) {
  for (const bool only_rooms : {true, false}) {
    for (const MapFeature& feature : features) {
      if (only_rooms && role_of(feature) == FeatureRole::Other) continue;
      if (!only_rooms && feature.form == FeatureForm::Point) continue;
      if (!feature.line.empty()) seen.rings.push_back(feature.line);
      for (const auto& polygon : feature.polygons)
        seen.rings.insert(seen.rings.end(), polygon.begin(), polygon.end());
    }
    if (!seen.rings.empty()) return;
  }
}

std::vector<LevelFact> level_facts(const std::vector<PlanFeature>& features) {
  std::vector<LevelFact> facts;
  for (const PlanFeature& feature : features) {
    if (feature.role != FeatureRole::Outline || feature.levels.size() != 1) continue;
    if (feature.titles.empty() && feature.name.empty()) continue;
    LevelFact fact{.ordinal = feature.levels[0], .short_name = feature.short_name};
    fact.titles = feature.titles;
    if (fact.titles.empty()) fact.titles["en"] = feature.name;
    facts.push_back(std::move(fact));
  }
  return facts;
}

/// A file that knows no rooms is the outline of one: each area is a room with its name.
void take_areas_for_rooms(std::vector<PlanFeature>& features, std::span<const MapFeature> drawn) {
  const bool tagged = std::ranges::any_of(drawn, [](const MapFeature& feature) {
    return !feature.tag("indoor").empty() || !feature.tag("highway").empty() ||
           !feature.tag("door").empty() || !feature.tag("railway").empty() ||
           !feature.tag("building").empty();
  });
  const bool rooms = std::ranges::any_of(features, [](const PlanFeature& feature) {
    return feature.form == FeatureForm::Area &&
           (feature.role == FeatureRole::Room || feature.role == FeatureRole::Corridor ||
            feature.role == FeatureRole::Hall);
  });
  if (rooms || tagged) return;
  for (PlanFeature& feature : features)
    if (feature.form == FeatureForm::Area && feature.role == FeatureRole::Other)
      feature.role = FeatureRole::Room;
}

}  // namespace

string_view MapFeature::tag(string_view key) const {
  const auto found = tags.find(key);
  return found == tags.end() ? string_view{} : string_view(found->second);
}

bool is_area(const MapFeature& feature) {
  if (feature.tag("area") == "yes") return true;
  if (feature.tag("area") == "no") return false;
  if (one_of(feature.tag("indoor"), {"wall", "door"})) return false;
  return area_role(feature) != FeatureRole::Other || !feature.tag("building").empty() ||
         !feature.tag("amenity").empty() || !feature.tag("shop").empty();
}

ImportedBuilding building_of_map(std::span<const MapFeature> drawn, MapNumbersSeen seen,
                                 const ImportOptions& options) {
  see(drawn, seen);
  const GeoFrame frame = find_frame(seen, options);
  std::vector<Doubt> doubts;
  std::vector<PlanFeature> features;
  MapReader reader(frame, doubts);
  for (const MapFeature& feature : drawn) features.push_back(reader.read(feature));
  if (!seen.always_degrees) take_areas_for_rooms(features, drawn);
  const std::vector<LevelFact> facts = level_facts(features);
  ImportedBuilding building = assemble(std::move(features), facts);
  if (frame.numbers != MapNumbers::Lengths) building.origin = frame.origin;
  if (!frame.sure)
    doubts.insert(doubts.begin(),
                  {"frame-guessed",
                   "",
                   {},
                   fmt::format("{}: the numbers were taken for {}", seen.file, frame.said),
                   "say --unit m if they are metres, or export the plan as GeoJSON in WGS84 "
                   "(longitude, latitude)"});
  building.doubts.insert(building.doubts.begin(), doubts.begin(), doubts.end());
  building.frame_said = frame.said;
  return building;
}

}  // namespace docent::import
