#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <iterator>
#include <memory>
#include <numeric>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "content/command/commands.h"
#include "content/command/open_museum.h"
#include "content/command/plan_sketch.h"
#include "content/command/query_io.h"
#include "content/command/stopwatch.h"
#include "content/content_error.h"
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
  std::string floor;
  std::vector<std::string> exhibits;
  bool json = false;
  std::string svg, queries, output;
  int repeat = 1;
};

const char* name_of(path::RouteStatus status) {
  switch (status) {
    case path::RouteStatus::Ok:
      return "ok";
    case path::RouteStatus::StartBlocked:
      return "start_blocked";
    case path::RouteStatus::GoalBlocked:
      return "goal_blocked";
    case path::RouteStatus::NoRoute:
      break;
  }
  return "no_route";
}

path::RouteQuery base_query(const RouteOptions& options, const Museum& museum) {
  return {.kind = options.kind,
          .radius = options.radius.value_or(museum.body_radius),
          .offset = options.offset,
          .hand = options.hand,
          .widest = options.widest,
          .smooth = options.smooth};
}

std::string to_json(const path::Way& way) {
  const bool ok = way.status == path::RouteStatus::Ok;
  return fmt::format(R"({{"status": "{}", "length": {}, "clearance_min": {}, "points": {}}})",
                     name_of(way.status), ok ? json_number(way.length) : "null",
                     ok ? json_number(way.clearance_min) : "null", json_points(way.points));
}

std::string to_sentence(const path::Way& way) {
  if (way.status != path::RouteStatus::Ok) return name_of(way.status);
  return fmt::format("ok: {:.3f} m, never nearer than {:.3f} m to a wall, {} points", way.length,
                     way.clearance_min, way.points.size());
}

/// The viewing points of the exhibits, which must share a floor; `floor` is set to it.
std::vector<Vec2> stops_at_exhibits(const Museum& museum, const RouteOptions& options,
                                    std::uint32_t& floor) {
  std::vector<Vec2> stops;
  for (const std::string& id : options.exhibits) {
    const Exhibit& exhibit = exhibit_named(museum, id, "--exhibits");
    if (stops.empty() && options.floor.empty()) floor = exhibit.floor;
    if (exhibit.floor != floor)
      throw content::ContentError(Errc::WrongUsage, "--exhibits", "other-floor",
                                  fmt::format("exhibit '{}' is on another floor, '{}'", id,
                                              museum.floors[exhibit.floor].plan.name),
                                  "a route stays on one floor");
    stops.push_back(exhibit.viewing_point.position);
  }
  return stops;
}

void answer_one(const Museum& museum, const RouteOptions& options) {
  std::uint32_t floor = floor_named(museum, options.floor);
  std::vector<Vec2> stops;
  if (options.exhibits.empty()) {
    stops = {point_of(*options.from), point_of(*options.to)};
  } else {
    if (options.exhibits.size() < 2)
      throw content::ContentError(Errc::WrongUsage, "--exhibits", "one-exhibit",
                                  "a route needs two exhibits", "write --exhibits A,B");
    stops = stops_at_exhibits(museum, options, floor);
  }
  const auto map = path::make_floor_map(museum.floors[floor]);
  const path::Way way = path::tour(*map, base_query(options, museum), stops);
  if (!options.svg.empty())
    write_text(options.svg, sketch_plan(museum.floors[floor].plan, {{way.points, false}}));
  fmt::print("{}\n", options.json ? to_json(way) : to_sentence(way));
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
  const auto map = path::make_floor_map(museum.floors[floor]);
  TimedRounds rounds(*map, std::move(queries));
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
                          (options.from || options.to ? 1 : 0);
  if (ways_to_ask != 1 || options.from.has_value() != options.to.has_value())
    throw content::ContentError(
        Errc::WrongUsage, "route", "no-ends", "say from where to where, once",
        "give --from X,Y --to X,Y, or --exhibits A,B, or --queries Q.csv -o A.csv");
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

/// From where to where, and by which kind of way.
std::vector<terminal::Option> question(RouteOptions* options) {
  using terminal::Times;
  return {
      {"DB", terminal::file("DB", options->database), "The museum's database", Times::Once},
      {"--kind", terminal::one_of<RouteKind>(named_kinds(), options->kind),
       "The shortest way, along the middle of the rooms, or along the walls", Times::Once},
      {"--from", terminal::numbers("X,Y", options->from), "From this point, metres"},
      {"--to", terminal::numbers("X,Y", options->to), "To this point, metres"},
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
