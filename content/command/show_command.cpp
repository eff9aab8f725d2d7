#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <optional>
#include <ranges>
#include <string>
#include <string_view>
#include <vector>

#include "content/command/commands.h"
#include "content/command/open_museum.h"
#include "content/command/query_io.h"
#include "content/command/stopwatch.h"
#include "content/content_error.h"
#include "content/draw/picture_file.h"
#include "content/draw/plan/plan_drawing.h"
#include "runtime/path/building/building_map.h"
#include "runtime/path/offset/offset_curve.h"
#include "runtime/path/route.h"

namespace docent::command {
namespace {

struct ShowOptions {
  std::string database, output, floor;
  std::vector<std::string> layers{"walls",    "regions",     "grid",
                                  "skeleton", "connections", "exhibits"};
};

[[noreturn]] void refuse_layer(std::string_view layer, const std::string& why) {
  throw content::ContentError(
      Errc::WrongUsage, "--layers", "unknown-layer", fmt::format("'{}': {}", layer, why),
      "layers are walls, exhibits, sites, regions, skeleton, clearance, grid, "
      "connections, offset=METRES and route=EXHIBIT:EXHIBIT:KIND, with commas between");
}

/// Turns the words of --layers into what is drawn on some floors.
class LayerReader {
 public:
  LayerReader(const Museum& museum, const std::vector<std::uint32_t>& shown) : museum_(museum) {
    for (const std::uint32_t floor : shown) floors.push_back({floor, {}});
    for (const Floor& floor : museum.floors) maps_.push_back(path::make_floor_map(floor));
  }

  void read(const std::string& layer) {
    if (layer == "walls")
      layers.walls = true;
    else if (layer == "exhibits")
      layers.exhibits = true;
    else if (layer == "sites")
      layers.sites = true;
    else if (layer == "regions")
      layers.regions = true;
    else if (layer == "skeleton")
      layers.skeleton = true;
    else if (layer == "grid")
      layers.grid = true;
    else if (layer == "connections")
      layers.connections = true;
    else if (layer == "clearance")
      add_levels();
    else if (layer.starts_with("offset="))
      add_offset(layer);
    else if (layer.starts_with("route="))
      add_route(layer);
    else
      refuse_layer(layer, "there is no such layer");
  }

  draw::PlanLayers layers;
  std::vector<draw::DrawnFloor> floors;

 private:
  void add_curve(draw::DrawnFloor& on, double distance, std::optional<RouteKind> kind) {
    for (path::OffsetRing& ring : path::offset_curve(*maps_[on.floor], distance).rings)
      on.lines.push_back({kind, std::move(ring.points), true, distance});
  }

  /// Lines of equal clearance, at most twenty of them.
  void add_levels() {
    for (draw::DrawnFloor& on : floors) {
      const auto& clearance = museum_.floors[on.floor].diagram.clearance;
      const double widest = clearance.empty() ? 0 : *std::ranges::max_element(clearance);
      double step = 0.25;
      while (widest > 20 * step) step *= 2;
      for (int i = 1; i * step < widest; ++i) add_curve(on, i * step, {});
    }
  }

  void add_offset(const std::string& layer) {
    const std::optional<double> distance =
        terminal::finite_number(std::string_view(layer).substr(layer.find('=') + 1));
    if (!distance || *distance <= 0)
      refuse_layer(layer, "an offset is a number of metres above zero");
    for (draw::DrawnFloor& on : floors) add_curve(on, *distance, RouteKind::Offset);
  }

  [[nodiscard]] const Exhibit& exhibit(const std::string& layer, std::string_view id) const {
    const auto found = std::ranges::find(museum_.exhibits, id, &Exhibit::id);
    if (found == museum_.exhibits.end())
      refuse_layer(layer, fmt::format("there is no exhibit '{}'", id));
    if (std::ranges::find(floors, found->floor, &draw::DrawnFloor::floor) == floors.end())
      refuse_layer(layer, fmt::format("exhibit '{}' is on another floor", id));
    return *found;
  }

