#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <expected>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "config/diagnostic_text.h"
#include "content/command/commands.h"
#include "content/command/open_museum.h"
#include "content/command/part_sizes.h"
#include "content/command/stopwatch.h"
#include "content/compile/compile.h"
#include "content/compile/found.h"
#include "content/content_error.h"
#include "content/write/content_writer.h"
#include "platform/file/read_file.h"
#include "platform/sqlite/content_reader.h"
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
std::vector<terminal::Option> source_options(CompileRequest& request) {
  using terminal::Times;
  constexpr terminal::Limits threads{terminal::Limits::Of::WholeNumbers, 1, 1024};
  constexpr terminal::Limits radii{.least = 0, .most = 100};
  using import::Coordinates;
  compile::CompileOptions& options = request.options;
  return {
      {"SOURCE", terminal::file("SOURCE", options.sources),
       "A museum's folder, or GeoJSON files that together make one floor", Times::AtLeastOnce},
      {"--clips", terminal::folder("DIR", options.clips),
       "Walk with the BVH or ASF/AMC files of this folder", Times::AnyNumber,
       "the museum's, else those that ship"},
      {"--coordinates",
       terminal::one_of<Coordinates>(
           {{"metres", Coordinates::Metres}, {"wgs84", Coordinates::Wgs84}}, options.coordinates),
       "What the numbers of GeoJSON mean", Times::AtMostOnce, "metres"},
      {"--radius", terminal::number("R", radii, options.radii),
       "Metres: a radius to precompute shortest ways for, besides 0 and the body's",
       Times::AnyNumber},
      {"--no-motion", terminal::flag(request.no_motion),
       "Leave out clips, motion graph and avatar"},
      {"--speech,!--no-speech", terminal::flag(options.with_speech),
       "Make the sound of what is said, with espeak-ng and staff's recordings"},
      {"--mirrored,!--no-mirrored", terminal::flag(options.enrichment.mirrored),
       "Add clips seen in a mirror where they bring something new"},
      {"--turns,!--no-turns", terminal::flag(options.enrichment.turns),
       "Add turns by angles between those of the clips"},
      {"--jobs", terminal::number("N", threads, options.jobs),
       "Threads; the result is the same for any number", Times::AtMostOnce, "all processors"},
      {"--json", terminal::flag(request.json),
       "Problems as JSON, one a line, and no progress; compile also prints seconds and bytes of "
       "each stage"},
      {"--quiet", terminal::flag(request.quiet), "Say nothing but what is wrong"},
  };
}

/// A museum's folder is a whole museum; floor plans beside it would belong to none.
void check_sources(const std::vector<std::string>& sources) {
  for (const std::string& source : sources)
    if (std::filesystem::path(source).extension() == ".toml" && !file::is_folder(source)) {
      const std::string folder = std::filesystem::path(source).parent_path().string();
      throw content::ContentError(
          Errc::WrongUsage, source, "file-of-a-museum", "this is one file of a museum",
          fmt::format("name the museum's folder: {}", folder.empty() ? "." : folder));
    }

  const auto folder = std::ranges::find_if(sources, file::is_folder);
  if (sources.size() > 1 && folder != sources.end())
    throw content::ContentError(
        Errc::WrongUsage, *folder, "folder-among-sources",
        "this folder is named beside other sources",
        "name one museum's folder alone, or GeoJSON files that make one floor");
}

/// Sources and recordings that are not there: told at once, before anything is computed.
std::vector<Diagnostic> missing_sources(const compile::CompileOptions& options) {
  std::vector<Diagnostic> missing;
  std::error_code ignored;
  for (const auto* const names : {&options.sources, &options.clips})
    for (const std::string& name : *names)
      if (!file::is_there(name))
        missing.push_back({.file = name,
                           .code = "missing-source",
                           .message = "there is no such file or folder",
                           .hint = fmt::format("it is looked for from {}: check its name",
                                               std::filesystem::current_path(ignored).string())});
  return missing;
}

config::DiagnosticForm form_of(const CompileRequest& request) {
  return request.json ? config::DiagnosticForm::Json : config::DiagnosticForm::Text;
}

/// Only people are told of progress and success.
bool is_for_people(const CompileRequest& request) {
  return !request.json && !request.quiet;
}

