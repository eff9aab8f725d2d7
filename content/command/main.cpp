#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <span>
#include <string_view>

#include "config/diagnostic_text.h"
#include "content/command/commands.h"
#include "content/content_error.h"

namespace {

/// Did the user ask for JSON? Known before the command line is understood, so that every failure is
/// told as asked.
bool wants_json(std::span<char*> arguments) {
  return std::ranges::any_of(
      arguments, [](const char* argument) { return std::string_view(argument) == "--json"; });
}

int report(const docent::content::ContentError& error, bool as_json) {
  const docent::Diagnostic diagnostic = docent::content::to_diagnostic(error);
  fmt::print(
      stderr, "{}",
      as_json ? docent::config::to_json(diagnostic) + "\n" : docent::config::to_text(diagnostic));
  return docent::exit_code(error.kind);
}

int run(int argc, char** argv) {
  CLI::App app{"Compiles a museum for docent's kiosks and answers questions about the result."};
  app.name("docent-content");
  app.require_subcommand(1);
  int exit_code = 0;  // Each command below sets it when it runs.
  docent::command::add_compile_command(app, exit_code);
  docent::command::add_check_command(app, exit_code);
  docent::command::add_info_command(app, exit_code);
  docent::command::add_schema_command(app, exit_code);
  docent::command::add_route_command(app, exit_code);
  docent::command::add_at_command(app, exit_code);
  docent::command::add_see_command(app, exit_code);
  docent::command::add_near_command(app, exit_code);
  docent::command::add_offset_command(app, exit_code);
  docent::command::add_show_command(app, exit_code);
  docent::command::add_graph_command(app, exit_code);
  docent::command::add_walk_command(app, exit_code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const bool asked_for_help = app.exit(error) == 0;
    return asked_for_help ? 0 : docent::exit_code(docent::Errc::WrongUsage);
  }
  return exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const docent::content::ContentError& error) {
    return report(error, wants_json(std::span(argv, static_cast<std::size_t>(argc))));
  } catch (const std::exception& error) {
    fmt::print(stderr, "docent-content: {}\n", error.what());
    return docent::exit_code(docent::Errc::Environment);
  }
}
