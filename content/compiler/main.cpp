#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "config/diagnostic_text.h"
#include "content/compiler/commands.h"
#include "content/content_error.h"

namespace {

int report(const docent::ContentError& error) {
  fmt::print(stderr, "{}", docent::to_text(docent::to_diagnostic(error)));
  return docent::exit_code(error.kind);
}

int run(int argc, char** argv) {
  CLI::App app{"Compiles a museum for docent's kiosks and answers questions about the result."};
  app.name("docent-content");
  app.require_subcommand(1);
  int exit_code = 0;  // Each command below sets it when it runs.
  docent::add_compile_command(app, exit_code);
  docent::add_check_command(app, exit_code);
  docent::add_info_command(app, exit_code);
  docent::add_route_command(app, exit_code);
  docent::add_at_command(app, exit_code);
  docent::add_see_command(app, exit_code);
  docent::add_offset_command(app, exit_code);
  docent::add_show_command(app, exit_code);
  docent::add_graph_command(app, exit_code);
  docent::add_walk_command(app, exit_code);
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
  } catch (const docent::ContentError& error) {
    return report(error);
  } catch (const std::exception& error) {
    fmt::print(stderr, "docent-content: {}\n", error.what());
    return docent::exit_code(docent::Errc::Environment);
  }
}
