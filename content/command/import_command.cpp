#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "config/diagnostic_text.h"
#include "config/museum_config.h"
#include "content/command/commands.h"
#include "content/compile/shipped_files.h"
#include "content/content_error.h"
#include "content/import/building/geo_frame.h"
#include "content/import/building/museum_text.h"
#include "content/import/building/read_building.h"
#include "content/import/building/write_museum.h"
#include "content/read_source.h"

namespace docent::command {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

/// What the user asked for.
struct ImportRequest {
  std::vector<std::string> files, levels, layers;
  std::string output, unit;
  std::optional<std::array<double, 2>> origin;
  bool json = false;
};

[[noreturn]] void refuse(const std::string& what, const std::string& message,
                         const std::string& hint) {
  throw content::ContentError(Errc::WrongUsage, what, "wrong-option", message, hint);
}

std::pair<std::string, std::string> split(const std::string& text, const char* option,
                                          const char* form) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
    refuse(option, fmt::format("'{}' is not {}", text, form),
           fmt::format("write {} {}", option, form));
  return {text.substr(0, equals), text.substr(equals + 1)};
}

std::vector<import::BuildingSource> read_sources(const ImportRequest& request) {
  std::vector<import::BuildingSource> sources;
  for (const std::string& file : request.files)
    sources.push_back({.file = file, .bytes = content::read_source(file, "missing-file")});
  for (const std::string& text : request.levels) {
    const auto [name, file] = split(text, "--level", "NAME=FILE");
    const auto same =
        std::ranges::find(sources, file, [](const auto& source) { return source.file; });
    if (same != sources.end())
      same->level = name;
    else
      sources.push_back({file, content::read_source(file, "missing-file"), name});
  }
  if (sources.empty()) refuse("FILE", "no plan is named", "name the files to import");
  return sources;
}

/// The origin that the museum has already; else none.
std::optional<Vec2> museum_origin(const std::string& museum) {
  const config::TomlFile toml = [&] {
    const fs::path file = fs::path(museum) / "museum.toml";
    return fs::exists(file) ? config::read_toml(file, file.string()) : config::TomlFile{};
  }();
  if (!toml.root) return {};
  for (const config::TomlEntry& section : toml.root->entries) {
    if (section.key != "museum") continue;
    for (const config::TomlEntry& field : section.value.entries)
      if (field.key == "origin" && field.value.items.size() == 2)
        return Vec2{field.value.items[1].number, field.value.items[0].number};
  }
  return {};
}

import::ImportOptions options_of(const ImportRequest& request) {
  import::ImportOptions options{.unit = request.unit};
  if (!request.unit.empty() && !(import::unit_in_metres(request.unit) > 0))
    refuse(
        "--unit", fmt::format("'{}' is no unit of length", request.unit),
        "write m, cm, mm, ft or in, a number of metres such as 0.0254, or 1:50 for millimetres of "
        "paper");
  if (request.origin) {
    options.origin = Vec2{(*request.origin)[1], (*request.origin)[0]};
    if (std::abs(options.origin->y) > 90 || std::abs(options.origin->x) > 180)
      refuse("--origin", "the origin lies on no globe", "write latitude, longitude: 48.2, 16.36");
  } else {
    options.origin = museum_origin(request.output);
  }
  for (const std::string& list : request.layers) {
    std::size_t begin = 0;
    while (begin <= list.size()) {
      const std::size_t end = std::min(list.find(',', begin), list.size());
      options.layers.insert(split(list.substr(begin, end - begin), "--layers", "KIND=NAME,..."));
      begin = end + 1;
    }
  }
  return options;
}

/// Are there words for the kiosk's screens in this language?
bool speaks(const std::string& museum, const std::string& language) {
  return fs::exists(fs::path(museum) / "words" / (language + ".toml")) ||
         fs::exists(compile::shipped_words(language));
}

double millimetres(double value) {
  return std::round(value * 1000) / 1000 + 0.0;
}

ordered_json level_json(const import::ImportedLevel& level, const import::LaidLevel& laid) {
  ordered_json rooms = ordered_json::array(), places = ordered_json::array();
  double area = 0;
  for (const import::ImportedRoom& room : level.rooms) {
    const double outline = import::area_of(room), room_area = room.stated_area.value_or(outline);
    const Vec2 at = import::point_in(room, laid);
    area += room_area;
    rooms.push_back({{"name", room.name},
                     {"area", millimetres(room_area)},
                     {"outline_area", millimetres(outline)},
                     {"x", millimetres(at.x)},
                     {"y", millimetres(at.y)},
                     {"kind", room.kind.empty() ? "room" : room.kind},
                     {"source_id", room.source_id}});
  }
  for (const import::ImportedPlace& place : level.places)
    places.push_back({{"kind", place.kind},
                      {"name", place.name},
                      {"x", millimetres(place.position.x)},
                      {"y", millimetres(place.position.y)}});
  return {{"name", level.name},
          {"ordinal", level.ordinal},
          {"elevation", level.elevation ? ordered_json(*level.elevation) : ordered_json(nullptr)},
          {"area", millimetres(area)},
          {"rooms", rooms},
          {"doors", level.doors.size()},
          {"places", places}};
}

