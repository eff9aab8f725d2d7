#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "content/command/commands.h"
#include "content/command/part_sizes.h"
#include "content/compile/compile.h"
#include "content/content_error.h"
#include "content/write/content_writer.h"
#include "platform/file/read_file.h"
#include "runtime/model/result.h"

namespace docent::command {

namespace {

/// What the user asked for.
struct CompileRequest {
  compile::CompileOptions options;
  std::string output;
  bool no_motion = false, json = false, quiet = false;
};

/// Options that `check` shares with `compile`.
void add_source_options(CLI::App& command, CompileRequest& request) {
  compile::CompileOptions& options = request.options;
  command.add_option("SOURCE", options.sources, "A museum folder, or GeoJSON files of one floor")
      ->required();
  command.add_option("--clips", options.clips, "Walk with the BVH or ASF/AMC files of this folder")
      ->allow_extra_args(false);
  command.add_flag("--mirrored,!--no-mirrored", options.enrichment.mirrored,
                   "Add clips seen in a mirror where they bring something new");
  command.add_flag("--turns,!--no-turns", options.enrichment.turns,
                   "Add turns by angles between those of the clips");
  command.add_option("--coordinates", options.coordinates, "What GeoJSON numbers mean")
      ->transform(CLI::CheckedTransformer(std::map<std::string, import::Coordinates>{
          {"metres", import::Coordinates::Metres}, {"wgs84", import::Coordinates::Wgs84}}));
  command.add_option("--radius", options.radii, "A radius to precompute shortest ways for, metres")
      ->allow_extra_args(false)
      ->check(CLI::Range(0.0, 100.0));
  command.add_flag("--no-motion", request.no_motion, "Leave out clips, motion graph and avatar");
  command.add_option("--jobs", options.jobs, "Threads")->check(CLI::Range(1U, 1024U));
  command.add_flag("--json", request.json, "Problems and stages as JSON");
  command.add_flag("--quiet", request.quiet, "No progress");
}

/// A museum's folder is a whole museum; floor plans beside it would belong to none.
void check_sources(const std::vector<std::string>& sources) {
  const auto folder = std::ranges::find_if(sources, file::is_folder);
  if (sources.size() > 1 && folder != sources.end())
    throw content::ContentError(
        Errc::WrongUsage, *folder, "folder-among-sources",
        "this folder is named beside other sources",
        "name one museum's folder alone, or GeoJSON files that make one floor");
}

/// Compiles and reports; empty where the sources have errors.
std::optional<Museum> compile_and_report(CompileRequest& request, compile::Progress& progress) {
  check_sources(request.options.sources);
  request.options.with_motion = !request.no_motion;
  if (request.options.jobs == 0)
    request.options.jobs = std::max(1U, std::thread::hardware_concurrency());
  compile::Report report;
  std::optional<Museum> museum = compile::compile(request.options, report, progress);
  report.print(request.json ? compile::Report::Form::Json : compile::Report::Form::Text);
  return museum;
}

/// What `--json` tells at the end: where the time went, and the bytes.
void print_stages(const compile::Progress& progress, const std::string& output) {
  const PartSizes sizes = part_sizes(output);
  nlohmann::ordered_json stages = nlohmann::ordered_json::array();
  for (const compile::Progress::Stage& stage : progress.stages()) {
    const auto made =
        std::ranges::find(sizes.stages, stage.name, [](const auto& entry) { return entry.first; });
    stages.push_back({{"stage", stage.name},
                      {"seconds", stage.seconds},
                      {"bytes", made == sizes.stages.end() ? 0 : made->second}});
  }
  const nlohmann::ordered_json summary = {
      {"stages", stages}, {"seconds", progress.seconds()}, {"bytes", sizes.file}};
  fmt::print("{}\n", summary.dump());
}

int run_compile(CompileRequest& request) {
  compile::Progress progress(compile::progress_output(request.quiet));
  const std::optional<Museum> museum = compile_and_report(request, progress);
  if (!museum) return docent::exit_code(Errc::InvalidInput);
  {
    progress.plan("write", 1);
    const auto stage = progress.start("write");
    write::write_museum(*museum, request.output);
  }
  if (request.json) print_stages(progress, request.output);
  return 0;
}

int run_check(CompileRequest& request) {
  compile::Progress progress(compile::progress_output(request.quiet));
  return compile_and_report(request, progress) ? 0 : docent::exit_code(Errc::InvalidInput);
}

}  // namespace

void add_compile_command(CLI::App& app, int& exit_code) {
  const auto request = std::make_shared<CompileRequest>();
  CLI::App* command = app.add_subcommand("compile", "Compile a museum into a database");
  add_source_options(*command, *request);
  command->add_option("-o,--output", request->output, "The database to write")->required();
  command->callback([request, &exit_code] { exit_code = run_compile(*request); });
}

void add_check_command(CLI::App& app, int& exit_code) {
  const auto request = std::make_shared<CompileRequest>();
  CLI::App* command = app.add_subcommand("check", "Report what compile would, and write nothing");
  add_source_options(*command, *request);
  command->callback([request, &exit_code] { exit_code = run_check(*request); });
}

}  // namespace docent::command