  /// The pieces of a way along the floors that are drawn.
  void add_legs(const path::BuildingWay& way, RouteKind kind) {
    for (const path::Leg& leg : way.legs)
      for (draw::DrawnFloor& on : floors)
        if (leg.is_along_floor() && leg.floor == on.floor)
          on.lines.push_back({kind, leg.points, false, 0});
  }

  void add_route(const std::string& layer) {
    const std::vector<std::string_view> words =
        terminal::split(std::string_view(layer).substr(layer.find('=') + 1), ':');
    if (words.size() != 3) refuse_layer(layer, "a route is written EXHIBIT:EXHIBIT:KIND");
    path::RouteQuery query{.radius = museum_.body_radius};
    const Exhibit &from = exhibit(layer, words[0]), &to = exhibit(layer, words[1]);
    query.from = from.viewing_point.position;
    query.to = to.viewing_point.position;
    const auto info = std::ranges::find(route_kinds, words[2], &RouteKindInfo::name);
    if (info == route_kinds.end())
      refuse_layer(
          layer,
          fmt::format("the kind of a route is one of: {}",
                      fmt::join(route_kinds | std::views::transform(&RouteKindInfo::name), ", ")));
    query.kind = info->kind;
    const path::BuildingMap building(museum_, maps_);
    const path::BuildingWay way = building.route({.way = query,
                                                  .from_floor = from.floor,
                                                  .to_floor = to.floor,
                                                  .metric = metric_between(from, to)});
    if (way.status != path::BuildingStatus::Ok)
      throw content::ContentError(
          "--layers", 0, 0, "no-route",
          fmt::format("there is no {} way from '{}' to '{}'", words[2], words[0], words[1]));
    add_legs(way, info->kind);
  }

  /// Across floors the quickest, as the guide goes.
  static std::optional<path::Metric> metric_between(const Exhibit& from, const Exhibit& to) {
    return from.floor == to.floor ? std::nullopt : std::optional(path::Metric::Time);
  }

  const Museum& museum_;
  std::vector<std::shared_ptr<const path::FloorMap>> maps_;
};

/// The one that is named; else all, from the lowest up.
std::vector<std::uint32_t> floors_shown(const Museum& museum, const std::string& name) {
  if (!name.empty()) return {floor_named(museum, name)};
  std::vector<std::uint32_t> floors(museum.floors.size());
  std::iota(floors.begin(), floors.end(), 0U);
  std::ranges::stable_sort(floors, {},
                           [&](std::uint32_t floor) { return museum.floors[floor].plan.ordinal; });
  return floors;
}

void run_show(const ShowOptions& options) {
  const Stopwatch stopwatch;
  const Museum museum = load_or_throw(options.database);
  LayerReader reader(museum, floors_shown(museum, options.floor));
  for (const std::string& layer : options.layers) reader.read(layer);
  const std::string drawing = reader.floors.size() == 1
                                  ? draw::draw_plan(museum, reader.floors.front().floor,
                                                    reader.layers, reader.floors.front().lines)
                                  : draw::draw_building(museum, reader.floors, reader.layers);
  draw::write_picture(options.output, drawing);
  stopwatch.say_wrote(options.output);
}

}  // namespace

terminal::Command show_command() {
  using terminal::Times;
  auto options = std::make_shared<ShowOptions>();
  return {
      .name = "show",
      .manual = "draws what a database knows about its floors",
      .options =
          {
              {"DB", terminal::file("DB", options->database), "The museum's database", Times::Once},
              {"-o,--output", terminal::file("FILE", options->output),
               "The picture: FILE.svg or FILE.png", Times::Once},
              {"--layers", terminal::list("NAME,...", options->layers),
               "walls, exhibits, sites, regions, skeleton, clearance, grid, connections, offset=D, "
               "route=A:B:KIND",
               Times::AnyNumber, "walls,regions,grid,skeleton,connections,exhibits"},
              {"--floor", terminal::text("NAME", options->floor), "Name of the only floor to draw",
               Times::AtMostOnce, "all, side by side"},
          },
      .run = [options] {
        run_show(*options);
        return 0;
      }};
}

}  // namespace docent::command
