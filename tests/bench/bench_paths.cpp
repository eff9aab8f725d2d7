// How fast is a shortest path, on every floor that we have, beside the libraries and methods that
// people use: Detour, a visibility graph with A*, Polyanya? All in one run, on the same floors and
// queries. Fails when two exact ways disagree, or ours with a known answer.

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <memory>

#include "content/draw/svg.h"
#include "runtime/path/offset/offset_curve.h"
#include "tests/bench/contest.h"
#include "tests/bench/detour_mesh.h"
#include "tests/bench/generated_floors.h"
#include "tests/bench/measure.h"
#include "tests/bench/plot.h"
#include "tests/bench/polyanya.h"
#include "tests/bench/visibility_graph.h"
#include "tests/support/reference_data.h"

namespace docent::bench {
namespace {

namespace fs = std::filesystem;

constexpr double megabyte = 1024.0 * 1024.0;
constexpr double exact = 1e-6;              // Relative; how far lengths of exact ways may differ.
constexpr double reference_bracket = 2e-5;  // Metres; the reference's own for a disc.
constexpr std::size_t new_radii = 60;       // How many radii that were not compiled are asked for.
constexpr std::size_t large_floor = 900;    // Vertices.

struct Options {
  std::vector<std::string> folders;
  std::vector<std::string> only;
  std::vector<std::size_t> generated;
  std::size_t queries = 200;
  int rounds = 7;
  std::string out = ".";
};

/// One line of the table.
struct Row {
  std::string map;
  std::size_t vertices = 0;
  double radius = 0;
  std::string who;
  bool is_exact = true;
  Score score;
  double ratio = 1;  ///< Its median over ours.
  double made_in_seconds = 0, megabytes = 0;
};

/// An entrant that asks what `make` makes, with the time that this takes and the memory it keeps.
template <class Make>
Entrant entrant(const std::string& name, bool is_exact, Make make) {
  const double begin = now(), heap = heap_in_use();
  const auto thing = make();
  return {.name = name,
          .is_exact = is_exact,
          .find = [thing](const Query& query) { return thing->find(query.from, query.to); },
          .made_in_seconds = now() - begin,
          .megabytes = (heap_in_use() - heap) / megabyte};
}

Entrant detour(const FloorPlan& plan, double radius, double usual_radius) {
  return entrant("Detour", false,
                 [&] { return std::make_shared<DetourMesh>(plan, radius, usual_radius); });
}

Entrant visibility_graph(const FloorPlan& plan) {
  return entrant("visibility graph", true, [&] { return std::make_shared<VisibilityGraph>(plan); });
}

Entrant polyanya(const FloorPlan& plan) {
  return entrant("Polyanya", true,
                 [&] { return std::make_shared<Polyanya>(merge_polygons(triangulate(plan))); });
}

/// The part of a floor where a disc's centre can go, its arcs as chords 1 mm away at most: a plan
/// for those who know the ways of a point only. Pieces below a tenth of a millimetre are left out.
FloorPlan room_for_centre(const path::FloorMap& map, double radius) {
  constexpr double least_piece = 1e-4;
  FloorPlan plan;
  for (const path::OffsetRing& ring : path::offset_curve(map, radius).rings) {
    const auto first = static_cast<std::uint32_t>(plan.vertex.size());
    for (const Vec2 point : ring.points)
      if (plan.vertex.size() == first || (glm::distance(point, plan.vertex.back()) > least_piece &&
                                          glm::distance(point, plan.vertex[first]) > least_piece))
        plan.vertex.push_back(point);
    const auto count = static_cast<std::uint32_t>(plan.vertex.size()) - first;
    plan.ring.push_back({first, count});
    for (std::uint32_t i = 0; i < count; ++i) plan.next.push_back(first + (i + 1) % count);
  }
  return plan;
}

Entrant polyanya_of_disc(const path::FloorMap& map, double radius) {
  return entrant("Polyanya, offset", false, [&] {
    return std::make_shared<Polyanya>(merge_polygons(triangulate(room_for_centre(map, radius))));
  });
}

/// The queries of one radius: known ones where there are, else random ones.
std::vector<Query> queries_of(const BenchFloor& floor, const std::vector<Query>& known,
                              double radius, std::size_t count, std::mt19937_64& random) {
  std::vector<Query> queries;
  for (const Query& query : known)
    if (query.radius == radius) queries.push_back(query);
  if (queries.empty()) return random_queries(*floor.map, floor.floor.plan, radius, count, random);
  queries.resize(std::min(count, queries.size()));
  return queries;
}

bool is_as_known(const path::Way& way, const Query& query) {
  if ((way.status == path::RouteStatus::Ok) != std::isfinite(query.known_length)) return false;
  const double bracket = query.radius > 0 ? reference_bracket : 0;
  return way.status != path::RouteStatus::Ok ||
         std::abs(way.length - query.known_length) <= bracket + exact * query.known_length + 1e-9;
}

/// How many of our answers differ from the known ones.
std::ptrdiff_t count_wrong(const BenchFloor& floor, std::span<const Query> queries) {
  return std::ranges::count_if(queries, [&](const Query& query) {
    const path::RouteQuery asked{.from = query.from, .to = query.to, .radius = query.radius};
    return query.known_length != 0 && !is_as_known(path::route(*floor.map, asked), query);
  });
}

class Benchmark {
 public:
  explicit Benchmark(Options options) : options_(std::move(options)) {}

