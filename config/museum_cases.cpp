#include "config/museum_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "config/letters.h"
#include "platform/terminal/suggest.h"

namespace docent::config {
namespace {

double facing_of(const CaseSection& stand) {
  return stand.facing.given ? stand.facing.value : ordinary_facing;
}

/// From metres to the right of its middle, as one looks at its front, and towards its front.
Vec2 place_in(const CaseSection& stand, Vec2 offset) {
  const double heading = facing_of(stand) * std::numbers::pi / 180;
  const Vec2 front{std::cos(heading), std::sin(heading)};
  return stand.position.value + offset.x * left_of(front) + offset.y * front;
}

class CaseFiller {
 public:
  CaseFiller(MuseumConfig& config, std::vector<Diagnostic>& diagnostics)
      : config_(config), diagnostics_(diagnostics) {}

  void fill(ExhibitSection& exhibit) {
    const auto stand = std::ranges::find(config_.cases, exhibit.in.value,
                                         [](const CaseSection& c) { return c.id.value; });
    if (stand == config_.cases.end()) {
      report_unknown(exhibit);
      return leave(exhibit);
    }
    if (!stand->position.given) return leave(exhibit);
    if (exhibit.floor.given &&
        floor_index(config_, exhibit.floor.value) != floor_index(config_, stand->floor.value))
      error(exhibit.floor, "bad-value",
            fmt::format("exhibit '{}' and its case '{}' are on different floors", exhibit.id.value,
                        stand->id.value),
            "leave 'floor' out: an exhibit is on the floor of its case");
    if (is_beside(*stand, exhibit.position)) {
      report_beside(*stand, exhibit);
      return leave(exhibit);
    }
    exhibit.floor.value = stand->floor.value;
    set(exhibit, exhibit.position,
        place_in(*stand, exhibit.position.given ? exhibit.position.value : Vec2{}));
    if (!exhibit.facing.given) set(exhibit, exhibit.facing, facing_of(*stand));
  }

 private:
  /// A value that the case gives: what is wrong with it is told where the case is named, unless the
  /// exhibit says something of it.
  static void set(const ExhibitSection& exhibit, auto& field, const auto& value) {
    if (!field.given) field.place = exhibit.in.place;
    field.value = value;
    field.given = true;
  }

  /// It stands nowhere, and nothing more is said of it.
  static void leave(ExhibitSection& exhibit) {
    exhibit.position.given = exhibit.facing.given = false;
    exhibit.position.place = exhibit.facing.place = exhibit.in.place;
  }

  static bool is_beside(const CaseSection& stand, const Located<Vec2>& offset) {
    return offset.given && stand.size.given &&
           (std::abs(offset.value.x) > stand.size.value.across / 2 ||
            std::abs(offset.value.y) > stand.size.value.deep / 2);
  }

  void report_beside(const CaseSection& stand, const ExhibitSection& exhibit) {
    const Vec2 half{stand.size.value.across / 2, stand.size.value.deep / 2};
    error(exhibit.position, "exhibit-beside-case",
          fmt::format("exhibit '{}' would stand beside its case '{}'", exhibit.id.value,
                      stand.id.value),
          fmt::format("with 'in', position counts from the case's middle: up to {:g} m to the "
                      "right or left and {:g} m to its front or back; left out, it is the middle",
                      half.x, half.y));
  }

  void report_unknown(const ExhibitSection& exhibit) {
    std::vector<std::string_view> ids;
    for (const CaseSection& stand : config_.cases) ids.emplace_back(stand.id.value);
    const std::string_view near = terminal::closest(in_small_letters(exhibit.in.value), ids);
    std::string hint =
        "write a [[case]] of this id into museum.toml; what stands in a case that "
        "the plan shows needs no 'in', only its position";
    if (!near.empty()) hint = fmt::format("did you mean \"{}\"?", near);
    error(exhibit.in, "unknown-case", fmt::format("there is no case '{}'", exhibit.in.value),
          std::move(hint));
  }

  void error(const auto& field, std::string code, std::string message, std::string hint) {
    diagnostics_.push_back(diagnostic_at(config_, field.place, std::move(code), std::move(message),
                                         {}, std::move(hint)));
  }

  MuseumConfig& config_;
  std::vector<Diagnostic>& diagnostics_;
};

}  // namespace

void stand_in_cases(MuseumConfig& config, std::vector<Diagnostic>& diagnostics) {
  CaseFiller filler(config, diagnostics);
  for (ExhibitSection& exhibit : config.exhibits)
    if (exhibit.in.given) filler.fill(exhibit);
}

}  // namespace docent::config
