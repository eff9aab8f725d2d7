// The founding paper's Table 1 on its own seven clips: how long does its search take here, how
// close does it keep to the path, and how do docent's do on the same rows? A row is one draw: the
// same search begun facing a fifth of a degree elsewhere may end a metre away, so each is run at
// many headings. Draws the nine tracks at the heading in print (its Figure 3) and docent's walks
// along the basic shapes (its Figure 8).

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numbers>

#include "content/draw/svg.h"
#include "content/motion/compile_motion.h"
#include "content/motion/paper_walk.h"
#include "runtime/motion/make_foresight.h"
#include "runtime/motion/walk_graph.h"
#include "tests/bench/measure.h"
#include "tests/bench/walk_picture.h"
#include "tests/bench/walk_quality.h"
#include "tests/bench/walk_shapes.h"
#include "tests/support/reference_data.h"

namespace docent::bench {
namespace {

/// A row of Table 1. The paper's places are (x, up, z): its (0.5, 0, -0.5) is our floor's (0.5,
/// 0.5).
struct Row {
  Placement start;
  double lookahead, use_rate;
  double paper_seconds;  ///< On an Athlon64 X2 3600+.
};

constexpr double minus_45_degrees = -std::numbers::pi / 4;
constexpr std::array<Row, 9> table1{{{{{0, 0}, 0}, 1.0, 0.3, 72},
                                     {{{0, 0}, 0}, 0.5, 0.3, 7},
                                     {{{0, 0}, 0}, 0.5, 1.0, 2},
                                     {{{0, 0}, 0}, 0.6, 0.5, 9},
                                     {{{0, 0}, 0}, 0.7, 0.5, 19},
                                     {{{0, 0}, 0}, 0.8, 0.5, 46},
                                     {{{0, 0}, 0}, 1.0, 0.5, 32},
                                     {{{0, 0}, minus_45_degrees}, 1.0, 0.5, 166},
                                     {{{0.5, 0.5}, 0}, 1.0, 0.5, 217}}};

struct Options {
  std::string clips = (test::reference_data() / "mocap/cmu-walk").string(), out = ".";
  double time_limit = 60;  ///< Seconds a row.
  int rounds = 5;
  int headings = 100;  ///< In which a row is begun, evenly within 5 degrees of its own.
};

/// A search on a row: the median time of its rounds, and its walk.
struct Answer {
  double seconds = 0;  ///< Of search.
  double total = 0;    ///< With everything that follows until the walk can be played.
  motion::Walk walk;
  WalkQuality quality;
  bool reaches_end = true;
};

/// A search on a row begun at many headings: seconds, metres.
struct Draws {
  std::vector<double> seconds, mean, largest, reached;

  void add(const Answer& answer, double taken) {
    seconds.push_back(taken);
    mean.push_back(answer.quality.deviation.mean);
    largest.push_back(answer.quality.deviation.largest);
    reached.push_back(answer.quality.deviation.reached);
  }
};

/// The median and between what nine tenths lie; in hundredths.
std::string spread_text(const std::vector<double>& values) {
  return fmt::format("{:.1f} ({:.1f} to {:.1f})", 100 * median(values),
                     100 * quantile(values, 0.05), 100 * quantile(values, 0.95));
}

class Table1 {
 public:
  Table1(const motion::WalkGraph& graph, const Options& options)
      : graph_(graph), options_(options), path_(elliptic_arc()), csv_(file("table1.csv")) {}

  void run() {
    print_head();
    for (std::size_t i = 0; i < table1.size(); ++i) run_row(i);
    print_draws_head();
    for (std::size_t i = 0; i < table1.size(); ++i) draw_headings(i);
    draw_rows();
    draw_shapes();
  }

 private:
  std::filesystem::path file(const char* name) const {
    return std::filesystem::path(options_.out) / name;
  }

  /// Rounds end early where they take long.
  template <typename Search>
  Answer timed(const Search& search, int rounds) const {
    Answer answer;
    std::vector<double> seconds, totals;
    const double began = now();
    for (int round = 0; round < rounds; ++round) {
      const double before = now();
      search(answer);
      totals.push_back(now() - before);
      seconds.push_back(answer.walk.search_seconds);
      if (now() - began > 2) break;
    }
    answer.seconds = median(seconds);
    answer.total = median(totals);
    answer.quality = measure_walk(graph_.motion->skeleton, rest_, answer.walk, path_);
    return answer;
  }

  Answer search_paper(const Row& row, motion::offline::PaperRequest::Bound bound,
                      int rounds) const {
    return timed(
        [&](Answer& answer) {
          motion::offline::PaperWalk found =
              motion::offline::make_paper_walk(graph_, {.path = path_,
                                                        .start = row.start,
                                                        .lookahead = row.lookahead,
                                                        .use_rate = row.use_rate,
                                                        .time_limit = options_.time_limit,
                                                        .bound = bound});
          answer.reaches_end = found.reaches_end;
          answer.walk = std::move(found.walk);
        },
        rounds);
  }

