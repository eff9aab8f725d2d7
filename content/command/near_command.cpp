#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "content/command/commands.h"
#include "content/command/open_museum.h"
#include "content/command/query_io.h"
#include "content/content_error.h"
#include "runtime/path/reach.h"

namespace docent::command {
namespace {

struct NearOptions {
  std::string database, exhibit, floor;
  std::optional<std::array<double, 2>> from;  ///< Metres.
  std::optional<double> within, radius;
  double speed = 1.3;
  bool json = false;
};

/// Where somebody stands and what they could walk to.
struct Surroundings {
  std::uint32_t floor = 0;
  Vec2 from{};
  std::vector<const Exhibit*> exhibits{};  ///< Of that floor; without the one they stand at.
};

Surroundings surroundings(const Museum& museum, const NearOptions& options) {
  Surroundings around{.floor = floor_named(museum, options.floor)};
  if (options.exhibit.empty()) {
    around.from = point_of(*options.from);
  } else {
    const Exhibit& exhibit = exhibit_named(museum, options.exhibit, "--exhibit");
    if (!options.floor.empty() && exhibit.floor != around.floor)
      throw content::ContentError(Errc::WrongUsage, "--exhibit", "other-floor",
                                  fmt::format("exhibit '{}' is on another floor, '{}'", exhibit.id,
                                              museum.floors[exhibit.floor].plan.name),
                                  "leave --floor out");
    around.floor = exhibit.floor;
    around.from = exhibit.viewing_point.position;
  }
  for (const Exhibit& exhibit : museum.exhibits)
    if (exhibit.floor == around.floor && exhibit.id != options.exhibit)
      around.exhibits.push_back(&exhibit);
  return around;
}

std::string to_json(bool blocked, const Surroundings& around,
                    const std::vector<path::Reached>& reached, double speed) {
  std::string rows;
  for (const path::Reached& r : reached)
    rows += fmt::format(R"({}{{"id": "{}", "length": {}, "seconds": {}}})",
                        rows.empty() ? "" : ", ", around.exhibits[r.place]->id,
                        json_number(r.length), json_number(r.length / speed));
  return fmt::format(R"({{"status": "{}", "exhibits": [{}]}})", blocked ? "start_blocked" : "ok",
                     rows);
}

std::string to_lines(bool blocked, const Surroundings& around,
                     const std::vector<path::Reached>& reached, double speed) {
  if (blocked) return "start_blocked";
  if (reached.empty()) return "no exhibit in reach";
  std::string lines;
  for (const path::Reached& r : reached)
    lines += fmt::format("{}{}: {:.3f} m, {:.0f} s", lines.empty() ? "" : "\n",
                         around.exhibits[r.place]->id, r.length, r.length / speed);
  return lines;
}

void run_near(const NearOptions& options) {
  if (options.from.has_value() != options.exhibit.empty())
    throw content::ContentError(Errc::WrongUsage, "near", "no-start", "say from where, once",
                                "give --from X,Y or --exhibit ID");
  const Museum museum = load_or_throw(options.database);
  const Surroundings around = surroundings(museum, options);
  std::vector<Vec2> places;
  places.reserve(around.exhibits.size());
  for (const Exhibit* exhibit : around.exhibits) places.push_back(exhibit->viewing_point.position);

  const auto map = path::make_floor_map(museum.floors[around.floor]);
  const double radius = options.radius.value_or(museum.body_radius);
  const double limit =
      options.within ? *options.within * options.speed : std::numeric_limits<double>::infinity();
  const path::RouteQuery standing{.from = around.from, .to = around.from, .radius = radius};
  const bool blocked = path::route(*map, standing).status != path::RouteStatus::Ok;
  const auto reached = path::places_in_reach(*map, around.from, places, radius, limit);
  fmt::print("{}\n", options.json ? to_json(blocked, around, reached, options.speed)
                                  : to_lines(blocked, around, reached, options.speed));
}

}  // namespace

terminal::Command near_command() {
  using terminal::Times;
  auto options = std::make_shared<NearOptions>();
  return {
      .name = "near",
      .manual = "lists the exhibits in reach, nearest on foot first",
      .options =
          {
              {"DB", terminal::file("DB", options->database), "The museum's database", Times::Once},
              {"--from", terminal::numbers("X,Y", options->from), "From this point, metres"},
              {"--exhibit", terminal::text("ID", options->exhibit),
               "From this exhibit's viewing point"},
              {"--within", terminal::number("S", terminal::not_negative, options->within),
               "Seconds of walking", Times::AtMostOnce, "as long as it takes"},
              {"--speed", terminal::number("V", terminal::positive, options->speed),
               "Metres a second", Times::AtMostOnce, "1.3"},
              {"--radius", terminal::number("R", terminal::not_negative, options->radius),
               "Metres, of the body", Times::AtMostOnce, "the museum's"},
              {"--floor", terminal::text("NAME", options->floor), "Name of the floor",
               Times::AtMostOnce, "the kiosk's"},
              {"--json", terminal::flag(options->json), "Print the list as JSON"},
          },
      .run = [options] {
        run_near(*options);
        return 0;
      }};
}

}  // namespace docent::command
