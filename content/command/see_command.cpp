#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>

#include "content/command/commands.h"
#include "content/command/open_museum.h"
#include "content/command/query_io.h"
#include "runtime/path/route.h"

namespace docent::command {
namespace {

struct SeeOptions {
  std::string database, pairs, output, floor;
};

void run_see(const SeeOptions& options) {
  const Museum museum = load_or_throw(options.database);
  const auto map = path::make_floor_map(museum.floors[floor_named(museum, options.floor)]);
  const NumberTable table = read_numbers(options.pairs, {"x0", "y0", "x1", "y1"});
  std::string text = "x0,y0,x1,y1,visible,microseconds\n";
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const auto& row = table.rows[i];
    const auto start = std::chrono::steady_clock::now();
    const bool visible = path::can_see(*map, {row[0], row[1]}, {row[2], row[3]});
    const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - start;
    text += fmt::format("{},{},{:.3f}\n", table.written[i], visible ? 1 : 0, took.count());
  }
  write_text(options.output, text);
}

}  // namespace

void add_see_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<SeeOptions>();
  CLI::App* command = app.add_subcommand("see", "Tells whether points see each other");
  command->add_option("DB", options->database, "The museum's database")->required();
  command->add_option("--pairs", options->pairs, "CSV file x0,y0,x1,y1")->required();
  command->add_option("-o,--output", options->output, "CSV file for the answers")->required();
  command->add_option("--floor", options->floor, "Name of the floor; default the kiosk's");
  command->callback([options, &exit_code] {
    run_see(*options);
    exit_code = 0;
  });
}

}  // namespace docent::command