  Answer search_docent(const Row& row, motion::Fidelity fidelity, int rounds) const {
    return timed(
        [&](Answer& answer) {
          motion::WalkRequest request;
          request.path = path_;
          request.start = row.start;
          request.fidelity = fidelity;
          Result<motion::Walk> walk = motion::make_walk(graph_, request);
          if (!walk) throw std::runtime_error(walk.error().what);
          answer.walk = std::move(*walk);
        },
        rounds);
  }

  void print_head() {
    fmt::print(
        "33 m of an ellipse, {} clips, {} transitions. Milliseconds of search (exact: until it can "
        "be played); deviation in cm, mean / max; ratio: the paper's search here to docent "
        "exact.\n",
        graph_.motion->clips.size(), graph_.motion->transitions.size());
    fmt::print(
        "{:<3} {:<11} {:>5} {:>5} | {:>7} | {:>9} {:>9} {:>13} {:>7} | {:>7} {:>12} | {:>7} {:>12} "
        "| {:>7} {:>8}\n",
        "row", "start", "Lstep", "Ruse", "paper s", "here ms", "bounded", "deviation", "reached",
        "raw ms", "deviation", "exact", "deviation", "ratio", "printed");
    csv_ << "row,x,y,heading,lookahead,use_rate,paper_seconds,here_seconds,here_bounded_seconds,"
            "here_expanded,here_transitions,here_reaches_end,here_reached,here_mean,here_max,"
            "raw_seconds,raw_mean,raw_max,exact_seconds,exact_mean,exact_max\n";
  }

  static std::string deviation_text(const WalkQuality& quality) {
    return fmt::format("{:.1f} / {:.1f}", quality.deviation.mean * 100,
                       quality.deviation.largest * 100);
  }

  void run_row(std::size_t i) {
    const Row& row = table1[i];
    const Answer here =
        search_paper(row, motion::offline::PaperRequest::Bound::AsPrinted, options_.rounds);
    const Answer bounded =
        search_paper(row, motion::offline::PaperRequest::Bound::OnTheWay, options_.rounds);
    const Answer raw = search_docent(row, motion::Fidelity::Raw, options_.rounds);
    const Answer exact = search_docent(row, motion::Fidelity::Exact, options_.rounds);
    const double degrees = row.start.heading * 180 / std::numbers::pi;
    const std::string start =
        fmt::format("{:g} {:g} {:g}", row.start.position.x, row.start.position.y, degrees);
    fmt::print(
        "{:<3} {:<11} {:>5.1f} {:>5.1f} | {:>7} | {:>9.1f} {:>9.1f} {:>13} {:>6.1f}{} | {:>7.1f} "
        "{:>12} | {:>7.1f} {:>12} | {:>7.2f} {:>8.0f}\n",
        i + 1, start, row.lookahead, row.use_rate, row.paper_seconds, here.seconds * 1e3,
        bounded.seconds * 1e3, deviation_text(here.quality), here.quality.deviation.reached,
        here.reaches_end ? ' ' : '!', raw.seconds * 1e3, deviation_text(raw.quality),
        exact.total * 1e3, deviation_text(exact.quality), here.seconds / exact.total,
        row.paper_seconds / exact.total);
    std::fflush(stdout);
    csv_ << fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", i + 1,
                        row.start.position.x, row.start.position.y, degrees, row.lookahead,
                        row.use_rate, row.paper_seconds, here.seconds, bounded.seconds,
                        here.walk.expanded, here.walk.transitions, here.reaches_end ? 1 : 0,
                        here.quality.deviation.reached, here.quality.deviation.mean,
                        here.quality.deviation.largest, raw.seconds, raw.quality.deviation.mean,
                        raw.quality.deviation.largest, exact.total, exact.quality.deviation.mean,
                        exact.quality.deviation.largest);
    pictures_.push_back(
        {.title = fmt::format("{}: L_step {:g} m, R_use {:g}{}", i + 1, row.lookahead, row.use_rate,
                              where(row)),
         .captions = {fmt::format("paper's search {:.0f} ms, {} cm ({:.0f} s in print)",
                                  here.seconds * 1e3, deviation_text(here.quality),
                                  row.paper_seconds),
                      fmt::format("docent raw {:.0f} ms, {} cm; exact {:.0f} ms, {} cm",
                                  raw.seconds * 1e3, deviation_text(raw.quality), exact.total * 1e3,
                                  deviation_text(exact.quality))},
         .path = path_,
         .tracks = {{floor_track(exact.walk), std::string(draw::ink::teal)},
                    {floor_track(here.walk), std::string(draw::ink::vermilion)}}});
  }

  void print_draws_head() const {
    fmt::print(
        "\nThe same rows begun at {} headings within 5 degrees of their own: median (5 to 95 %), "
        "deviation in cm.\n{:<3} | {:>9} {:>24} {:>26} {:>8} | {:>9} {:>20} {:>22}\n",
        options_.headings, "row", "paper ms", "mean", "largest", "reached", "docent ms", "mean",
        "largest");
  }