  void run() {
    print_head();
    for (const std::string& folder : options_.folders) run_folder(folder);
    for (const std::size_t vertices : options_.generated) {
      Polymap map = to_polymap(generated_museum(vertices, Turn::Slanting));
      if (is_asked_for(map.name)) run_map(map, {});
    }
    print_summary();
  }

  [[nodiscard]] std::ptrdiff_t disagreements() const { return disagreements_; }

 private:
  [[nodiscard]] bool is_asked_for(const std::string& name) const {
    return options_.only.empty() || std::ranges::find(options_.only, name) != options_.only.end();
  }

  void run_folder(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder))
      if (entry.path().extension() == ".json" && is_asked_for(entry.path().stem().string()))
        files.push_back(entry.path());
    std::ranges::sort(files);
    const fs::path answers = folder.parent_path() / "answers";
    for (const fs::path& file : files) {
      const Polymap map = read_polymap(file);
      const fs::path known = answers / (map.name + ".csv");
      run_map(map, fs::exists(known) ? read_answers(known) : std::vector<Query>{});
    }
  }

  void run_map(const Polymap& polymap, const std::vector<Query>& known) {
    std::mt19937_64 random(1);
    const double usual_radius = polymap.in_metres ? 0.25 : 0.35;

    const auto points = compile(polymap, std::vector{0.0});
    const FloorPlan& plan = points->floor.plan;
    hold(*points, queries_of(*points, known, 0, options_.queries, random),
         std::vector{our_entrant(*points, points->megabytes), visibility_graph(plan),
                     polyanya(plan), detour(plan, 0, usual_radius)},
         random);
    const auto discs = compile(polymap, std::vector{0.0, usual_radius});
    const double more = discs->megabytes - points->megabytes;  // What one radius adds.
    const auto queries = queries_of(*discs, known, usual_radius, options_.queries, random);
    if (!queries.empty()) {
      const double usual_us =
          hold(*discs, queries,
               std::vector{our_entrant(*discs, more), detour(plan, usual_radius, usual_radius),
                           polyanya_of_disc(*discs->map, usual_radius)},
               random);
      ask_with_new_radii(*discs, queries, usual_us);
    }
    write_csv();  // After every map, so that a long run can be watched.
    write_plot();
  }

  /// What the first query with a radius costs that the compiler has not seen.
  void ask_with_new_radii(const BenchFloor& floor, std::span<const Query> queries,
                          double usual_us) {
    std::vector<double> microseconds;
    for (std::size_t i = 0; i < std::min(new_radii, queries.size()); ++i) {
      const Query& query = queries[i];
      const double radius = query.radius * (1 - 0.01 * static_cast<double>(i + 1));
      const double begin = now();
      path::route(*floor.map, {.from = query.from, .to = query.to, .radius = radius});
      microseconds.push_back((now() - begin) * 1e6);
    }
    Score score;
    score.median_us = median(microseconds), score.p99_us = quantile(microseconds, 0.99);
    rows_.push_back({floor.name, floor.floor.plan.vertex.size(), queries.front().radius,
                     "docent (new R)", true, score, score.median_us / usual_us, 0, 0});
    print(rows_.back());
  }

  /// One contest on one floor, with at least one query; returns our median.
  double hold(const BenchFloor& floor, std::span<const Query> queries,
              std::span<const Entrant> entrants, std::mt19937_64& random) {
    if (const auto wrong = count_wrong(floor, queries); wrong > 0) {
      fmt::print("{}: {} of our answers are not the known ones\n", floor.name, wrong);
      disagreements_ += wrong;
    }
    const std::vector<Score> scores = contest(entrants, queries, options_.rounds, random);
    for (std::size_t e = 0; e < entrants.size(); ++e) {
      const Entrant& entrant = entrants[e];
      rows_.push_back({floor.name, floor.floor.plan.vertex.size(), queries.front().radius,
                       entrant.name, entrant.is_exact, scores[e],
                       scores[e].median_us / scores[0].median_us, entrant.made_in_seconds,
                       entrant.megabytes});
      print(rows_.back());
      if (entrant.is_exact)
        disagreements_ += scores[e].other_verdicts + (scores[e].worst_error > exact ? 1 : 0);
    }
    return scores.front().median_us;
  }

  static void print_head() {
    fmt::print("{:<38.38} {:>8} {:>5} {:<16} {:>10} {:>10} {:>7} {:>11} {:>6} {:>8} {:>8}\n", "map",
               "vertices", "R", "who", "median us", "99 % us", "x ours", "worst error", "other",
               "made s", "MB");
  }

