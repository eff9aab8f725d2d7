#include "content/compile/compile_objects.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "content/content_error.h"
#include "content/object/make_object.h"
#include "content/parallel.h"
#include "platform/file/read_file.h"

namespace docent::compile {
namespace {

/// An object that is wanted, and by which line.
struct WantedObject {
  std::string name;
  object::ObjectWish wish;
  config::Place place;
  std::optional<content::ContentError> problem{};
  std::vector<std::string> warnings{}, notes{};
  bool is_touched = false;
};

object::ObjectWish wish_of(const config::ExhibitSection& exhibit) {
  object::ObjectWish wish;
  if (exhibit.height.given) wish.height = exhibit.height.value;
  if (exhibit.up.given)
    wish.up = exhibit.up.value == "z" ? import::object::UpAxis::Z : import::object::UpAxis::Y;
  return wish;
}

Diagnostic as_warning(Diagnostic diagnostic) {
  diagnostic.severity = Severity::Warning;
  return diagnostic;
}

/// The files that exhibits name, each once, in the order of the exhibits.
std::vector<WantedObject> wanted_objects(const config::MuseumConfig& config, Museum& museum,
                                         Report& report) {
  std::vector<WantedObject> wanted;
  std::map<std::tuple<std::string, double, std::string>, std::size_t> index;
  for (std::size_t i = 0; i < config.exhibits.size(); ++i) {
    const config::ExhibitSection& section = config.exhibits[i];
    if (!section.model.given || section.model.value.empty()) continue;
    if (museum.exhibits[i].place == ExhibitPlace::OnWall && section.position.given) {
      report.add(as_warning(config::diagnostic_at(
          config, section.model.place, "object-on-wall",
          fmt::format("exhibit '{}' hangs on a wall, where objects are shown by their picture",
                      section.id.value),
          {}, "place it in a case or on the floor, or leave `model` out")));
      continue;
    }
    const auto [known, is_new] = index.emplace(
        std::tuple(section.model.value, section.height.given ? section.height.value : 0.0,
                   section.up.given ? section.up.value : std::string()),
        wanted.size());
    if (is_new) wanted.push_back({section.model.value, wish_of(section), section.model.place});
    wanted[known->second].is_touched |= section.touch.value;
    museum.exhibits[i].object = static_cast<std::int32_t>(known->second);
  }
  return wanted;
}

/// A model of the museum shows all objects at once: the more, the fewer triangles each.
std::size_t distant_triangles(std::size_t objects) {
  constexpr std::size_t all = 24'000, least = 100;
  return std::clamp(all / std::max<std::size_t>(objects, 1), least,
                    ExhibitObject::most_distant_triangles);
}

void load(const config::MuseumConfig& config, Objects use, std::size_t triangles,
          WantedObject& wanted, ExhibitObject& object) {
  const std::filesystem::path file = config.folder / wanted.name;
  if (!file::is_there(file)) return;  // already reported
  try {
    const import::object::ObjectFile source = import::object::read_object(file);
    if (use == Objects::Make || wanted.is_touched) {
      object::MadeObject made = object::make_object(source, file.string(), wanted.wish, triangles);
      object = std::move(made.object);
      wanted.warnings = std::move(made.warnings);
      wanted.notes = std::move(made.notes);
    } else {
      object::Shape shape = object::shape_of(source.model, file.string(), wanted.notes);
      object::stand_up(source, wanted.wish, shape, wanted.notes);
      object.size = object::box_of(shape).size();
      wanted.warnings = source.model.warnings;
    }
    object.name = wanted.name;
  } catch (const content::ContentError& error) {
    wanted.problem = error;
  }
}

void tell(const config::MuseumConfig& config, const WantedObject& object, Report& report) {
  const auto at = [&](std::string code, const std::string& what, std::string hint) {
    return config::diagnostic_at(config, object.place, std::move(code),
                                 fmt::format("'{}': {}", object.name, what), {}, std::move(hint));
  };
  if (object.problem) {
    const std::string line =
        object.problem->line > 0 ? fmt::format("line {}: ", object.problem->line) : "";
    report.add(at(object.problem->code, line + object.problem->what(), object.problem->hint));
  }
  constexpr std::size_t most = 5;
  for (std::size_t i = 0; i < std::min(object.warnings.size(), most); ++i)
    report.add(as_warning(
        at("object-mended", object.warnings[i], "look at it on the kiosk, or export it again")));
  for (const std::string& note : object.notes)
    report.add(
        as_warning(at("object-guessed", note,
                      "write height = ... (metres) and up = \"y\" or \"z\" where that is not "
                      "so")));
}

}  // namespace

void compile_objects(const config::MuseumConfig& config, Objects use, unsigned jobs, Museum& museum,
                     Report& report) {
  std::vector<WantedObject> wanted = wanted_objects(config, museum, report);
  museum.objects.resize(wanted.size());
  const std::size_t triangles = distant_triangles(wanted.size());
  content::for_each_index(wanted.size(), jobs, [&](std::size_t i) {
    load(config, use, triangles, wanted[i], museum.objects[i]);
  });
  for (const WantedObject& object : wanted) tell(config, object, report);
}

}  // namespace docent::compile
