#include <fmt/format.h>

#include <algorithm>
#include <memory>
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
#include "runtime/path/offset/offset_curve.h"
#include "runtime/path/route.h"

namespace docent::command {
namespace {

struct ShowOptions {
  std::string database, output, floor;
  std::vector<std::string> layers{"walls", "regions", "skeleton", "exhibits"};
};

[[noreturn]] void refuse_layer(std::string_view layer, const std::string& why) {
  throw content::ContentError(Errc::WrongUsage, "--layers", "unknown-layer",
                              fmt::format("'{}': {}", layer, why),
                              "layers are walls, exhibits, sites, regions, skeleton, clearance, "
                              "offset=METRES and route=EXHIBIT:EXHIBIT:KIND, with commas between");
}

/// Turns the words of --layers into what is drawn.
class LayerReader {
 public:
  LayerReader(const Museum& museum, std::uint32_t floor)
      : museum_(museum), floor_(floor), map_(path::make_floor_map(museum.floors[floor])) {}

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
  std::vector<draw::DrawnLine> lines;

 private:
  void add_curve(double distance, std::optional<RouteKind> kind) {
    for (path::OffsetRing& ring : path::offset_curve(*map_, distance).rings)
      lines.push_back({kind, std::move(ring.points), true, distance});
  }

  /// Lines of equal clearance, at most twenty of them.
  void add_levels() {
    const auto& clearance = museum_.floors[floor_].diagram.clearance;
    const double widest = clearance.empty() ? 0 : *std::ranges::max_element(clearance);
    double step = 0.25;
    while (widest > 20 * step) step *= 2;
    for (int i = 1; i * step < widest; ++i) add_curve(i * step, {});
  }

  void add_offset(const std::string& layer) {
    const std::optional<double> distance =
        terminal::finite_number(std::string_view(layer).substr(layer.find('=') + 1));
    if (!distance || *distance <= 0)
      refuse_layer(layer, "an offset is a number of metres above zero");
    add_curve(*distance, RouteKind::Offset);
  }

  [[nodiscard]] Vec2 viewing_point(const std::string& layer, std::string_view id) const {
    const auto found = std::ranges::find(museum_.exhibits, id, &Exhibit::id);
    if (found == museum_.exhibits.end())
      refuse_layer(layer, fmt::format("there is no exhibit '{}'", id));
    if (found->floor != floor_)
      refuse_layer(layer, fmt::format("exhibit '{}' is on another floor", id));
    return found->viewing_point.position;
  }

  void add_route(const std::string& layer) {
    const std::vector<std::string_view> words =
        terminal::split(std::string_view(layer).substr(layer.find('=') + 1), ':');
    if (words.size() != 3) refuse_layer(layer, "a route is written EXHIBIT:EXHIBIT:KIND");
    path::RouteQuery query{.radius = museum_.body_radius};
    query.from = viewing_point(layer, words[0]);
    query.to = viewing_point(layer, words[1]);
    const auto info = std::ranges::find(route_kinds, words[2], &RouteKindInfo::name);
    if (info == route_kinds.end())
      refuse_layer(
          layer,
          fmt::format("the kind of a route is one of: {}",
                      fmt::join(route_kinds | std::views::transform(&RouteKindInfo::name), ", ")));
    query.kind = info->kind;
    path::Way way = path::route(*map_, query);
    if (way.status != path::RouteStatus::Ok)
      throw content::ContentError(
          "--layers", 0, 0, "no-route",
          fmt::format("there is no {} way from '{}' to '{}'", words[2], words[0], words[1]));
    lines.push_back({info->kind, std::move(way.points), false, 0});
  }

  const Museum& museum_;
  std::uint32_t floor_;
  std::shared_ptr<const path::FloorMap> map_;
};

void run_show(const ShowOptions& options) {
  const Stopwatch stopwatch;
  const Museum museum = load_or_throw(options.database);
  const std::uint32_t floor = floor_named(museum, options.floor);
  LayerReader reader(museum, floor);
  for (const std::string& layer : options.layers) reader.read(layer);
  draw::write_picture(options.output, draw::draw_plan(museum, floor, reader.layers, reader.lines));
  stopwatch.say_wrote(options.output);
}

}  // namespace

terminal::Command show_command() {
  using terminal::Times;
  auto options = std::make_shared<ShowOptions>();
  return {
      .name = "show",
      .manual = "draws what a database knows about a floor",
      .options =
          {
              {"DB", terminal::file("DB", options->database), "The museum's database", Times::Once},
              {"-o,--output", terminal::file("FILE", options->output),
               "The picture: FILE.svg or FILE.png", Times::Once},
              {"--layers", terminal::list("NAME,...", options->layers),
               "walls, exhibits, sites, regions, skeleton, clearance, offset=D, route=A:B:KIND",
               Times::AnyNumber, "walls,regions,skeleton,exhibits"},
              {"--floor", terminal::text("NAME", options->floor), "Name of the floor",
               Times::AtMostOnce, "the kiosk's"},
          },
      .run = [options] {
        run_show(*options);
        return 0;
      }};
}

}  // namespace docent::command
