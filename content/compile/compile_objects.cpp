#include "content/compile/compile_objects.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "config/colour.h"
#include "content/compile/load_image.h"
#include "content/content_error.h"
#include "content/import/object/one_primitive.h"
#include "content/object/make_object.h"
#include "content/object/relief.h"
#include "content/object/turned.h"
#include "content/parallel.h"
#include "platform/file/read_file.h"

namespace docent::compile {
namespace {

/// How an object is told.
enum class Told : std::uint8_t { Model, Turned, Relief };

/// An object that is wanted, and by which line.
struct WantedObject {
  Told told = Told::Model;
  std::string name;  ///< Its file; where there is none, its exhibit's id.
  const config::ExhibitSection* section = nullptr;  ///< The first that wants it.
  config::Place place{};
  std::optional<content::ContentError> problem{};
  std::vector<std::string> warnings{}, notes{};
  bool is_touched = false;
};

/// What of an exhibit tells its object; empty where it has none.
std::optional<WantedObject> wanted_by(const config::ExhibitSection& exhibit) {
  const auto by = [&](Told told, const std::string& name, const auto& field) {
    return WantedObject{.told = told, .name = name, .section = &exhibit, .place = field.place};
  };
  if (exhibit.model.given && !exhibit.model.value.empty())
    return by(Told::Model, exhibit.model.value, exhibit.model);
  if (exhibit.turned.given) return by(Told::Turned, exhibit.id.value, exhibit.turned);
  if (exhibit.relief.given) return by(Told::Relief, exhibit.relief.value, exhibit.relief);
  return {};
}

Diagnostic as_warning(Diagnostic diagnostic) {
  diagnostic.severity = Severity::Warning;
  return diagnostic;
}

std::string_view key_of(Told told) {
  return told == Told::Turned ? "turned" : told == Told::Relief ? "relief" : "model";
}

/// The objects that exhibits have, each once, in the order of the exhibits.
std::vector<WantedObject> wanted_objects(const config::MuseumConfig& config, Museum& museum,
                                         Report& report) {
  std::vector<WantedObject> wanted;
  std::map<std::tuple<Told, std::string, double, std::string>, std::size_t> index;
  for (std::size_t i = 0; i < config.exhibits.size(); ++i) {
    const config::ExhibitSection& section = config.exhibits[i];
    std::optional<WantedObject> object = wanted_by(section);
    if (!object) continue;
    if (museum.exhibits[i].place == ExhibitPlace::OnWall && section.position.given) {
      report.add(as_warning(config::diagnostic_at(
          config, object->place, "object-on-wall",
          fmt::format("exhibit '{}' hangs on a wall, where objects are shown by their picture",
                      section.id.value),
          {},
          fmt::format("place it in a case or on the floor, or leave `{}` out",
                      key_of(object->told)))));
      continue;
    }
    const auto [known, is_new] = index.emplace(
        std::tuple(object->told, object->name, section.height.given ? section.height.value : 0.0,
                   section.up.given ? section.up.value : std::string()),
        wanted.size());
    if (is_new) wanted.push_back(std::move(*object));
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

Vec3 linear(std::string_view colour) {
  constexpr std::uint32_t clay = 0xB5835A;
  const std::uint32_t rgb = config::parse_colour(colour).value_or(clay);
  Vec3 made{};
  for (int i = 0; i < 3; ++i)
    made[i] = import::object::linear_of(static_cast<float>(rgb >> (16 - 8 * i) & 0xFFU) / 255);
  return made;
}

/// What is said of a profile is said at the point that is wrong.
void refuse(const object::ProfileFault& fault, WantedObject& wanted) {
  const auto& points = wanted.section->turned.value.points;
  if (fault.point < points.size()) wanted.place = points[fault.point].place;
  throw content::ContentError("", 0, 0, "bad-outline", fault.what, fault.hint);
}

/// Of a picture round an object, of which one sees a half, and of one that is cut out.
constexpr std::uint32_t wrapped_side = 768, cut_side = 1024;

object::Turned turned_of(const std::filesystem::path& folder, WantedObject& wanted) {
  const config::ExhibitSection& section = *wanted.section;
  object::Turned turned;
  for (const auto& point : section.turned.value.points) turned.profile.push_back(point.value);
  if (const auto fault = object::fault_of(turned.profile)) refuse(*fault, wanted);
  turned.colour = linear(section.colour.value);
  if (const std::filesystem::path file = folder / section.wrapped.value;
      section.wrapped.given && file::is_there(file)) {
    try {
      turned.wrapped = load_pixels(file, wrapped_side);
    } catch (const content::ContentError& error) {
      wanted.place = section.wrapped.place;
      throw content::ContentError("", 0, 0, error.code,
                                  fmt::format("'{}': {}", section.wrapped.value, error.what()),
                                  error.hint);
    }
  }
  return turned;
}

import::object::ObjectFile source_of(const std::filesystem::path& folder, WantedObject& wanted) {
  if (wanted.told == Told::Turned) return object::turn(turned_of(folder, wanted));
  if (wanted.told == Told::Relief)
    return object::relief_of(load_pixels(folder / wanted.name, cut_side), wanted.name);
  return import::object::read_object(folder / wanted.name);
}

double height_of(const import::object::ObjectFile& source) {
  std::vector<std::string> ignored;
  return object::box_of(object::shape_of(source.model, "", ignored)).size().y;
}

/// A file says of its unit and axis what it says; staff's own words are in metres.
object::ObjectWish wish_of(const WantedObject& wanted, const import::object::ObjectFile& source) {
  object::ObjectWish wish;
  const config::ExhibitSection& section = *wanted.section;
  if (section.height.given) wish.height = section.height.value;
  if (wanted.told != Told::Model) {
    if (!wish.height) wish.height = height_of(source);
  } else if (section.up.given) {
    wish.up = section.up.value == "z" ? import::object::UpAxis::Z : import::object::UpAxis::Y;
  }
  return wish;
}

void load(const config::MuseumConfig& config, Objects use, std::size_t triangles,
          WantedObject& wanted, ExhibitObject& object) {
  const std::filesystem::path file = config.folder / wanted.name;
  if (wanted.told != Told::Turned && !file::is_there(file)) return;  // already reported
  try {
    const import::object::ObjectFile source = source_of(config.folder, wanted);
    const object::ObjectWish wish = wish_of(wanted, source);
    if (use == Objects::Make || wanted.is_touched) {
      object::MadeObject made = object::make_object(source, file.string(), wish, triangles);
      object = std::move(made.object);
      wanted.warnings = std::move(made.warnings);
      wanted.notes = std::move(made.notes);
    } else {
      object::Shape shape = object::shape_of(source.model, file.string(), wanted.notes);
      object::stand_up(source, wish, shape, wanted.notes);
      object.size = object::box_of(shape).size();
      wanted.warnings = source.model.warnings;
    }
    object.name = wanted.name;
  } catch (const content::ContentError& error) {
    wanted.problem = error;
  }
}

void tell(const config::MuseumConfig& config, const WantedObject& object, Report& report) {
  const std::string subject = object.told == Told::Turned
                                  ? fmt::format("'turned' of exhibit '{}'", object.name)
                                  : fmt::format("'{}'", object.name);
  const auto at = [&](std::string code, const std::string& what, std::string hint) {
    return config::diagnostic_at(config, object.place, std::move(code),
                                 fmt::format("{}: {}", subject, what), {}, std::move(hint));
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