ordered_json building_json(const import::LaidBuilding& laid) {
  ordered_json levels = ordered_json::array(), connections = ordered_json::array(),
               doubts = ordered_json::array();
  for (std::size_t i = 0; i < laid.levels.size(); ++i)
    levels.push_back(level_json(laid.building.levels[i], laid.levels[i]));
  for (const import::ImportedConnection& connection : laid.building.connections) {
    ordered_json stops = ordered_json::array();
    for (const import::ImportedStop& stop : connection.stops) stops.push_back(stop.level);
    connections.push_back(
        {{"kind", connection.kind}, {"levels", stops}, {"name", connection.name}});
  }
  for (const import::Doubt& doubt : laid.building.doubts)
    doubts.push_back({{"code", doubt.code},
                      {"level", doubt.level},
                      {"x", millimetres(doubt.at.x)},
                      {"y", millimetres(doubt.at.y)},
                      {"message", doubt.message}});
  return {{"levels", levels}, {"connections", connections}, {"doubts", doubts}};
}

std::vector<Diagnostic> doubts_of(const import::LaidBuilding& laid, const std::string& file) {
  std::vector<Diagnostic> diagnostics;
  for (const import::Doubt& doubt : laid.building.doubts) {
    const std::string where =
        doubt.level.empty()
            ? std::string()
            : fmt::format(" (level {}, [{:.2f}, {:.2f}])", doubt.level, doubt.at.x, doubt.at.y);
    diagnostics.push_back({.file = file,
                           .severity = Severity::Warning,
                           .code = doubt.code,
                           .message = doubt.message + where,
                           .hint = doubt.hint});
  }
  return diagnostics;
}

void say_summary(const import::LaidBuilding& laid, const std::string& museum) {
  std::size_t rooms = 0, doors = 0, places = 0;
  for (const import::ImportedLevel& level : laid.building.levels) {
    rooms += level.rooms.size();
    doors += level.doors.size();
    places += level.places.size();
  }
  fmt::print(stderr, "{}: {} levels, {} rooms, {} doors, {} connections, {} places; {} doubts\n",
             museum, laid.levels.size(), rooms, doors, laid.building.connections.size(), places,
             laid.building.doubts.size());
}

bool has_floor(const import::LaidBuilding& laid) {
  return std::ranges::any_of(laid.levels,
                             [](const import::LaidLevel& level) { return !level.floor.empty(); });
}

int run_import(const ImportRequest& request) {
  const auto form = request.json ? config::DiagnosticForm::Json : config::DiagnosticForm::Text;
  const std::vector<import::BuildingSource> sources = read_sources(request);
  import::BuildingOrDiagnostics read = import::read_building(sources, options_of(request));
  if (!read) {
    config::tell(read.error(), form);
    return exit_code(Errc::InvalidInput);
  }
  import::LaidBuilding laid = import::lay_out(std::move(*read));
  const import::MuseumManner manner{
      .title = fs::path(sources.front().file).stem().string(),
      .speaks = [&](const std::string& language) { return speaks(request.output, language); }};
  std::vector<import::MuseumText> texts = import::museum_texts(laid, manner);
  // A museum without a floor is none: what is there already stays.
  if (!has_floor(laid)) texts.clear();
  const std::vector<Diagnostic> kept = import::write_museum_folder(request.output, texts);
  if (request.json) {
    config::tell(kept, form);
    fmt::print("{}\n",
               building_json(laid).dump(-1, ' ', false, ordered_json::error_handler_t::replace));
    return 0;
  }
  std::vector<Diagnostic> told = doubts_of(laid, sources.front().file);
  told.insert(told.end(), kept.begin(), kept.end());
  config::tell(told, form);
  say_summary(laid, request.output);
  return 0;
}

}  // namespace

terminal::Command import_command() {
  using terminal::Times;
  const auto request = std::make_shared<ImportRequest>();
  return {
      .name = "import",
      .manual =
          "reads plans as museums have them, and writes or updates the text files of a museum",
      .options =
          {{"FILE", terminal::file("FILE", request->files),
            "GeoJSON with levels, OpenStreetMap (XML or PBF), IMDF, DXF, IFC, IndoorGML, "
            "building_xml or SVG, told by their content",
            Times::AnyNumber},
           {"-o,--output", terminal::folder("MUSEUM", request->output),
            "The museum's folder; what staff have changed in it since the last import is kept",
            Times::Once},
           {"--unit", terminal::text("m|cm|mm|ft|in|METRES|1:N", request->unit),
            "How long one of the plan's numbers is: a unit, a number of metres (0.0254), or 1:50 "
            "for millimetres of paper at that scale",
            Times::AtMostOnce, "what the file says"},
           {"--origin", terminal::numbers<2>("LAT,LON", request->origin),
            "Latitude and longitude that become [0, 0]", Times::AtMostOnce,
            "the museum's, else the middle of the plan"},
           {"--level", terminal::text("NAME=FILE", request->levels),
            "A file that is one level, and what the level is called", Times::AnyNumber},
           {"--layers", terminal::text("KIND=NAME,...", request->layers),
            "Which layer of a drawing holds walls, doors, rooms, labels, stairs or furniture",
            Times::AnyNumber},
           {"--json", terminal::flag(request->json),
            "Print levels, rooms, places, connections and doubts as JSON"}},
      .run = [request] { return run_import(*request); }};
}

}  // namespace docent::command
