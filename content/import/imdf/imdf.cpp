#include "content/import/imdf/imdf.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <deque>
#include <utility>

#include "content/content_error.h"
#include "content/import/building/geo_frame.h"
#include "content/import/building/level_list.h"
#include "content/import/building/plan_feature.h"
#include "content/import/geojson/indoor_geojson.h"
#include "runtime/model/place_kind.h"

namespace docent::import {
namespace {

using std::string_view;

/// What a unit's category says of its walls.
FeatureRole unit_role(string_view category) {
  if (category == "walkway" || category == "movingwalkway" || category.starts_with("walkway."))
    return FeatureRole::Corridor;
  if (category == "opentobelow" || category == "structure" || category == "column" ||
      category == "nonpublic.structure")
    return FeatureRole::Obstacle;
  if (category == "lobby" || category == "openspace" || category == "platform" ||
      category == "outdoors")
    return FeatureRole::Hall;
  return FeatureRole::Room;
}

string_view unit_connection(string_view category) {
  if (category == "elevator" || category.starts_with("elevator.")) return "lift";
  if (category == "escalator") return "escalator";
  if (category == "stairs" || category == "steps") return "stairs";
  if (category == "ramp") return "ramp";
  return {};
}

class ImdfReader {
 public:
  ImdfReader(const BuildingSource& source, const ImportOptions& options)
      : source_(source), options_(options), files_(unpack_archive(source.file, source.bytes)) {}

  ImportedBuilding building() && {
    read_levels();
    const std::vector<MapFeature> units = features("unit");
    if (levels_.empty() || units.empty())
      throw content::ContentError(source_.file, 0, 0, "no-rooms",
                                  "the archive has no level or no unit, so there is no floor",
                                  "an IMDF archive holds level.geojson and unit.geojson");
    find_frame_of(units);
    read_occupants();
    for (const MapFeature& unit : units) add_unit(unit);
    for (const MapFeature& opening : features("opening")) add_opening(opening);
    for (const char* solid : {"fixture", "kiosk"})
      for (const MapFeature& feature : features(solid)) add_solid(feature, solid);
    for (const MapFeature& amenity : features("amenity")) add_amenity(amenity);
    for (const auto& [anchor, occupant] : occupant_places_) add_occupant(*anchor, *occupant);
    for (const MapFeature& section : features("section")) add_section(section);
    ImportedBuilding building = assemble(std::move(plan_), facts_);
    building.origin = frame_.origin;
    building.frame_said = frame_.said;
    return building;
  }

 private:
  /// The features of one of the archive's files, with `features` of `a.zip/unit.geojson`.
  std::vector<MapFeature> features(const std::string& kind) const {
    const auto file = files_.find(kind + ".geojson");
    if (file == files_.end()) return {};
    string_view text = file->second;
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    return read_geojson_features(source_.file + "/" + file->first, text).features;
  }

  static double number_of(string_view text, double otherwise) {
    double value = otherwise;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    return fault == std::errc{} && std::isfinite(value) ? value : otherwise;
  }

  static Titles titles_of_imdf(const MapFeature& feature, string_view key) {
    Titles titles;
    const std::string prefix = std::string(key) + ":";
    for (const auto& [tag, value] : feature.tags)
      if (tag.starts_with(prefix)) titles[tag.substr(prefix.size())] = value;
    return titles;
  }
  static std::string name_in(const Titles& titles) {
    const auto english = titles.find("en");
    if (english != titles.end()) return english->second;
    return titles.empty() ? std::string() : titles.begin()->second;
  }

  void read_levels() {
    for (const MapFeature& level : features("level")) {
      const double ordinal = number_of(level.tag("ordinal"), 0);
      levels_[level.id] = ordinal;
      if (std::ranges::find(facts_, ordinal, &LevelFact::ordinal) != facts_.end()) continue;
      LevelFact fact{.ordinal = ordinal, .titles = titles_of_imdf(level, "name")};
      fact.short_name = name_in(titles_of_imdf(level, "short_name"));
      fact.name = name_in(fact.titles);
      // A building on another's ordinal may bear the same name: the ordinal tells them apart.
      if (std::ranges::find(facts_, fact.name, &LevelFact::name) != facts_.end())
        fact.name = level_name(ordinal);
      facts_.push_back(std::move(fact));
    }
  }

  void find_frame_of(const std::vector<MapFeature>& units) {
    MapNumbersSeen seen{.file = source_.file + "/unit.geojson", .always_degrees = true};
    for (const MapFeature& unit : units)
      for (const auto& polygon : unit.polygons)
        seen.rings.insert(seen.rings.end(), polygon.begin(), polygon.end());
    frame_ = find_frame(seen, options_);
  }

  /// Occupants stand at anchors, which stand in units: a shop's name is its unit's where that has
  /// none.
  void read_occupants() {
    std::map<std::string, const MapFeature*, std::less<>> anchor;
    anchors_ = features("anchor");
    for (const MapFeature& each : anchors_) anchor[each.id] = &each;
    for (const MapFeature& occupant : bare("occupant")) {
      const auto stands = anchor.find(occupant.tag("anchor_id"));
      if (stands == anchor.end()) continue;
      const std::string unit(stands->second->tag("unit_id"));
      if (!unit.empty()) occupant_of_.try_emplace(unit, titles_of_imdf(occupant, "name"));
      const auto kind = place_kind_of_imdf(occupant.tag("category"));
      if (kind) occupant_places_.push_back({stands->second, &occupants_.emplace_back(occupant)});
    }
  }

