#include <fmt/format.h>

#include <memory>

#include "content/command/commands.h"
#include "content/command/open_museum.h"
#include "content/command/plan_sketch.h"
#include "content/command/query_io.h"
#include "runtime/path/offset/offset_curve.h"
#include "runtime/path/route.h"

namespace docent::command {
namespace {

struct OffsetOptions {
  std::string database, floor, svg;
  double distance = 0;
  bool json = false;
};

std::string to_json(const path::OffsetCurve& curve) {
  std::string rings;
  for (const path::OffsetRing& ring : curve.rings)
    rings += (rings.empty() ? "" : ", ") + json_points(ring.points);
  return fmt::format(
      R"({{"components": {}, "holes": {}, "area": {}, "perimeter": {}, "rings": [{}]}})",
      curve.components, curve.holes, json_number(curve.area), json_number(curve.perimeter), rings);
}

void run_offset(const OffsetOptions& options) {
  const Museum museum = load_or_throw(options.database);
  const Floor& floor = museum.floors[floor_named(museum, options.floor)];
  const path::OffsetCurve curve = path::offset_curve(path::MedialAxisMap(floor), options.distance);
  if (!options.svg.empty()) {
    std::vector<SketchLine> lines;
    lines.reserve(curve.rings.size());
    for (const path::OffsetRing& ring : curve.rings) lines.push_back({ring.points, true});
    write_text(options.svg, sketch_plan(floor.plan, lines));
  }
  if (options.json)
    fmt::print("{}\n", to_json(curve));
  else
    fmt::print("{} parts with {} holes, {:.3f} m2, {:.3f} m around\n", curve.components,
               curve.holes, curve.area, curve.perimeter);
}

}  // namespace

terminal::Command offset_command() {
  using terminal::Times;
  auto options = std::make_shared<OffsetOptions>();
  return {
      .name = "offset",
      .manual = "gives the curve at one distance from all walls of a floor",
      .options =
          {
              {"DB", terminal::file("DB", options->database), "The museum's database", Times::Once},
              {"--distance", terminal::number("D", terminal::not_negative, options->distance),
               "Metres from the walls", Times::Once},
              {"--floor", terminal::text("NAME", options->floor), "Name of the floor",
               Times::AtMostOnce, "the kiosk's"},
              {"--json", terminal::flag(options->json), "Print the curve as JSON"},
              {"--svg", terminal::file("FILE", options->svg), "Draw the curve into this file"},
          },
      .run = [options] {
        run_offset(*options);
        return 0;
      }};
}

}  // namespace docent::command
