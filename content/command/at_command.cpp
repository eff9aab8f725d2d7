#include <fmt/format.h>

#include <memory>

#include "content/command/commands.h"
#include "content/command/open_museum.h"
#include "content/command/query_io.h"
#include "content/command/stopwatch.h"
#include "runtime/path/route.h"

namespace docent::command {
namespace {

struct AtOptions {
  std::string database, points, output, floor;
};

void run_at(const AtOptions& options) {
  const Stopwatch stopwatch;
  const Museum museum = load_or_throw(options.database);
  const auto map = path::make_floor_map(museum.floors[floor_named(museum, options.floor)]);
  const NumberTable table = read_numbers(options.points, {{"x"}, {"y"}});
  std::string text = "x,y,inside,clearance,region\n";
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const Vec2 point{table.rows[i][0], table.rows[i][1]};
    text += fmt::format("{},{},{},{}\n", table.written[i], path::is_inside(*map, point) ? 1 : 0,
                        path::clearance_at(*map, point), path::region_at(*map, point));
  }
  write_text(options.output, text);
  stopwatch.say_wrote(options.output);
}

}  // namespace

terminal::Command at_command() {
  using terminal::Times;
  auto options = std::make_shared<AtOptions>();
  return {
      .name = "at",
      .manual = "tells of points: inside or not, distance to the wall, region",
      .options =
          {
              {"DB", terminal::file("DB", options->database), "The museum's database", Times::Once},
              {"--points", terminal::file("P.csv", options->points), "Columns x,y: the points",
               Times::Once},
              {"-o,--output", terminal::file("A.csv", options->output),
               "The points with inside, clearance and region", Times::Once},
              {"--floor", terminal::text("NAME", options->floor), "Name of the floor",
               Times::AtMostOnce, "the kiosk's"},
          },
      .run = [options] {
        run_at(*options);
        return 0;
      }};
}

}  // namespace docent::command
