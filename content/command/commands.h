#pragma once

namespace CLI {
class App;
}

/// The commands of docent-content, one file each. A command adds itself and its options to `app`;
/// when it is the one that was called, it runs and leaves its exit code in `exit_code`. What it
/// throws is reported by main.
namespace docent::command {

void add_compile_command(CLI::App& app, int& exit_code);
void add_check_command(CLI::App& app, int& exit_code);
void add_info_command(CLI::App& app, int& exit_code);
void add_schema_command(CLI::App& app, int& exit_code);
void add_route_command(CLI::App& app, int& exit_code);
void add_at_command(CLI::App& app, int& exit_code);
void add_see_command(CLI::App& app, int& exit_code);
void add_near_command(CLI::App& app, int& exit_code);
void add_offset_command(CLI::App& app, int& exit_code);
void add_show_command(CLI::App& app, int& exit_code);
void add_graph_command(CLI::App& app, int& exit_code);
void add_walk_command(CLI::App& app, int& exit_code);

}  // namespace docent::command
