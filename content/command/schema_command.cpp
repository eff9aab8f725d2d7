#include <fmt/core.h>

#include <CLI/CLI.hpp>

#include "config/museum_config.h"
#include "content/command/commands.h"

namespace docent::command {

void add_schema_command(CLI::App& app, int& exit_code) {
  app.add_subcommand("schema", "Print the JSON Schema of a museum's files, for editors")
      ->callback([&exit_code] {
        fmt::print("{}", config::museum_schema());
        exit_code = 0;
      });
}

}  // namespace docent::command
