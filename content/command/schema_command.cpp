#include <fmt/core.h>

#include "config/museum_config.h"
#include "content/command/commands.h"

namespace docent::command {

terminal::Command schema_command() {
  return {.name = "schema",
          .manual = "prints the JSON Schema of a museum's files, for editors",
          .run = [] {
            fmt::print("{}", config::museum_schema());
            return 0;
          }};
}

}  // namespace docent::command