  /// Features without a geometry.
  std::vector<MapFeature> bare(const std::string& kind) const {
    const auto file = files_.find(kind + ".geojson");
    if (file == files_.end()) return {};
    string_view text = file->second;
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    return read_geojson_features(source_.file + "/" + file->first, text).bare;
  }

  PlanFeature laid(const MapFeature& feature) const {
    PlanFeature made{.form = feature.form};
    for (const Vec2 point : feature.line) made.line.push_back(frame_.to_floor(point));
    for (const auto& polygon : feature.polygons) {
      auto& rings = made.polygons.emplace_back();
      for (const BuildingRing& ring : polygon) {
        auto& out = rings.emplace_back();
        for (const Vec2 point : ring) out.push_back(frame_.to_floor(point));
      }
    }
    made.titles = titles_of_imdf(feature, "name");
    made.name = name_in(made.titles);
    made.source_id = feature.id;
    made.placed = feature.placed;
    if (const auto level = levels_.find(feature.tag("level_id")); level != levels_.end())
      made.levels = {level->second};
    return made;
  }

  void add_unit(const MapFeature& unit) {
    PlanFeature made = laid(unit);
    const string_view category = unit.tag("category");
    made.role = unit_role(category);
    made.connection = unit_connection(category);
    if (made.name.empty())
      if (const auto occupant = occupant_of_.find(unit.id); occupant != occupant_of_.end()) {
        made.titles = occupant->second;
        made.name = name_in(made.titles);
      }
    if (const auto kind = place_kind_of_imdf(category); kind && made.connection.empty())
      made.places = {std::string(info_of(*kind).name)};
    if (!made.levels.empty()) unit_level_[unit.id] = made.levels[0];
    plan_.push_back(std::move(made));
  }

  void add_opening(const MapFeature& opening) {
    PlanFeature made = laid(opening);
    made.role = FeatureRole::Door;
    const string_view category = opening.tag("category");
    if (category == "emergencyexit") made.places = {"emergency_exit"};
    if (category == "pedestrian.principal") made.places = {"entrance"};
    plan_.push_back(std::move(made));
  }

  void add_solid(const MapFeature& feature, string_view kind) {
    PlanFeature made = laid(feature);
    made.role = FeatureRole::Obstacle;
    if (kind == "kiosk" && !made.name.empty()) made.places = {"information"};
    plan_.push_back(std::move(made));
  }

  void add_amenity(const MapFeature& amenity) {
    PlanFeature made = laid(amenity);
    const auto kind = place_kind_of_imdf(amenity.tag("category"));
    if (!kind || *kind == PlaceKind::Stairs || *kind == PlaceKind::Lift) return;
    made.places = {std::string(info_of(*kind).name)};
    // Its units say on which level it is.
    string_view units = amenity.tag("unit_ids");
    while (made.levels.empty() && !units.empty()) {
      const std::size_t end = std::min(units.find(';'), units.size());
      if (const auto level = unit_level_.find(units.substr(0, end)); level != unit_level_.end())
        made.levels = {level->second};
      units.remove_prefix(std::min(end + 1, units.size()));
    }
    plan_.push_back(std::move(made));
  }

  /// A shop, a café: where its anchor stands, unless its unit says so already.
  void add_occupant(const MapFeature& anchor, const MapFeature& occupant) {
    PlanFeature made = laid(anchor);
    const auto level = unit_level_.find(anchor.tag("unit_id"));
    if (level == unit_level_.end()) return;
    made.levels = {level->second};
    made.titles = titles_of_imdf(occupant, "name");
    made.name = name_in(made.titles);
    made.places = {std::string(info_of(*place_kind_of_imdf(occupant.tag("category"))).name)};
    const auto same = std::ranges::find_if(plan_, [&](const PlanFeature& unit) {
      return unit.source_id == anchor.tag("unit_id") && unit.places == made.places;
    });
    if (same == plan_.end()) plan_.push_back(std::move(made));
  }

  /// A section has a name and no walls: it is told by the places it stands for, such as a seating
  /// area or parking.
  void add_section(const MapFeature& section) {
    PlanFeature made = laid(section);
    if (const auto kind = place_kind_of_imdf(section.tag("category")))
      made.places = {std::string(info_of(*kind).name)};
    plan_.push_back(std::move(made));
  }

  const BuildingSource& source_;
  const ImportOptions& options_;
  std::map<std::string, std::string> files_;
  std::map<std::string, double, std::less<>> levels_, unit_level_;
  std::map<std::string, Titles, std::less<>> occupant_of_;
  std::vector<MapFeature> anchors_;
  std::deque<MapFeature> occupants_;  ///< Those that are places.
  std::vector<std::pair<const MapFeature*, const MapFeature*>> occupant_places_;
  std::vector<LevelFact> facts_;
  std::vector<PlanFeature> plan_;
  GeoFrame frame_;
};

}  // namespace

ImportedBuilding read_imdf(const BuildingSource& source, const ImportOptions& options) {
  return ImdfReader(source, options).building();
}

}  // namespace docent::import
