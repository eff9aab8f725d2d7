#include <fmt/format.h>

#include <CLI/CLI.hpp>
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

void add_offset_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<OffsetOptions>();
  CLI::App* command =
      app.add_subcommand("offset", "The curve at one distance from all walls of a floor");
  command->add_option("DB", options->database, "The museum's database")->required();
  command->add_option("--distance", options->distance, "Metres")
      ->required()
      ->check(CLI::NonNegativeNumber);
  command->add_option("--floor", options->floor, "Name of the floor; default the kiosk's");
  command->add_flag("--json", options->json, "Print the curve as JSON");
  command->add_option("--svg", options->svg, "Draw the curve into this file");
  command->callback([options, &exit_code] {
    run_offset(*options);
    exit_code = 0;
  });
}

}  // namespace docent::command
