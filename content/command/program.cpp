#include "content/command/commands.h"

namespace docent::command {

terminal::Command program() {
  return {.name = "docent-content",
          .manual = "compiles a museum for docent's kiosks and answers questions about the result",
          .commands = {compile_command(), check_command(),  import_command(), translate_command(),
                       info_command(),    schema_command(), route_command(),  tour_command(),
                       at_command(),      see_command(),    near_command(),   offset_command(),
                       show_command(),    graph_command(),  figure_command(), walk_command(),
                       film_command(),    keygen_command(), sign_command(),   verify_command(),
                       release_command()},
          .sections = {terminal::exit_codes()}};
}

}  // namespace docent::command