  static void print(const Row& row) {
    fmt::print(
        "{:<38.38} {:>8} {:>5} {:<16} {:>10.2f} {:>10.2f} {:>7.1f} {:>11.2g} {:>6} {:>8.2f} "
        "{:>8.2f}\n",
        row.map, row.vertices, row.radius, row.who, row.score.median_us, row.score.p99_us,
        row.ratio, row.score.worst_error, row.score.other_verdicts, row.made_in_seconds,
        row.megabytes);
    std::fflush(stdout);
  }

  /// Ratios by competitor, apart for points and discs.
  void print_summary() const {
    std::map<std::string, std::vector<const Row*>> by_competitor;
    for (const Row& row : rows_)
      if (!row.who.starts_with("docent"))
        by_competitor[row.who + (row.radius > 0 ? ", a disc" : ", a point")].push_back(&row);
    fmt::print("\n{:<28} {:>6} {:>12} {:>14} {:>22}\n", "competitor", "maps", "slower on",
               "median ratio", "ratio from 900 vertices");
    for (const auto& [name, rows] : by_competitor) {
      std::vector<double> all, large;
      for (const Row* row : rows) {
        all.push_back(row->ratio);
        if (row->vertices >= large_floor) large.push_back(row->ratio);
      }
      const auto slower = std::ranges::count_if(all, [](double ratio) { return ratio > 1; });
      fmt::print("{:<28} {:>6} {:>12} {:>14.1f} {:>14.1f} ({} maps)\n", name, all.size(), slower,
                 median(all), median(large), large.size());
    }
    fmt::print("peak memory of the whole run: {:.0f} MB\n", peak_megabytes());
  }

  void write_csv() const {
    std::ofstream file(fs::path(options_.out) / "paths.csv");
    file << "map,vertices,radius,who,median_us,p99_us,ratio,worst_error,other_verdicts,made_s,"
            "megabytes\n";
    for (const Row& row : rows_)
      file << fmt::format("{},{},{},\"{}\",{:.3f},{:.3f},{:.3f},{:.3g},{},{:.4f},{:.3f}\n", row.map,
                          row.vertices, row.radius, row.who, row.score.median_us, row.score.p99_us,
                          row.ratio, row.score.worst_error, row.score.other_verdicts,
                          row.made_in_seconds, row.megabytes);
  }

  [[nodiscard]] Series series_of(const std::string& who, bool is_disc, std::string_view colour,
                                 Series::Mark mark) const {
    Series series{.name = who, .colour = std::string(colour), .mark = mark};
    for (const Row& row : rows_)
      if (row.who == who && (row.radius > 0) == is_disc)
        series.dots.emplace_back(static_cast<double>(row.vertices), row.score.median_us);
    series.line = medians_by_octave(series.dots);
    return series;
  }

  void write_plot() const {
    using Mark = Series::Mark;
    const auto ours = [&](bool is_disc) {
      return series_of("docent", is_disc, draw::ink::vermilion, Mark::Disc);
    };
    const auto detours = [&](bool is_disc) {
      return series_of("Detour", is_disc, draw::ink::teal, Mark::Square);
    };
    const std::string x = "vertices of the floor", y = "microseconds, median of a map's queries";
    const Panel points{
        "A point, R = 0",
        x,
        y,
        {ours(false), series_of("visibility graph", false, draw::ink::ochre, Mark::Ring),
         series_of("Polyanya", false, draw::ink::black, Mark::Diamond), detours(false)}};
    const Panel discs{
        "A disc of the usual radius",
        x,
        y,
        {ours(true), series_of("Polyanya, offset", true, draw::ink::black, Mark::Diamond),
         detours(true)}};
    std::ofstream(fs::path(options_.out) / "paths.svg")
        << draw_panels("One shortest path, its points in memory",
                       "A faint dot is a floor; the lines are medians of floors of similar size. "
                       "One thread, one run. Detour's paths are not exact.",
                       {points, discs});
  }

  Options options_;
  std::vector<Row> rows_;
  std::ptrdiff_t disagreements_ = 0;
};

}  // namespace
}  // namespace docent::bench

int main(int argc, char** argv) {
  using namespace docent;
  bench::Options options;
  const auto plans = test::reference_data() / "floorplans";
  options.folders = {(plans / "reference" / "maps").string(), (plans / "plans").string()};

  CLI::App app("Times shortest paths on many floors, ours and others'");
  app.add_option("--maps", options.folders, "folders of polymaps; answers are looked for beside");
  app.add_option("--only", options.only, "names of maps")->delimiter(',');
  app.add_option("--generated", options.generated, "vertices of generated museums to measure, too")
      ->delimiter(',');
  app.add_option("--queries", options.queries, "per map and radius")->check(CLI::PositiveNumber);
  app.add_option("--repeat", options.rounds, "rounds")->check(CLI::PositiveNumber);
  app.add_option("-o", options.out, "folder for paths.csv and paths.svg")
      ->check(CLI::ExistingDirectory);
  CLI11_PARSE(app, argc, argv);

  bench::Benchmark benchmark(std::move(options));
  try {
    benchmark.run();
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_paths: {}\n", error.what());
    return 2;
  }
  return benchmark.disagreements() == 0 ? 0 : 1;
}
