#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "content/command/commands.h"
#include "content/command/open_museum.h"
#include "content/command/query_io.h"
#include "content/content_error.h"
#include "runtime/path/building/museum_tour.h"

namespace docent::command {
namespace {

using Json = nlohmann::ordered_json;

constexpr double seconds_a_minute = 60;

struct TourOptions {
  std::string database;
  std::vector<std::string> exhibits;
  std::string first, last;
  std::optional<double> minutes;
  bool step_free = false, json = false;
};

[[noreturn]] void wrong_usage(const char* where, const char* code, const std::string& message,
                              const std::string& hint) {
  throw content::ContentError(Errc::WrongUsage, where, code, message, hint);
}

std::uint32_t index_of(const Museum& museum, const std::string& id, const char* option) {
  return static_cast<std::uint32_t>(&exhibit_named(museum, id, option) - museum.exhibits.data());
}

std::vector<std::uint32_t> exhibits_asked_for(const Museum& museum, const TourOptions& options) {
  std::vector<std::uint32_t> exhibits;
  std::set<std::string_view> seen;
  for (const std::string& id : options.exhibits) {
    exhibits.push_back(index_of(museum, id, "--exhibits"));
    if (!seen.insert(id).second)
      wrong_usage("--exhibits", "exhibit-twice", fmt::format("exhibit '{}' is named twice", id),
                  "a tour visits each exhibit once");
  }
  return exhibits;
}

/// The exhibit that is to be first or last, which is one of those asked for.
std::optional<std::uint32_t> end_asked_for(const Museum& museum, const TourOptions& options,
                                           const std::string& id, const char* option) {
  if (id.empty()) return {};
  const std::uint32_t exhibit = index_of(museum, id, option);
  if (std::ranges::find(options.exhibits, id) == options.exhibits.end())
    wrong_usage(option, "not-on-tour", fmt::format("exhibit '{}' is not on the tour", id),
                "write it under --exhibits too");
  return exhibit;
}

void check_question(const TourOptions& options) {
  if (options.exhibits.empty() != options.minutes.has_value())
    wrong_usage("tour", "no-exhibits", "say which exhibits, or how many minutes there are",
                "give --exhibits A,B,C or --minutes N");
  if (options.minutes && (!options.first.empty() || !options.last.empty()))
    wrong_usage("tour", "chosen-end", "what is first or last is chosen too where minutes are given",
                "give --exhibits A,B,C with --first and --last");
  if (!options.first.empty() && options.first == options.last && options.exhibits.size() > 1)
    wrong_usage("--last", "first-and-last",
                fmt::format("exhibit '{}' cannot be both first and last", options.first),
                "name two exhibits, or leave one option away");
}

/// Why nobody can walk the tour, as an input that has to be changed.
[[noreturn]] void report_no_tour(const Museum& museum, const TourOptions& options,
                                 const path::MuseumTour& tour) {
  struct Reason {
    const char* code;
    std::string message, hint;
  };
  std::vector<std::string_view> ids;
  for (const std::uint32_t i : tour.unreached) ids.emplace_back(museum.exhibits[i].id);
  const std::string named = fmt::format("{}", fmt::join(ids, ", "));
  const auto reason = [&]() -> Reason {
    if (ids.empty())
      return {"no-order",
              "no order of these exhibits can be walked: there is no way back from some",
              "make two tours of them, or choose other ends"};
    switch (*tour.why_not) {
      case path::BuildingStatus::StartBlocked:
        return {"start-blocked", "nobody can stand where the kiosk is", "move the kiosk"};
      case path::BuildingStatus::GoalBlocked:
        return {"goal-blocked", fmt::format("nobody can stand in front of {}", named), "move it"};
      case path::BuildingStatus::Closed:
        return {"closed", fmt::format("what is closed is in the way to {}", named),
                "leave it out while that is closed"};
      case path::BuildingStatus::NoStepFree:
        return {"no-step-free", fmt::format("there are steps on every way to {}", named),
                "leave it out, or leave --step-free away"};
      default:
        return {"no-route", fmt::format("there is no way from the kiosk to {}", named),
                "leave it out"};
    }
  }();
  throw content::ContentError(Errc::InvalidInput, options.database, reason.code, reason.message,
                              reason.hint);
}

std::string to_json(const Museum& museum, const path::MuseumTour& tour) {
  Json ids = Json::array();
  for (const std::uint32_t i : tour.exhibits) ids.push_back(museum.exhibits[i].id);
  return fmt::format(
      R"({{"order": {}, "seconds": {}, "walk_seconds": {}, "length": {}, "optimal": {}}})",
      ids.dump(), json_number(tour.seconds()), json_number(tour.walk_seconds),
      json_number(tour.length), tour.optimal);
}

std::string to_lines(const Museum& museum, const path::MuseumTour& tour) {
  if (tour.exhibits.empty()) return "there is no time for any exhibit";
  std::string lines;
  for (const std::uint32_t i : tour.exhibits) lines += museum.exhibits[i].id + "\n";
  return lines + fmt::format("{:.0f} s: {:.0f} s of walking, {:.3f} m, and {:.0f} s of looking; {}",
                             tour.seconds(), tour.walk_seconds, tour.length, tour.looking_seconds,
                             tour.optimal ? "nothing is better" : "not proved to be the best");
}

void run_tour(const TourOptions& options) {
  check_question(options);
  const Museum museum = load_or_throw(options.database);
  const std::vector<std::uint32_t> exhibits = exhibits_asked_for(museum, options);
  const path::ExhibitEnds ends{.first = end_asked_for(museum, options, options.first, "--first"),
                               .last = end_asked_for(museum, options, options.last, "--last")};
  std::vector<std::shared_ptr<const path::FloorMap>> maps;
  for (const Floor& floor : museum.floors) maps.push_back(path::make_floor_map(floor));
  const path::BuildingMap building(museum, std::move(maps));
  path::TourWish wish = path::tour_from_kiosk(museum);
  wish.permissions.step_free = options.step_free;
  const path::MuseumTour tour =
      options.minutes ? path::best_tour(museum, building, *options.minutes * seconds_a_minute, wish)
                      : path::shortest_tour(museum, building, exhibits, ends, wish);
  if (tour.why_not) report_no_tour(museum, options, tour);
  fmt::print("{}\n", options.json ? to_json(museum, tour) : to_lines(museum, tour));
}

}  // namespace

terminal::Command tour_command() {
  using terminal::Times;
  auto options = std::make_shared<TourOptions>();
  return {
      .name = "tour",
      .manual =
          "orders exhibits by the shortest walk from the kiosk, or chooses the best for a time",
      .options =
          {
              {"DB", terminal::file("DB", options->database), "The museum's database", Times::Once},
              {"--exhibits", terminal::list("A,B,C...", options->exhibits),
               "The exhibits to visit, in any order"},
              {"--first", terminal::text("A", options->first), "The one to begin with"},
              {"--last", terminal::text("C", options->last), "The one to end with",
               Times::AtMostOnce, "anywhere"},
              {"--minutes", terminal::number("N", terminal::positive, options->minutes),
               "Choose the exhibits that weigh most and can be walked to and looked at in N "
               "minutes"},
              {"--step-free", terminal::flag(options->step_free), "By lifts and ramps only"},
              {"--json", terminal::flag(options->json), "Print the tour as JSON"},
          },
      .run = [options] {
        run_tour(*options);
        return 0;
      }};
}

}  // namespace docent::command