  void draw_headings(std::size_t i) const {
    constexpr double widest = 5 * std::numbers::pi / 180;
    Draws paper, docent;
    for (int h = 0; h < options_.headings; ++h) {
      Row row = table1[i];
      row.start.heading += widest * (2 * (h + 0.5) / options_.headings - 1);
      const Answer here = search_paper(row, motion::offline::PaperRequest::Bound::AsPrinted, 1);
      paper.add(here, here.seconds);
      const Answer exact = search_docent(row, motion::Fidelity::Exact, 1);
      docent.add(exact, exact.total);
    }
    fmt::print("{:<3} | {:>9.1f} {:>24} {:>26} {:>8.1f} | {:>9.1f} {:>20} {:>22}\n", i + 1,
               median(paper.seconds) * 1e3, spread_text(paper.mean), spread_text(paper.largest),
               median(paper.reached), median(docent.seconds) * 1e3, spread_text(docent.mean),
               spread_text(docent.largest));
    std::fflush(stdout);
  }

  static std::string where(const Row& row) {
    if (row.start.heading != 0) return ", facing 45 degrees to the right";
    if (row.start.position != Vec2{}) return ", from (0.5, 0.5)";
    return "";
  }

  void draw_rows() const {
    std::ofstream(file("table1.svg")) << draw_walks(
        "Table 1 and Figure 3: nine walks along 33 m of an ellipse",
        "The hips of seven recorded clips, with the sway of the gait. Deviation: mean / largest, "
        "averaged over a second. In print: on an Athlon64 X2 3600+.",
        {{"the paper's search", std::string(draw::ink::vermilion)},
         {"docent, exact", std::string(draw::ink::teal)}},
        pictures_, 3);
  }

  void draw_shapes() const {
    std::vector<WalkPicture> pictures;
    for (const WalkShape& shape : basic_shapes()) {
      WalkPicture picture{.title = shape.name, .captions = {}, .path = shape.path, .tracks = {}};
      for (const motion::Fidelity fidelity : {motion::Fidelity::Raw, motion::Fidelity::Exact}) {
        const bool is_raw = fidelity == motion::Fidelity::Raw;
        motion::WalkRequest request;
        request.path = shape.path;
        request.fidelity = fidelity;
        const Result<motion::Walk> walk = motion::make_walk(graph_, request);
        if (!walk) throw std::runtime_error(walk.error().what);
        const WalkQuality quality = measure_walk(graph_.motion->skeleton, rest_, *walk, shape.path);
        picture.captions.push_back(fmt::format("{}: {} cm, {:.1f} s, skate {:.1f} cm/s",
                                               is_raw ? "raw" : "exact", deviation_text(quality),
                                               quality.seconds, quality.skate * 100));
        picture.tracks.push_back(
            {floor_track(*walk), std::string(is_raw ? draw::ink::ochre : draw::ink::teal)});
      }
      pictures.push_back(std::move(picture));
    }
    std::ofstream(file("shapes.svg")) << draw_walks(
        "Figure 8: what the ways through a museum are made of",
        "docent's walks of seven recorded clips: the motion graph's own track, and warped onto the "
        "path. The hips, with the sway of the gait.",
        {{"raw", std::string(draw::ink::ochre)}, {"exact", std::string(draw::ink::teal)}}, pictures,
        4);
  }

  const motion::WalkGraph& graph_;
  RestingHeights rest_ = resting_heights(*graph_.motion);
  const Options& options_;
  std::vector<Vec2> path_;
  std::ofstream csv_;
  std::vector<WalkPicture> pictures_;
};

void run(const Options& options) {
  std::vector<Diagnostic> problems;
  MotionGraph motion = motion::offline::compile_motion(options.clips, {}, problems);
  const Result<motion::WalkGraph> graph = motion::make_walk_graph(motion);
  if (graph) motion.foresight = motion::make_foresight(*graph);
  if (!graph) throw std::runtime_error(graph.error().what);
  Table1(*graph, options).run();
}

}  // namespace
}  // namespace docent::bench

int main(int argc, char** argv) {
  using namespace docent;
  bench::Options options;
  CLI::App app("Runs the nine rows of the paper's Table 1 and draws its Figures 3 and 8");
  app.add_option("--clips", options.clips, "folder of recordings")->check(CLI::ExistingDirectory);
  app.add_option("--time-limit", options.time_limit, "seconds of search a row")
      ->check(CLI::PositiveNumber);
  app.add_option("--repeat", options.rounds, "rounds")->check(CLI::PositiveNumber);
  app.add_option("--headings", options.headings, "at which each row is begun")
      ->check(CLI::PositiveNumber);
  app.add_option("-o", options.out, "folder for table1.csv, table1.svg and shapes.svg")
      ->check(CLI::ExistingDirectory);
  CLI11_PARSE(app, argc, argv);
  try {
    bench::run(options);
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_table1: {}\n", error.what());
    return 2;
  }
  return 0;
}
