#include "content/compiler/compile.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <numbers>
#include <thread>

#include "config/museum_config.h"
#include "content/compiler/compile_exhibits.h"
#include "content/compiler/compile_floor.h"
#include "content/compiler/shipped_files.h"
#include "content/content_error.h"

namespace docent {

namespace {

namespace fs = std::filesystem;

/// Runs a step; what it throws goes into the report.
bool attempt(Report& report, const std::function<void()>& step) {
  try {
    step();
    return true;
  } catch (const ContentError& error) {
    if (exit_code(error.kind) != exit_code(Errc::InvalidInput)) throw;
    report.add(to_diagnostic(error));
    return false;
  }
}

/// 0, the body's radius and those asked for, ascending.
std::vector<double> radius_classes(double body_radius, const std::vector<double>& asked) {
  std::vector<double> radii = asked;
  radii.insert(radii.end(), {0, body_radius});
  std::ranges::sort(radii);
  const auto repeated = std::ranges::unique(radii);
  radii.erase(repeated.begin(), repeated.end());
  return radii;
}

/// The museum's most open place, where a kiosk stands that nobody placed: the roadmap's widest
/// node.
Placement most_open_place(const Floor& floor) {
  const auto& clearance = floor.roadmap.clearance;
  const auto widest = std::ranges::max_element(clearance);
  if (widest == clearance.end()) return {};
  const auto node = static_cast<std::size_t>(widest - clearance.begin());
  return {floor.roadmap.position[node], std::numbers::pi / 2};
}

/// Adds the interface's words in a language, from the museum's own file or else the shipped one.
void add_language(const std::string& tag, const WordsFile* own, Museum& museum, Report& report) {
  Language language;
  language.tag = language.name = tag;
  Loaded<WordsFile> shipped;
  if (own == nullptr) {
    shipped = load_words(shipped_words(tag), tag);
    if (!shipped.value) {
      Diagnostic missing;
      missing.file = "words/" + tag + ".toml";
      missing.code = "missing-translation";
      missing.message = fmt::format("there are no words of the interface in '{}'", tag);
      missing.hint = "write this file in the museum's folder, with the keys of another language";
      report.add(std::move(missing));
      return;
    }
    own = &*shipped.value;
  }
  if (!own->name.value.empty()) language.name = own->name.value;
  language.right_to_left = own->direction.value == "right-to-left";
  for (const auto& [key, word] : own->words.value) language.words[key] = word.value;
  museum.languages.push_back(std::move(language));
}

/// Floors as GeoJSON files alone: a museum without exhibits.
class PlanCompiler {
 public:
  PlanCompiler(const CompileOptions& options, Report& report, Progress& progress)
      : options_(options), report_(report), progress_(progress) {}

  void run(Museum& museum) {
    const std::string name = fs::path(options_.sources.front()).stem().string();
    plan_floor_stages(progress_, name);
    report_.set_file_order(options_.sources);
    museum.title["en"] = name;
    add_language("en", nullptr, museum, report_);
    attempt(report_, [&] {
      CompiledFloor compiled =
          compile_floor(name, options_.sources, options_.coordinates,
                        radius_classes(museum.body_radius, options_.radii), report_, progress_);
      museum.floors.push_back(std::move(compiled.floor));
      museum.kiosk = most_open_place(museum.floors.front());
      museum.scenery.emplace_back();
    });
  }

 private:
  const CompileOptions& options_;
  Report& report_;
  Progress& progress_;
};

/// A museum's folder.
class FolderCompiler {
 public:
  FolderCompiler(const CompileOptions& options, Report& report, Progress& progress)
      : options_(options), report_(report), progress_(progress) {}

  void run(Museum& museum) {
    Loaded<MuseumConfig> loaded = load_museum_config(options_.sources.front());
    report_.add(loaded.diagnostics);
    if (!loaded.value) return;
    const MuseumConfig& config = *loaded.value;
    report_.set_file_order(config.files);
    for (const FloorSection& floor : config.floors) plan_floor_stages(progress_, floor.name.value);
    progress_.plan("exhibits", 3);
    take_texts(config, museum);
    museum.body_radius = config.avatar.radius.value;
    museum.ambient_count = static_cast<std::uint32_t>(config.ambient.count.value);
    const std::vector<CompiledFloor> floors = compile_floors(config, museum);
    const auto stage = progress_.start("exhibits");
    compile_exhibits(config, floors, museum, report_);
    for (std::size_t i = 0; i < museum.floors.size(); ++i) museum.scenery.emplace_back();
  }

 private:
  void take_texts(const MuseumConfig& config, Museum& museum) {
    museum.title = plain_texts(config.museum.title.value);
    museum.welcome = plain_texts(config.museum.welcome.value);
    if (museum.title.empty())
      for (const std::string& tag : config.languages)
        museum.title[tag] = fs::absolute(config.folder).filename().string();
    for (const std::string& tag : config.languages) {
      const auto own = std::ranges::find(config.words, tag, &WordsFile::tag);
      add_language(tag, own == config.words.end() ? nullptr : &*own, museum, report_);
    }
  }

  /// Compiles every floor whose plan can be used; the others stay empty, and are in the report.
  std::vector<CompiledFloor> compile_floors(const MuseumConfig& config, Museum& museum) {
    const std::vector<double> radii = radius_classes(museum.body_radius, options_.radii);
    std::vector<CompiledFloor> floors(config.floors.size());
    museum.floors.resize(floors.size());
    for (std::size_t i = 0; i < floors.size(); ++i) {
      const FloorSection& section = config.floors[i];
      const std::string file = (config.folder / section.plan.value).string();
      if (!section.plan.given || !fs::exists(file)) continue;  // already reported
      attempt(report_, [&] {
        floors[i] = compile_floor(section.name.value, std::span(&file, 1), options_.coordinates,
                                  radii, report_, progress_);
      });
      floors[i].floor.plan.height = section.height.value;
      museum.floors[i] = floors[i].floor;
    }
    return floors;
  }

  const CompileOptions& options_;
  Report& report_;
  Progress& progress_;
};

bool is_museum_folder(const CompileOptions& options) {
  return options.sources.size() == 1 && fs::is_directory(options.sources.front());
}

}  // namespace

std::optional<Museum> compile(const CompileOptions& options, Report& report, Progress& progress) {
  Museum museum;
  if (is_museum_folder(options))
    FolderCompiler(options, report, progress).run(museum);
  else
    PlanCompiler(options, report, progress).run(museum);
  if (report.has_errors()) return {};
  return museum;
}

}  // namespace docent
