#include "content/compile/compile.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <future>
#include <optional>
#include <span>

#include "config/museum_config.h"
#include "content/compile/add_collections.h"
#include "content/compile/add_languages.h"
#include "content/compile/compile_avatar.h"
#include "content/compile/compile_captions.h"
#include "content/compile/compile_doors.h"
#include "content/compile/compile_exhibits.h"
#include "content/compile/compile_floor.h"
#include "content/compile/compile_images.h"
#include "content/compile/compile_livery.h"
#include "content/compile/compile_objects.h"
#include "content/compile/compile_readings.h"
#include "content/compile/compile_scenery.h"
#include "content/compile/compile_sounds.h"
#include "content/compile/compile_speech.h"
#include "content/compile/compile_touch.h"
#include "content/compile/compile_ways.h"
#include "content/compile/shipped_files.h"
#include "content/compile/zone_rules.h"
#include "content/content_error.h"
#include "platform/file/read_file.h"

namespace docent::compile {

namespace {

namespace fs = std::filesystem;

/// Runs a step on a file; what it throws goes into the report, at the file's beginning where it is
/// about all of it.
bool attempt(Report& report, const std::string& file, const std::function<void()>& step) {
  try {
    step();
    return true;
  } catch (const content::ContentError& error) {
    if (exit_code(error.kind) != exit_code(Errc::InvalidInput)) throw;
    Diagnostic diagnostic = content::to_diagnostic(error);
    if (!file::is_there(diagnostic.file)) diagnostic.file = file;
    if (diagnostic.line == 0) diagnostic.line = diagnostic.column = 1;
    if (diagnostic.hint.empty()) diagnostic.hint = "draw it otherwise, or export it again";
    report.add(std::move(diagnostic));
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

/// Is there something that the guide is to lay a hand on?
bool is_touched(const config::MuseumConfig* config) {
  return config != nullptr &&
         std::ranges::any_of(config->exhibits, [](const config::ExhibitSection& exhibit) {
           return exhibit.touch.value;
         });
}

bool has_own_avatar(const CompileOptions& options, const config::MuseumConfig* config) {
  return !options.clips.empty() ||
         (config != nullptr && (config->motion.clips.given || config->avatar.model.given));
}

/// Must the avatar be made? The clips that ship hold no mistakes: a check needs to look only at
/// others, and at how far an arm gets. A museum that is refused is not kept waiting for them.
bool needs_avatar(const CompileOptions& options, const config::MuseumConfig* config,
                  const Report& report) {
  if (!options.with_motion) return false;
  if (has_own_avatar(options, config)) return true;
  return !report.has_errors() && (!options.only_check || is_touched(config));
}

/// The avatar, compiled beside everything else where there are threads for it.
class AvatarTask {
 public:
  AvatarTask(const CompileOptions& options, AvatarSources sources, Progress& progress) {
    plan_avatar_stages(sources, progress);
    const auto when = options.jobs > 1 ? std::launch::async : std::launch::deferred;
    task_ = std::async(when, [sources = std::move(sources), &options, &progress] {
      return compile_avatar(sources, options.enrichment, options.jobs, progress);
    });
  }

  void finish(Museum& museum, Report& report) {
    CompiledAvatar compiled = task_.get();
    report.add(compiled.problems);
    museum.motion = std::move(compiled.motion);
    museum.avatar = std::move(compiled.mesh);
  }

 private:
  std::future<CompiledAvatar> task_;
};

/// Where clips come from: the command line, else the museum's own, else those that docent ships.
std::vector<fs::path> clip_folders(const CompileOptions& options,
                                   const config::MuseumConfig* config) {
  if (!options.clips.empty()) return {options.clips.begin(), options.clips.end()};
  if (config != nullptr && config->motion.clips.given)
    return {config->folder / config->motion.clips.value};
  return {shipped_clips()};
}

AvatarSources avatar_sources(const CompileOptions& options, const config::MuseumConfig* config) {
  AvatarSources sources{.clip_folders = clip_folders(options, config),
                        .model = {},
                        .only_motion = options.only_check && !has_own_avatar(options, config)};
  if (config != nullptr && config->avatar.model.given)
    sources.model = config->folder / config->avatar.model.value;
  return sources;
}

/// A floor as GeoJSON files alone: a museum without exhibits.
void compile_plan(const CompileOptions& options, Museum& museum, Report& report,
                  Progress& progress) {
  const std::string name = fs::path(options.sources.front()).stem().string();
  report.set_file_order(options.sources);
  plan_floor_stages(progress);
  const bool is_drawn = options.with_motion && !options.only_check;
  if (is_drawn) progress.plan("scenery", 8);
  std::optional<AvatarTask> avatar;
  if (needs_avatar(options, nullptr, report))
    avatar.emplace(options, avatar_sources(options, nullptr), progress);
  museum.title["en"] = name;
  config::MuseumConfig plain;
  plain.languages = {"en"};
  add_languages(plain, museum, report);
  attempt(report, options.sources.front(), [&] {
    CompiledFloor compiled = compile_floor(name, options.sources, options.coordinates,
                                           radius_classes(museum.body_radius, options.radii),
                                           report, progress, options.jobs);
    const std::vector<DrawnFloor> drawn{drawn_floor(compiled)};
    museum.floors.push_back(std::move(compiled.floor));
    museum.kiosk = most_open_place(museum.floors.front());
    if (!is_drawn) return museum.scenery.resize(1);  // the plan alone: nothing to draw
    const auto stage = progress.start("scenery");
    compile_scenery(nullptr, drawn, museum);
  });
  if (avatar) avatar->finish(museum, report);
}

/// The folder's own name, also of "." and "museum/".
std::string folder_name(const fs::path& folder) {
  std::error_code ignored;
  return fs::weakly_canonical(folder, ignored).filename().string();
}

void take_texts(const config::MuseumConfig& config, Museum& museum, Report& report) {
  museum.title = plain_texts(config.museum.title.value);
  museum.welcome = plain_texts(config.museum.welcome.value);
  if (museum.title.empty())
    for (const std::string& tag : config.languages) museum.title[tag] = folder_name(config.folder);
  add_languages(config, museum, report);
}

/// What staff say of a floor beside its plan.
void name_floor(const config::FloorSection& section, std::size_t index, Floor& floor) {
  constexpr double storey = 4;
  FloorPlan& plan = floor.plan;
  plan.ordinal = static_cast<std::int32_t>(
      section.ordinal.given ? section.ordinal.value : static_cast<std::int64_t>(index));
  plan.height = section.height.given ? section.height.value : storey * plan.ordinal;
  plan.short_name =
      section.short_name.given ? section.short_name.value : std::to_string(plan.ordinal);
  floor.title = plain_texts(section.title.value);
}

/// Compiles every floor whose plan can be used; the others stay empty, and are in the report.
std::vector<CompiledFloor> compile_floors(const config::MuseumConfig& config,
                                          const CompileOptions& options, Report& report,
                                          Progress& progress) {
  std::vector<double> asked = options.radii;
  asked.push_back(config.avatar.radius.value + Museum::walking_room);
  const std::vector<double> radii = radius_classes(config.avatar.radius.value, asked);
  std::vector<CompiledFloor> floors(config.floors.size());
  for (std::size_t i = 0; i < floors.size(); ++i) {
    const config::FloorSection& section = config.floors[i];
    const std::string file = (config.folder / section.plan.value).string();
    if (!section.plan.given || !file::is_there(file)) continue;  // already reported
    attempt(report, file, [&] {
      floors[i] = compile_floor(section.name.value, std::span(&file, 1), options.coordinates, radii,
                                report, progress, options.jobs,
                                {.doors = doors_of(config, i), .standing = standing_on(config, i)},
                                label_entries(floors.size()));
    });
    name_floor(section, i, floors[i].floor);
  }
  return floors;
}

std::string joined(const config::LocatedList& days) {
  std::string text;
  for (const config::Located<std::string>& day : days)
    text += (text.empty() ? "" : ",") + day.value;
  return text;
}

/// Gives the museum its voice. A check reads staff's recordings, and takes no time.
void speak(const config::MuseumConfig& config, const CompileOptions& options, Museum& museum,
           Report& report, Progress& progress) {
  const bool is_made = options.with_speech && !options.only_check;
  if (!is_made) return compile_speech(config, Speech::Check, {}, options.jobs, museum, report);
  const auto stage = progress.start("speech");
  compile_speech(config, Speech::Make, options.speech_before, options.jobs, museum, report);
}

/// A museum's folder.
void compile_folder(const CompileOptions& options, Museum& museum, Report& report,
                    Progress& progress) {
  config::Loaded<config::MuseumConfig> loaded = config::load_museum_config(options.sources.front());
  report.add(loaded.diagnostics);
  if (!loaded.value) return;
  add_collections(*loaded.value, report);
  const config::MuseumConfig& config = *loaded.value;
  report.set_file_order(config.files);
  if (config.floors.empty()) return;  // already reported
  plan_floor_stages(progress);
  progress.plan("exhibits", 5);
  progress.plan("images", 60);
  progress.plan("objects", 20);
  const bool is_drawn = !options.only_check || is_touched(&config);
  if (is_drawn) progress.plan("scenery", options.only_check ? 5 : 40);
  if (options.with_speech && !options.only_check) progress.plan("speech", 100);
  std::optional<AvatarTask> avatar;
  if (needs_avatar(options, &config, report))
    avatar.emplace(options, avatar_sources(options, &config), progress);

  take_texts(config, museum, report);
  museum.body_radius = config.avatar.radius.value;
  museum.time_zone = zone_rules(config, report);
  museum.holidays = joined(config.museum.holidays.value);
  std::vector<DrawnFloor> drawn;
  {
    const std::vector<CompiledFloor> floors = compile_floors(config, options, report, progress);
    for (const CompiledFloor& compiled : floors) {
      museum.floors.push_back(compiled.floor);
      drawn.push_back(drawn_floor(compiled));
    }
    const auto stage = progress.start("exhibits");
    compile_exhibits(config, floors, museum, report);
  }
  {
    const auto stage = progress.start("images");
    compile_images(config, options.only_check ? Images::Check : Images::Make, options.jobs, museum,
                   report);
    compile_captions(config, museum, report);
    compile_livery(config, museum, report);
    compile_ways(config, museum, report);
  }
  {
    const auto stage = progress.start("objects");
    compile_objects(config, options.only_check ? Objects::Check : Objects::Make, options.jobs,
                    museum, report);
  }
  if (is_drawn && !report.has_errors()) {
    constexpr double coarse = 1;
    const auto stage = progress.start("scenery");
    compile_scenery(&config, drawn, museum,
                    options.only_check ? std::optional(coarse) : std::nullopt);
  }
  if (avatar) avatar->finish(museum, report);
  if (!report.has_errors()) compile_touch(config, museum, report);
  attempt(report, config.folder.string(), [&] { compile_readings(config, museum); });
  speak(config, options, museum, report, progress);
  compile_sounds(config, options.only_check ? Sounds::Check : Sounds::Make, options.speech_before,
                 museum, report);
}

bool is_museum_folder(const CompileOptions& options) {
  return options.sources.size() == 1 && file::is_folder(options.sources.front());
}

}  // namespace

std::optional<Museum> compile(const CompileOptions& options, Report& report, Progress& progress) {
  Museum museum;
  museum.motion.skeleton.part.fill(JointIndex::None);
  if (is_museum_folder(options))
    compile_folder(options, museum, report, progress);
  else
    compile_plan(options, museum, report, progress);
  if (report.has_errors()) return {};
  return museum;
}

}  // namespace docent::compile