/// Compiles and reports: the museum, or the exit code.
std::expected<Museum, int> compile_and_report(CompileRequest& request, compile::Progress& progress,
                                              compile::Report& report) {
  check_sources(request.options.sources);
  if (const auto missing = missing_sources(request.options); !missing.empty()) {
    config::tell(missing, form_of(request));
    return std::unexpected(docent::exit_code(Errc::NotFound));
  }
  request.options.with_motion = !request.no_motion;
  if (request.options.jobs == 0)
    request.options.jobs = std::max(1U, std::thread::hardware_concurrency());
  std::optional<Museum> museum = compile::compile(request.options, report, progress);
  progress.clear();
  config::tell(report.in_order(), form_of(request));
  if (!museum) return std::unexpected(docent::exit_code(Errc::InvalidInput));
  return std::move(*museum);
}

/// The museum that the output held before; empty where it is none that this docent reads.
std::optional<Museum> museum_before(const std::string& output) {
  if (!file::is_there(output)) return {};
  try {
    return load_or_throw(output);
  } catch (const content::ContentError&) {
    return {};
  }
}

/// What the output said before: its sounds are kept where nothing has changed. None where it is no
/// database of this docent.
std::vector<SpeechSound> speech_before(const std::string& output) {
  if (!file::is_there(output)) return {};
  const auto database = sqlite::open_database(output);
  if (!database) return {};
  return sqlite::read_speech(*database, output).value_or(std::vector<SpeechSound>{});
}

nlohmann::ordered_json found_json(const Museum& museum) {
  nlohmann::ordered_json found;
  for (const auto& [name, count] : compile::found_in(museum)) found[name] = count;
  return found;
}

/// What `--json` tells at the end: what was found, where the time went, and the bytes.
void print_stages(const Museum& museum, const compile::Progress& progress,
                  const std::string& output) {
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
      {"stages", stages},
      {"found", found_json(museum)},
      {"undescribed_pictures", compile::undescribed_pictures(museum)},
      {"seconds", progress.seconds()},
      {"bytes", sizes.file}};
  fmt::print("{}\n", summary.dump());
}

int run_compile(CompileRequest& request) {
  const Stopwatch stopwatch;
  {
    compile::Progress progress(compile::progress_output(!is_for_people(request)));
    compile::Report report;
    if (request.options.with_speech) request.options.speech_before = speech_before(request.output);
    const auto museum = compile_and_report(request, progress, report);
    if (!museum) return museum.error();
    if (is_for_people(request)) {
      const std::optional<Museum> before = museum_before(request.output);
      progress.clear();
      fmt::print(stderr, "found {}\n", compile::found_text(*museum, before ? &*before : nullptr));
    }
    progress.plan("write", 1);
    {
      const auto stage = progress.start("write");
      write::write_museum(*museum, request.output);
    }
    if (request.json) print_stages(*museum, progress, request.output);
  }
  if (is_for_people(request)) stopwatch.say_wrote(request.output);
  return 0;
}

int run_check(CompileRequest& request) {
  compile::Progress progress(compile::progress_output(!is_for_people(request)));
  compile::Report report;
  const auto museum = compile_and_report(request, progress, report);
  if (!museum) return museum.error();
  const std::size_t warnings = report.in_order().size();
  if (is_for_people(request))
    fmt::print(stderr, "{}: no errors, {} warning{}, in {:.1f} s; found {}\n",
               fmt::join(request.options.sources, ", "), warnings, warnings == 1 ? "" : "s",
               progress.seconds(), compile::found_text(*museum, nullptr));
  return 0;
}

}  // namespace

terminal::Command compile_command() {
  const auto request = std::make_shared<CompileRequest>();
  terminal::Command command{.name = "compile",
                            .manual = "compiles a museum into a database",
                            .options = source_options(*request),
                            .run = [request] { return run_compile(*request); }};
  command.options.insert(
      command.options.begin() + 1,
      {"-o,--output", terminal::file("OUT.db", request->output),
       "The database to write; it appears whole or not at all", terminal::Times::Once});
  return command;
}

terminal::Command check_command() {
  const auto request = std::make_shared<CompileRequest>();
  return {.name = "check",
          .manual = "reports what compile would, and writes nothing",
          .options = source_options(*request),
          .run = [request] {
            request->options.only_check = true;
            return run_check(*request);
          }};
}

}  // namespace docent::command
