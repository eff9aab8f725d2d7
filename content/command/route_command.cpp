#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <iterator>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <random>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "config/museum_config.h"
#include "config/today.h"
#include "content/command/commands.h"
#include "content/command/open_museum.h"
#include "content/command/plan_sketch.h"
#include "content/command/query_io.h"
#include "content/command/stopwatch.h"
#include "content/content_error.h"
#include "runtime/model/closures.h"
#include "runtime/path/building/nearest_place.h"
#include "runtime/path/building/walled_doors.h"
#include "runtime/path/route.h"

namespace docent::command {
namespace {

struct RouteOptions {
  std::string database;
  RouteKind kind = RouteKind::Shortest;
  std::optional<double> radius;
  double offset = 1;
  path::Hand hand = path::Hand::Shorter;
  bool widest = false, smooth = false;
  std::optional<std::array<double, 2>> from, to;
  std::string floor, from_floor, to_floor;
  std::optional<PlaceKind> to_place;
  std::vector<std::string> exhibits;
  std::optional<path::Metric> metric;
  bool step_free = false, no_escalators = false;
  std::string at, today;
  bool json = false;
  std::string svg, queries, output;
  int repeat = 1;
};

const char* name_of(path::BuildingStatus status) {
  switch (status) {
    case path::BuildingStatus::Ok:
      return "ok";
    case path::BuildingStatus::StartBlocked:
      return "start_blocked";
    case path::BuildingStatus::GoalBlocked:
      return "goal_blocked";
    case path::BuildingStatus::Closed:
      return "closed";
    case path::BuildingStatus::NoStepFree:
      return "no_step_free";
    case path::BuildingStatus::NoRoute:
      break;
  }
  return "no_route";
}

const char* name_of(path::RouteStatus status) {
  return name_of(path::building_status(status));
}

path::RouteQuery base_query(const RouteOptions& options, const Museum& museum) {
  return {.kind = options.kind,
          .radius = options.radius.value_or(museum.body_radius),
          .offset = options.offset,
          .hand = options.hand,
          .widest = options.widest,
          .smooth = options.smooth};
}

std::string json_leg(const Museum& museum, const path::Leg& leg) {
  const auto floor = [&](std::uint32_t index) {
    return nlohmann::json(museum.floors[index].plan.name).dump();
  };
  if (leg.is_along_floor())
    return fmt::format(R"({{"floor": {}, "points": {}}})", floor(leg.floor),
                       json_points(leg.points));
  const Connection& connection = museum.connections[leg.connection];
  return fmt::format(R"({{"connection": {}, "kind": "{}", "from": {}, "to": {}, "seconds": {}}})",
                     nlohmann::json(connection.id).dump(),
                     config::connection_kinds[static_cast<std::size_t>(connection.kind)],
                     floor(leg.floor), floor(leg.to_floor), json_number(leg.seconds));
}

/// What is in the way, by its ids.
std::vector<std::string> closed_ids(const Museum& museum, const path::BuildingWay& way) {
  std::vector<std::string> ids;
  for (const path::DoorOfFloor& closed : way.closed_doors)
    ids.push_back(museum.floors[closed.floor].plan.doors[closed.door].name);
  for (const std::uint32_t connection : way.closed)
    ids.push_back(museum.connections[connection].id);
  return ids;
}

std::string to_json(const Museum& museum, const path::BuildingWay& way) {
  const bool ok = way.status == path::BuildingStatus::Ok;
  std::vector<Vec2> points;
  std::vector<std::string> legs, floors, closed;
  for (const path::Leg& leg : way.legs) {
    legs.push_back(json_leg(museum, leg));
    if (!leg.is_along_floor()) continue;
    points.insert(points.end(), leg.points.begin(), leg.points.end());
    std::string floor = nlohmann::json(museum.floors[leg.floor].plan.name).dump();
    if (floors.empty() || floors.back() != floor) floors.push_back(std::move(floor));
  }
  for (const std::string& id : closed_ids(museum, way)) closed.push_back(nlohmann::json(id).dump());
  return fmt::format(
      R"({{"status": "{}", "length": {}, "clearance_min": {}, "points": {}, "seconds": {}, )"
      R"("floors": [{}], "legs": [{}]{}}})",
      name_of(way.status), ok ? json_number(way.length) : "null",
      ok ? json_number(way.clearance_min) : "null", json_points(points),
      ok ? json_number(way.seconds) : "null", fmt::join(floors, ", "), fmt::join(legs, ", "),
      closed.empty() ? "" : fmt::format(R"(, "closed": [{}])", fmt::join(closed, ", ")));
}

std::string to_sentence(const Museum& museum, const path::BuildingWay& way) {
  if (way.status != path::BuildingStatus::Ok) {
    const std::vector<std::string> closed = closed_ids(museum, way);
    return closed.empty() ? std::string(name_of(way.status))
                          : fmt::format("{}: {}", name_of(way.status), fmt::join(closed, ", "));
  }
  std::size_t points = 0;
  std::vector<std::string> rides;
  for (const path::Leg& leg : way.legs) {
    points += leg.points.size();
    if (!leg.is_along_floor())
      rides.push_back(fmt::format("{} from {} to {}", museum.connections[leg.connection].id,
                                  museum.floors[leg.floor].plan.name,
                                  museum.floors[leg.to_floor].plan.name));
  }
  return fmt::format("ok: {:.3f} m, {:.0f} s, never nearer than {:.3f} m to a wall, {} points{}{}",
                     way.length, way.seconds, way.clearance_min, points,
                     rides.empty() ? "" : "; by ", fmt::join(rides, ", then "));
}

/// A place on a floor to go to, or from.
struct Stop {
  std::uint32_t floor = 0;
  Vec2 position{};
};

std::vector<Stop> stops_asked_for(const Museum& museum, const RouteOptions& options) {
  if (options.exhibits.empty()) {
    const auto floor = [&](const std::string& own, std::string_view option) {
      return own.empty() ? floor_named(museum, options.floor) : floor_named(museum, own, option);
    };
    return {{floor(options.from_floor, "--from-floor"), point_of(*options.from)},
            {floor(options.to_floor, "--to-floor"), point_of(*options.to)}};
  }
  if (options.exhibits.size() < 2)
    throw content::ContentError(Errc::WrongUsage, "--exhibits", "one-exhibit",
                                "a route needs two exhibits", "write --exhibits A,B");
  std::vector<Stop> stops;
  for (const std::string& id : options.exhibits) {
    const Exhibit& exhibit = exhibit_named(museum, id, "--exhibits");
    stops.push_back({exhibit.floor, exhibit.viewing_point.position});
  }
  return stops;
}

/// A tour on one floor of a museum without connections, as `path::tour` finds it.
path::BuildingWay tour_on_floor(const path::FloorMap& map, const path::RouteQuery& query,
                                std::span<const Stop> stops) {
  std::vector<Vec2> positions;
  for (const Stop& stop : stops) positions.push_back(stop.position);
  path::Way way = path::tour(map, query, positions);
  path::BuildingWay whole{.status = path::building_status(way.status)};
  if (way.status != path::RouteStatus::Ok) return whole;
  whole.length = way.length;
  whole.seconds = way.length / strolling_pace;
  whole.clearance_min = way.clearance_min;
  whole.legs.push_back({.floor = stops.front().floor,
                        .to_floor = stops.front().floor,
                        .length = way.length,
                        .seconds = whole.seconds,
                        .points = std::move(way.points)});
  return whole;
}

std::vector<std::shared_ptr<const path::FloorMap>> maps_of(const Museum& museum) {
  std::vector<std::shared_ptr<const path::FloorMap>> maps;
  for (const Floor& floor : museum.floors) maps.push_back(path::make_floor_map(floor));
  return maps;
}

/// The time of --at.
std::optional<LocalMinute> moment_of(const RouteOptions& options) {
  if (options.at.empty()) return {};
  namespace chr = std::chrono;
  int year = 0, used = 0;
  unsigned month = 0, day = 0, hour = 0, minute = 0;
  // NOLINTNEXTLINE(cert-err34-c): what is read is checked below
  std::sscanf(options.at.c_str(), "%4d-%2u-%2uT%2u:%2u%n", &year, &month, &day, &hour, &minute,
              &used);
  const chr::year_month_day date{chr::year(year), chr::month(month), chr::day(day)};
  const std::string_view rest = std::string_view(options.at).substr(static_cast<std::size_t>(used));
  if (used == 0 || !date.ok() || hour > 23 || minute > 59 || !(rest.empty() || rest == ":00"))
    throw content::ContentError(Errc::WrongUsage, "--at", "no-time",
                                fmt::format("'{}' is no day and time", options.at),
                                "by the museum's clock: --at 2026-12-24T16:30");
  return chr::local_days(date) + chr::hours(hour) + chr::minutes(minute);
}

Today today_of(const RouteOptions& options, const Museum& museum) {
  if (options.today.empty()) return {};
  const config::Loaded<Today> today = config::load_today(options.today, museum);
  if (today.value) return *today.value;
  const Diagnostic& first = today.diagnostics.front();
  throw content::ContentError(first.file, first.line, first.column, first.code, first.message,
                              first.hint);
}

path::BuildingQuery building_query(const RouteOptions& options, const Museum& museum,
                                   const path::BuildingMap& building) {
  path::BuildingQuery query{.way = base_query(options, museum), .metric = options.metric};
  query.permissions = {.step_free = options.step_free, .no_escalators = options.no_escalators};
  if (options.at.empty() && options.today.empty()) return query;
  query.closed =
      building.closure(ClosureRules(museum).at(moment_of(options), today_of(options, museum)));
  return query;
}

/// Where there is no way: is that because of doors that are closed for good?
path::BuildingWay with_walled_doors(const Museum& museum, const path::BuildingMap& building,
                                    const path::BuildingQuery& query, path::BuildingWay way) {
  if (way.status != path::BuildingStatus::NoRoute) return way;
  way.closed_doors = path::walled_doors_in_the_way(museum, building, query);
  if (!way.closed_doors.empty()) way.status = path::BuildingStatus::Closed;
  return way;
}

/// May anything be closed?
bool may_be_closed(const RouteOptions& options, const Museum& museum) {
  return !options.at.empty() || !options.today.empty() ||
         std::ranges::any_of(museum.floors, [](const Floor& floor) {
           return std::ranges::any_of(floor.plan.doors, &Door::closed);
         });
}

path::BuildingWay tour_through(const Museum& museum, const RouteOptions& options,
                               std::span<const Stop> stops) {
  const path::RouteQuery way = base_query(options, museum);
  std::vector<std::shared_ptr<const path::FloorMap>> maps = maps_of(museum);
  const bool one_floor = std::ranges::all_of(
      stops, [&](const Stop& stop) { return stop.floor == stops.front().floor; });
  if (one_floor && museum.connections.empty() && !may_be_closed(options, museum))
    return tour_on_floor(*maps[stops.front().floor], way, stops);

  const path::BuildingMap building(museum, std::move(maps));
  path::BuildingQuery query = building_query(options, museum, building);
  if (!one_floor && !query.metric) query.metric = path::Metric::Time;
  path::BuildingWay whole;
  for (std::size_t i = 1; i < stops.size(); ++i) {
    query.way.from = stops[i - 1].position;
    query.way.to = stops[i].position;
    query.from_floor = stops[i - 1].floor;
    query.to_floor = stops[i].floor;
    path::BuildingWay next = building.route(query);
    if (next.status != path::BuildingStatus::Ok)
      return with_walled_doors(museum, building, query, std::move(next));
    whole = i == 1 ? std::move(next) : path::joined(std::move(whole), std::move(next));
  }
  return whole;
}

void draw(const Museum& museum, const path::BuildingWay& way, std::uint32_t start,
          const std::string& file) {
  std::map<std::uint32_t, std::vector<SketchLine>> lines{{start, {}}};
  for (const path::Leg& leg : way.legs)
    if (leg.is_along_floor()) lines[leg.floor].push_back({leg.points, false});
  std::vector<FloorSketch> floors;
  for (auto& [floor, drawn] : lines)
    floors.push_back({museum.floors[floor].plan, std::move(drawn)});
  write_text(file, sketch_plans(floors));
}

/// "toilets, exit": the kinds of places that a museum has.
std::string kinds_of_places(const Museum& museum) {
  std::vector<std::string_view> names;
  for (const PlaceKindInfo& info : place_kinds)
    if (std::ranges::find(museum.places, info.kind, &Place::kind) != museum.places.end())
      names.push_back(info.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

void answer_nearest(const Museum& museum, const RouteOptions& options) {
  const path::BuildingMap building(museum, maps_of(museum));
  path::BuildingQuery query = building_query(options, museum, building);
  query.way.from = point_of(*options.from);
  query.from_floor = options.from_floor.empty()
                         ? floor_named(museum, options.floor)
                         : floor_named(museum, options.from_floor, "--from-floor");
  const path::NearestPlace nearest =
      path::nearest_place(building, query, museum.places, *options.to_place);
  const std::string_view kind = info_of(*options.to_place).name;
  if (nearest.place == none)
    throw content::ContentError(Errc::InvalidInput, "--to-place", "no-such-place",
                                fmt::format("the museum has no place of the kind '{}'", kind),
                                museum.places.empty()
                                    ? "write a [[place]] in museum.toml"
                                    : fmt::format("it has: {}", kinds_of_places(museum)));
  const Place& place = museum.places[nearest.place];
  if (!options.svg.empty()) draw(museum, nearest.way, query.from_floor, options.svg);
  if (options.json) {
    std::string answer = to_json(museum, nearest.way);
    answer.pop_back();
    fmt::print("{}, \"place\": {}}}\n", answer, nlohmann::json(place.id).dump());
  } else {
    fmt::print("{}: {}\n", place.id, to_sentence(museum, nearest.way));
  }
}

void answer_one(const Museum& museum, const RouteOptions& options) {
  if (options.to_place) return answer_nearest(museum, options);
  const std::vector<Stop> stops = stops_asked_for(museum, options);
  const path::BuildingWay way = tour_through(museum, options, stops);
  if (!options.svg.empty()) draw(museum, way, stops.front().floor, options.svg);
  fmt::print("{}\n", options.json ? to_json(museum, way) : to_sentence(museum, way));
}

/// Answers every query once a round, each round in a new order, and times each on its own: the way,
/// without how wide it is, which is found in a last round that is not timed.
class TimedRounds {
 public:
  TimedRounds(const path::FloorMap& map, std::vector<path::RouteQuery> queries)
      : map_(map), queries_(std::move(queries)), ways_(queries_.size()), times_(queries_.size()) {}

  void run(int rounds) {
    std::vector<std::size_t> order(queries_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::mt19937 random(20250101);  // NOLINT: the same orders every time
    for (int round = 0; round < rounds; ++round) {
      std::ranges::shuffle(order, random);
      for (const std::size_t i : order) {
        path::RouteQuery timed = queries_[i];
        timed.tell_clearance = false;
        const auto start = std::chrono::steady_clock::now();
        ways_[i] = path::route(map_, timed);
        const std::chrono::duration<double, std::micro> took =
            std::chrono::steady_clock::now() - start;
        times_[i].push_back(took.count());
      }
    }
    for (std::size_t i = 0; i < queries_.size(); ++i) ways_[i] = path::route(map_, queries_[i]);
  }
  const path::Way& way(std::size_t i) const { return ways_[i]; }
  double median_microseconds(std::size_t i) {
    auto& times = times_[i];
    const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
    std::ranges::nth_element(times, middle);
    return *middle;
  }

 private:
  const path::FloorMap& map_;
  std::vector<path::RouteQuery> queries_;
  std::vector<path::Way> ways_;
  std::vector<std::vector<double>> times_;
};

void answer_table(const Museum& museum, const RouteOptions& options) {
  const Stopwatch stopwatch;
  if (options.output.empty())
    throw content::ContentError(Errc::WrongUsage, "--queries", "no-output",
                                "the answers need a file", "add -o A.csv");
  const std::uint32_t floor = floor_named(museum, options.floor);
  const NumberTable table = read_numbers(
      options.queries, {{"x0"}, {"y0"}, {"x1"}, {"y1"}, {"r", terminal::not_negative}});
  std::vector<path::RouteQuery> queries;
  for (const auto& row : table.rows) {
    path::RouteQuery query = base_query(options, museum);
    query.from = {row[0], row[1]};
    query.to = {row[2], row[3]};
    query.radius = row[4];
    queries.push_back(query);
  }
  path::BuildingMap building(museum, maps_of(museum));
  building.close(building_query(options, museum, building).closed);
  TimedRounds rounds(building.floor(floor), std::move(queries));
  rounds.run(options.repeat);
  std::string text = "x0,y0,x1,y1,r,status,length,clearance_min,microseconds\n";
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const path::Way& way = rounds.way(i);
    const auto number = [&](double value) {
      return way.status == path::RouteStatus::Ok ? fmt::format("{}", value) : std::string();
    };
    text +=
        fmt::format("{},{},{},{},{:.3f}\n", table.written[i], name_of(way.status),
                    number(way.length), number(way.clearance_min), rounds.median_microseconds(i));
  }
  write_text(options.output, text);
  if (!options.json) stopwatch.say_wrote(options.output);
}

void run_route(const RouteOptions& options) {
  const int ways_to_ask = (options.queries.empty() ? 0 : 1) + (options.exhibits.empty() ? 0 : 1) +
                          (options.from || options.to || options.to_place ? 1 : 0);
  const int goals = (options.to ? 1 : 0) + (options.to_place ? 1 : 0);
  if (ways_to_ask != 1 || goals != (options.from ? 1 : 0))
    throw content::ContentError(Errc::WrongUsage, "route", "no-ends",
                                "say from where to where, once",
                                "give --from X,Y --to X,Y, or --from X,Y --to-place KIND, or "
                                "--exhibits A,B, or --queries Q.csv -o A.csv");
  const Museum museum = load_or_throw(options.database);
  if (options.queries.empty())
    answer_one(museum, options);
  else
    answer_table(museum, options);
}

std::vector<std::pair<std::string_view, RouteKind>> named_kinds() {
  std::vector<std::pair<std::string_view, RouteKind>> named;
  for (const RouteKindInfo& info : route_kinds) named.emplace_back(info.name, info.kind);
  return named;
}

std::vector<std::pair<std::string_view, PlaceKind>> named_places() {
  std::vector<std::pair<std::string_view, PlaceKind>> named;
  for (const PlaceKindInfo& info : place_kinds) named.emplace_back(info.name, info.kind);
  return named;
}

/// The kinds are too many for a line of help; museum.toml(5) lists them.
terminal::Value place_kind(std::optional<PlaceKind>& target) {
  terminal::Value value = terminal::one_of<PlaceKind>(named_places(), target);
  value.name = "KIND";
  return value;
}

/// From where to where, and by which kind of way.
std::vector<terminal::Option> question(RouteOptions* options) {
  using terminal::Times;
  return {
      {"DB", terminal::file("DB", options->database), "The museum's database", Times::Once},
      {"--kind", terminal::one_of<RouteKind>(named_kinds(), options->kind),
       "The shortest way, along the middle of the rooms, or along the walls", Times::Once},
      {"--from", terminal::numbers("X,Y", options->from), "From this point, metres"},
      {"--to", terminal::numbers("X,Y", options->to), "To this point, metres"},
      {"--to-place", place_kind(options->to_place),
       "To the nearest place of this kind (as in museum.toml), by time"},
      {"--exhibits", terminal::list("A,B,...", options->exhibits),
       "From one exhibit's viewing point to the next, in this order"},
      {"--radius", terminal::number("R", terminal::not_negative, options->radius),
       "Metres, of the body", Times::AtMostOnce, "the museum's"},
      {"--offset", terminal::number("D", terminal::positive, options->offset),
       "offset: metres to keep from the wall", Times::AtMostOnce, "1"},
      {"--hand",
       terminal::one_of<path::Hand>({{"left", path::Hand::Left}, {"right", path::Hand::Right}},
                                    options->hand),
       "offset: on which side the wall is", Times::AtMostOnce, "the shorter way"},
      {"--widest", terminal::flag(options->widest),
       "skeleton: the way whose narrowest place is the widest possible"},
      {"--smooth", terminal::flag(options->smooth),
       "skeleton, offset: with rounded corners, as the guide walks it"},
  };
}

/// Where and how it is answered.
std::vector<terminal::Option> answer(RouteOptions* options) {
  using terminal::Times;
  return {
      {"--floor", terminal::text("NAME", options->floor), "Name of the floor", Times::AtMostOnce,
       "the kiosk's"},
      {"--from-floor", terminal::text("NAME", options->from_floor), "The floor of --from",
       Times::AtMostOnce, "that of --floor"},
      {"--to-floor", terminal::text("NAME", options->to_floor), "The floor of --to",
       Times::AtMostOnce, "that of --floor"},
      {"--metric",
       terminal::one_of<path::Metric>(
           {{"time", path::Metric::Time}, {"length", path::Metric::Length}}, options->metric),
       "What is to be least", Times::AtMostOnce, "time across floors, length on one"},
      {"--step-free", terminal::flag(options->step_free), "By lifts and ramps only"},
      {"--no-escalators", terminal::flag(options->no_escalators), "Not by escalators"},
      {"--at", terminal::text("TIME", options->at),
       "What is closed at 2026-12-24T16:30 by the museum's clock", Times::AtMostOnce,
       "nothing that hours close"},
      {"--today", terminal::file("FILE", options->today), "A today.toml: what is closed live"},
      {"--json", terminal::flag(options->json), "Print the way as JSON"},
      {"--svg", terminal::file("FILE", options->svg), "Draw the way into this file"},
      {"--queries", terminal::file("Q.csv", options->queries),
       "Columns x0,y0,x1,y1,r: many ways; the answers go to -o"},
      {"-o,--output", terminal::file("A.csv", options->output),
       "The queries with status, length, clearance_min and microseconds"},
      {"--repeat",
       terminal::number("N", {terminal::Limits::Of::WholeNumbers, 1, 100000}, options->repeat),
       "Rounds of queries, whose median time is told", Times::AtMostOnce, "1"},
  };
}

}  // namespace

terminal::Command route_command() {
  auto options = std::make_shared<RouteOptions>();
  std::vector<terminal::Option> table = question(options.get());
  std::ranges::move(answer(options.get()), std::back_inserter(table));
  return {.name = "route",
          .manual = "finds the way between points or exhibits",
          .options = std::move(table),
          .run = [options] {
            run_route(*options);
            return 0;
          }};
}

}  // namespace docent::command
