#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "content/command/commands.h"
#include "content/command/open_museum.h"
#include "content/command/query_io.h"
#include "runtime/path/route.h"

namespace docent::command {
namespace {

struct AtOptions {
  std::string database, points, output, floor;
};

void run_at(const AtOptions& options) {
  const Museum museum = load_or_throw(options.database);
  const auto map = path::make_floor_map(museum.floors[floor_named(museum, options.floor)]);
  const NumberTable table = read_numbers(options.points, {"x", "y"});
  std::string text = "x,y,inside,clearance,region\n";
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const Vec2 point{table.rows[i][0], table.rows[i][1]};
    text += fmt::format("{},{},{},{}\n", table.written[i], path::is_inside(*map, point) ? 1 : 0,
                        path::clearance_at(*map, point), path::region_at(*map, point));
  }
  write_text(options.output, text);
}

}  // namespace

void add_at_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<AtOptions>();
  CLI::App* command =
      app.add_subcommand("at", "Tells of points: inside or not, distance to the wall, region");
  command->add_option("DB", options->database, "The museum's database")->required();
  command->add_option("--points", options->points, "CSV file x,y")->required();
  command->add_option("-o,--output", options->output, "CSV file for the answers")->required();
  command->add_option("--floor", options->floor, "Name of the floor; default the kiosk's");
  command->callback([options, &exit_code] {
    run_at(*options);
    exit_code = 0;
  });
}

}  // namespace docent::command
