#include <fmt/format.h>

#include <chrono>
#include <memory>

#include "content/command/commands.h"
#include "content/command/open_museum.h"
#include "content/command/query_io.h"
#include "content/command/stopwatch.h"
#include "runtime/path/route.h"

namespace docent::command {
namespace {

struct SeeOptions {
  std::string database, pairs, output, floor;
};

void run_see(const SeeOptions& options) {
  const Stopwatch stopwatch;
  const Museum museum = load_or_throw(options.database);
  const auto map = path::make_floor_map(museum.floors[floor_named(museum, options.floor)]);
  const NumberTable table = read_numbers(options.pairs, {{"x0"}, {"y0"}, {"x1"}, {"y1"}});
  std::string text = "x0,y0,x1,y1,visible,microseconds\n";
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const auto& row = table.rows[i];
    const auto start = std::chrono::steady_clock::now();
    const bool visible = path::can_see(*map, {row[0], row[1]}, {row[2], row[3]});
    const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - start;
    text += fmt::format("{},{},{:.3f}\n", table.written[i], visible ? 1 : 0, took.count());
  }
  write_text(options.output, text);
  stopwatch.say_wrote(options.output);
}

}  // namespace

terminal::Command see_command() {
  using terminal::Times;
  auto options = std::make_shared<SeeOptions>();
  return {
      .name = "see",
      .manual = "tells whether points see each other",
      .options =
          {
              {"DB", terminal::file("DB", options->database), "The museum's database", Times::Once},
              {"--pairs", terminal::file("Q.csv", options->pairs),
               "Columns x0,y0,x1,y1: pairs of points", Times::Once},
              {"-o,--output", terminal::file("A.csv", options->output),
               "The pairs with visible and microseconds", Times::Once},
              {"--floor", terminal::text("NAME", options->floor), "Name of the floor",
               Times::AtMostOnce, "the kiosk's"},
          },
      .run = [options] {
        run_see(*options);
        return 0;
      }};
}

}  // namespace docent::command
