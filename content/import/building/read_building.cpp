#include "content/import/building/read_building.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "content/content_error.h"
#include "content/import/building/level_list.h"
#include "content/import/building_xml/building_xml.h"
#include "content/import/drawing/dxf.h"
#include "content/import/drawing/floor_words.h"
#include "content/import/drawing/join_drawings.h"
#include "content/import/drawing/read_drawing.h"
#include "content/import/drawing/svg.h"
#include "content/import/geojson/indoor_geojson.h"
#include "content/import/gml/indoorgml.h"
#include "content/import/ifc/ifc.h"
#include "content/import/imdf/imdf.h"
#include "content/import/osm/osm_data.h"
#include "platform/file/file_kind.h"

namespace docent::import {
namespace {

using std::string_view;

string_view without_blanks(string_view bytes) {
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  const std::size_t begin = bytes.find_first_not_of(" \t\r\n");
  return bytes.substr(std::min(begin, bytes.size()));
}

/// The name of an XML text's first element, without prefix; empty for what is no XML.
string_view root_element(string_view bytes) {
  bytes = without_blanks(bytes);
  if (!bytes.starts_with('<')) return {};
  while (!bytes.empty()) {
    const std::size_t open = bytes.find('<');
    if (open == string_view::npos) return {};
    bytes.remove_prefix(open + 1);
    if (bytes.starts_with("!--")) {
      const std::size_t end = bytes.find("-->");
      if (end == string_view::npos) return {};
      bytes.remove_prefix(end);
    } else if (!bytes.starts_with('?') && !bytes.starts_with('!')) {
      const string_view name = bytes.substr(0, bytes.find_first_of(" \t\r\n/>"));
      const std::size_t colon = name.rfind(':');
      return colon == string_view::npos ? name : name.substr(colon + 1);
    }
  }
  return {};
}

template <const auto& name>
bool has_root(string_view bytes) {
  return root_element(bytes) == string_view(name);
}
constexpr char osm_root[] = "osm";
constexpr char indoorgml_root[] = "IndoorFeatures";
constexpr char citygml_root[] = "CityModel";
constexpr char building_root[] = "building";
constexpr char svg_root[] = "svg";

bool is_json(string_view bytes) {
  return without_blanks(bytes).starts_with('{');
}
bool is_pbf(string_view bytes) {
  return bytes.size() > 16 && bytes.substr(0, 32).find("OSMHeader") != string_view::npos;
}

/// A ZIP archive with a building model in it.
bool is_ifc_archive(string_view bytes) {
  return bytes.starts_with("PK\x03\x04") && bytes.size() > 34 &&
         (bytes.substr(30, 300).find(".ifc") != string_view::npos ||
          bytes.substr(30, 300).find(".IFC") != string_view::npos);
}
BuildingOrDiagnostics read_ifc_archive(const BuildingSource& source, const ImportOptions& options) {
  for (auto& [name, bytes] : unpack_archive(source.file, source.bytes))
    if (looks_like_ifc(bytes))
      return read_ifc({source.file, std::move(bytes), source.level}, options);
  throw content::ContentError(source.file, 0, 0, "unreadable-ifc",
                              "this archive holds no building model in STEP form",
                              "save the model as .ifc or .ifczip");
}

using Reads = bool (*)(string_view);
using Read = BuildingOrDiagnostics (*)(const BuildingSource&, const ImportOptions&);

/// A reader that throws what is wrong.
template <auto reader>
BuildingOrDiagnostics read_with(const BuildingSource& source, const ImportOptions& options) {
  return reader(source, options);
}

struct Format {
  string_view name;
  Reads reads;
  Read read;
  /// Two files of it are never one floor.
  bool is_one_floor = false;
};

/// Every format that is read, the first that fits. A further one is a line here.
constexpr std::array formats{
    Format{"OpenStreetMap XML", has_root<osm_root>, read_with<read_osm>},
    Format{"IndoorGML", has_root<indoorgml_root>, read_with<read_indoorgml>},
    Format{"CityGML", has_root<citygml_root>, read_with<read_citygml>},
    Format{"building_xml", has_root<building_root>, read_with<read_building_xml>, true},
    Format{"OpenStreetMap PBF", is_pbf, read_with<read_pbf>},
    Format{"IMDF", is_imdf, read_with<read_imdf>},
    Format{"DXF", looks_like_dxf, read_dxf, true},
    Format{"IFC", looks_like_ifc, read_ifc},
    Format{"IFC (zipped)", is_ifc_archive, read_ifc_archive},
    Format{"SVG", has_root<svg_root>, read_svg, true},
    Format{"GeoJSON", is_json, read_with<read_indoor_geojson>},
};

const Format* reader_of(string_view bytes) {
  const auto format =
      std::ranges::find_if(formats, [&](const Format& each) { return each.reads(bytes); });
  return format == formats.end() ? nullptr : &*format;
}

constexpr const char* what_is_read =
    "import reads GeoJSON, OpenStreetMap (XML and PBF), IMDF, DXF, IFC, IndoorGML, building_xml "
    "and SVG";

/// What to do with a file that is no plan.
std::string remedy_for(const file::FileKind& kind) {
  if (kind.use == file::FileKind::For::Picture || kind.name.ends_with("picture"))
    return "walls cannot be read out of pixels: ask the architect for the drawing as DXF or IFC, "
           "or "
           "draw the rooms over the picture (QGIS, Inkscape) and save GeoJSON or SVG";
  if (!kind.remedy.empty()) return std::string(kind.remedy);
  return what_is_read;
}

[[noreturn]] void refuse(const BuildingSource& source) {
  if (source.bytes.starts_with("\xFF\xFE") || source.bytes.starts_with("\xFE\xFF"))
    throw content::ContentError(source.file, 0, 0, "unknown-format",
                                "this is a text in UTF-16, which no plan is in",
                                "save it as UTF-8: in most editors, Save As and Encoding");
  const file::FileKind kind = file::file_kind(source.bytes);
  throw content::ContentError(
      source.file, 0, 0, "unknown-format",
      source.bytes.empty()
          ? "the file is empty"
          : fmt::format("this is {}, and no plan that is read here", format_of(source.bytes).name),
      source.bytes.empty() ? what_is_read : remedy_for(kind));
}

void rename_level(ImportedBuilding& building, const std::string& name) {
  ImportedLevel& level = building.levels.front();
  if (const auto ordinals = parse_levels(name); ordinals && ordinals->size() == 1)
    level.ordinal = ordinals->front();
  for (ImportedConnection& connection : building.connections)
    for (ImportedStop& stop : connection.stops)
      if (stop.level == level.name) stop.level = name;
  for (Doubt& doubt : building.doubts)
    if (doubt.level == level.name) doubt.level = name;
  level.name = name;
}

/// Of several files, each is the level that its name tells; where it tells none, a drawing is a
/// level of its own, in the order of the files, and a map goes on the ground.
int place_level(ImportedBuilding& part, const std::string& file, bool is_one_floor, int next) {
  const std::string stem = std::filesystem::path(file).stem().string();
  const auto said = floor_said(stem);
  if (!said && !is_one_floor) return next;
  ImportedLevel& level = part.levels.front();
  level.ordinal = said.value_or(next);
  if (!said && next > 0)
    part.doubts.push_back(
        {"level-guessed",
         level_name(level.ordinal),
         {},
         fmt::format("{} does not say which level it is, and was taken for level {}", file,
                     level_name(level.ordinal)),
         fmt::format("say --level NAME={}, or write the ordinal of its [[floor]]", file)});
  rename_level(part, level_name(level.ordinal));
  return static_cast<int>(std::floor(level.ordinal)) + 1;
}

template <typename T>
void append(std::vector<T>& to, std::vector<T>& from) {
  std::ranges::move(from, std::back_inserter(to));
}

/// Levels by one name are one; where one file calls a level otherwise than another, its ordinal
/// decides.
void merge(ImportedBuilding& into, ImportedBuilding part) {
  for (ImportedLevel& level : part.levels) {
    const auto same = std::ranges::find_if(into.levels, [&](const ImportedLevel& other) {
      return other.name == level.name || other.ordinal == level.ordinal;
    });
    if (same == into.levels.end()) {
      into.levels.push_back(std::move(level));
      continue;
    }
    for (ImportedConnection& connection : part.connections)
      for (ImportedStop& stop : connection.stops)
        if (stop.level == level.name) stop.level = same->name;
    append(same->rooms, level.rooms);
    append(same->doors, level.doors);
    append(same->places, level.places);
    append(same->ways, level.ways);
    append(same->shafts, level.shafts);
    append(same->obstacles, level.obstacles);
  }
  append(into.connections, part.connections);
  append(into.doubts, part.doubts);
  for (auto [to, from] :
       {std::pair{&into.unit_said, &part.unit_said}, std::pair{&into.frame_said, &part.frame_said},
        std::pair{&into.attribution, &part.attribution}})
    if (to->empty()) *to = std::move(*from);
  if (!into.origin) into.origin = part.origin;
  if (!into.moved_by) into.moved_by = part.moved_by;
}

/// Shafts of neighbouring levels this near to each other are one. Metres.
constexpr double one_shaft = 3;

/// Connections that may go on above, each with its shaft's place on the level below.
using OpenShafts = std::vector<std::pair<ImportedConnection, Vec2>>;

void keep_joined(OpenShafts& shafts, ImportedBuilding& building) {
  for (auto& [connection, place] : shafts)
    if (connection.stops.size() > 1) building.connections.push_back(std::move(connection));
}

/// Stairs and lifts that the plans of neighbouring levels show over one another join them.
void join_shafts(ImportedBuilding& building) {
  OpenShafts open;
  for (const ImportedLevel& level : building.levels) {
    OpenShafts here;
    for (const ImportedShaft& shaft : level.shafts) {
      ImportedConnection connection{.kind = shaft.kind, .name = shaft.name};
      const auto away = [&](const auto& other) {
        return other.first.kind == shaft.kind ? glm::distance(other.second, shaft.position)
                                              : 2 * one_shaft;
      };
      const auto below = std::ranges::min_element(open, {}, away);
      if (below != open.end() && away(*below) < one_shaft) {
        connection = std::move(below->first);
        if (connection.name.empty()) connection.name = shaft.name;
        open.erase(below);
      }
      connection.stops.push_back({level.name, shaft.position, 0});
      here.emplace_back(std::move(connection), shaft.position);
    }
    keep_joined(open, building);
    open = std::move(here);
  }
  keep_joined(open, building);
}

}  // namespace

FormatFound format_of(string_view bytes) {
  if (const Format* format = reader_of(bytes)) return {format->name, true};
  if (const file::FileKind kind = file::file_kind(bytes); !kind.name.empty())
    return {kind.name, false};
  return {"nothing that we know", false};
}

namespace {

/// Drawings in text form that say the same level are one drawing.
bool is_joined(const BuildingSource& a, const BuildingSource& b) {
  return !a.level.empty() && a.level == b.level && looks_like_dxf(a.bytes) &&
         looks_like_dxf(b.bytes);
}

/// Reads a source, with those after it that are drawings of the same level.
BuildingOrDiagnostics read_joined(std::span<const BuildingSource> sources, std::size_t first,
                                  const Format& format, const ImportOptions& options) {
  const BuildingSource& source = sources[first];
  std::vector<Drawing> drawings;
  for (std::size_t i = first; i < sources.size(); ++i)
    if (i > first && is_joined(source, sources[i])) {
      if (drawings.empty()) drawings.push_back(parse_dxf(source.file, source.bytes));
      drawings.push_back(parse_dxf(sources[i].file, sources[i].bytes));
    }
  if (drawings.empty()) return format.read(source, options);
  return read_drawing(join_drawings(std::move(drawings)), source, options);
}

}  // namespace

BuildingOrDiagnostics read_building(std::span<const BuildingSource> sources,
                                    const ImportOptions& options) {
  ImportedBuilding building;
  ImportOptions so_far = options;
  Diagnostics mistakes;
  int next = 0;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const BuildingSource& source = sources[i];
    const Format* format = reader_of(source.bytes);
    if (format == nullptr) refuse(source);
    if (std::ranges::any_of(sources.first(i), [&](const BuildingSource& before) {
          return is_joined(before, source);
        }))
      continue;
    BuildingOrDiagnostics part = read_joined(sources, i, *format, so_far);
    if (!part) {
      mistakes.insert(mistakes.end(), part.error().begin(), part.error().end());
      continue;
    }
    if (!so_far.origin) so_far.origin = part->origin;
    if (!so_far.move_by) so_far.move_by = part->moved_by;
    if (!source.level.empty() && part->levels.size() == 1) {
      if (!parse_levels(source.level)) part->levels.front().ordinal = next;
      rename_level(*part, source.level);
      next = static_cast<int>(part->levels.front().ordinal) + 1;
    } else if (sources.size() > 1 && part->levels.size() == 1 && part->levels.front().unsaid) {
      next = place_level(*part, source.file, format->is_one_floor, next);
    }
    merge(building, std::move(*part));
  }
  if (!mistakes.empty()) return std::unexpected(std::move(mistakes));
  std::ranges::stable_sort(building.levels, {}, &ImportedLevel::ordinal);
  join_shafts(building);
  return building;
}

}  // namespace docent::import
