// How good and how fast are walks along a path, beside the paper's search and plain motion matching
// on the same clips? How does their time grow with the path? And what does an avatar cost a frame?

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numbers>

#include "content/draw/svg.h"
#include "content/motion/compile_motion.h"
#include "content/motion/paper_walk.h"
#include "runtime/model/geometry/polyline.h"
#include "runtime/motion/make_foresight.h"
#include "runtime/motion/path_track.h"
#include "runtime/motion/pose.h"
#include "runtime/motion/walk_graph.h"
#include "tests/bench/measure.h"
#include "tests/bench/motion_matching.h"
#include "tests/bench/plot.h"
#include "tests/bench/walk_picture.h"
#include "tests/bench/walk_quality.h"
#include "tests/bench/walk_shapes.h"
#include "tests/support/reference_data.h"

namespace docent::bench {
namespace {

struct Options {
  std::string clips = (test::reference_data() / "mocap/cmu-walk").string(), out = ".";
  double time_limit = 20;  ///< Seconds of the paper's search for a path.
  int rounds = 3;
  std::vector<double> lengths{2, 4, 8, 16, 33, 66, 132, 264, 528};
  std::vector<std::size_t> avatars{1, 10, 50, 100, 200, 400};
};

/// Who walks, and how its results are drawn.
struct Walker {
  std::string name;
  std::string colour;
  Series::Mark mark;
  std::function<motion::Walk(std::span<const Vec2>)> walk;
};

motion::Walk walk_by_docent(const motion::WalkGraph& graph, std::span<const Vec2> path,
                            motion::Fidelity fidelity) {
  motion::WalkRequest request;
  request.path = path;
  request.fidelity = fidelity;
  Result<motion::Walk> walk = motion::make_walk(graph, request);
  if (!walk) throw std::runtime_error(walk.error().what);
  return std::move(*walk);
}

std::vector<Walker> make_walkers(const motion::WalkGraph& graph, const MotionMatcher& matcher,
                                 double time_limit) {
  using Mark = Series::Mark;
  const auto docent = [&graph](motion::Fidelity fidelity) {
    return [&graph, fidelity](std::span<const Vec2> path) {
      return walk_by_docent(graph, path, fidelity);
    };
  };
  const auto paper = [&graph, time_limit](double lookahead, double use_rate) {
    return [&graph, time_limit, lookahead, use_rate](std::span<const Vec2> path) {
      return motion::offline::make_paper_walk(graph, {.path = path,
                                                      .start = {},
                                                      .lookahead = lookahead,
                                                      .use_rate = use_rate,
                                                      .time_limit = time_limit})
          .walk;
    };
  };
  return {
      {"docent, exact", std::string(draw::ink::teal), Mark::Disc, docent(motion::Fidelity::Exact)},
      {"docent, raw", std::string(draw::ink::ochre), Mark::Ring, docent(motion::Fidelity::Raw)},
      {"paper, 1 m, 0.3", std::string(draw::ink::vermilion), Mark::Square, paper(1.0, 0.3)},
      {"motion matching", std::string(draw::ink::black), Mark::Diamond,
       [&matcher](std::span<const Vec2> path) { return matcher.walk_along(path, {}); }}};
}

/// A walk and the median time that it took to make.
struct Timed {
  motion::Walk walk;
  double seconds = 0;
};

Timed timed(const Walker& walker, std::span<const Vec2> path, int rounds) {
  Timed result;
  std::vector<double> seconds;
  const double began = now();
  for (int round = 0; round < rounds; ++round) {
    const double before = now();
    result.walk = walker.walk(path);
    seconds.push_back(now() - before);
    if (now() - began > 2) break;
  }
  result.seconds = median(seconds);
  return result;
}

std::vector<WalkShape> contest_paths() {
  std::vector<WalkShape> paths{{"ellipse, 33 m", elliptic_arc()}};
  std::vector<Vec2> eight;
  for (int i = 0; i <= 400; ++i) {
    const double u = 2 * std::numbers::pi * i / 400;
    eight.emplace_back(4.3 * std::sin(u), 2.75 * std::sin(2 * u));
  }
  paths.push_back({"figure eight", eight});
  paths.push_back({"square of 6 m", {{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 0}}});
  for (WalkShape& shape : basic_shapes()) paths.push_back(std::move(shape));
  return paths;
}

class Contest {
 public:
  Contest(const motion::WalkGraph& graph, const std::vector<Walker>& walkers,
          const Options& options)
      : graph_(graph), walkers_(walkers), options_(options), csv_(file("walks.csv")) {}

  void compare_on_paths() {
    fmt::print("{:<20} {:<16} {:>9} {:>9} {:>7} {:>7} {:>7} {:>7} {:>7} {:>7} {:>8} {:>8}\n",
               "path", "walker", "search ms", "total ms", "mean cm", "max cm", "skate", "drift",
               "flat %", "blends", "seconds", "end gap");
    csv_ << "path,walker,search_seconds,total_seconds,deviation_mean,deviation_max,skate,drift_p95,"
            "flat_share,blends,seconds,end_gap,reached,path_length\n";
    std::vector<WalkPicture> pictures;
    for (const WalkShape& shape : contest_paths()) {
      pictures.push_back({.title = shape.name, .captions = {}, .path = shape.path, .tracks = {}});
      for (const Walker& walker : walkers_) compare(walker, shape, pictures.back());
    }
    const WalkPicture arc = pictures.front();
    pictures.erase(pictures.begin());
    std::vector<LegendEntry> legend;
    for (const Walker& walker : walkers_) legend.push_back({walker.name, walker.colour});
    std::ofstream(file("walks.svg"))
        << draw_walks("Four ways to walk with the same seven clips",
                      "The hips, with the sway of the gait. Deviation in cm, mean / largest; skate "
                      "in cm/s; milliseconds until the walk can be played.",
                      legend, pictures, 4);
  }

  void grow() {
    std::vector<Series> seconds, deviation;
    fmt::print("\n{:<16} {:>8} {:>10} {:>10} {:>9}\n", "walker", "metres", "search ms", "total ms",
               "mean cm");
    for (const Walker& walker : walkers_) {
      Series time{.name = walker.name, .colour = walker.colour, .mark = walker.mark};
      Series off = time;
      for (const double length : options_.lengths) {
        const std::vector<Vec2> path = winding_way(length);
        const Timed result = timed(walker, path, options_.rounds);
        const WalkQuality quality = measure_walk(graph_.motion->skeleton, rest_, result.walk, path);
        time.line.emplace_back(length, result.seconds);
        off.line.emplace_back(length, 100 * quality.deviation.mean);
        fmt::print("{:<16} {:>8} {:>10.2f} {:>10.2f} {:>9.2f}\n", walker.name, length,
                   result.walk.search_seconds * 1e3, result.seconds * 1e3,
                   100 * quality.deviation.mean);
        std::fflush(stdout);
      }
      const double exponent =
          fit_power_law(std::span(time.line).subspan(time.line.size() / 2)).exponent;
      time.label = fmt::format("{:.0f} us/m, n^{:.2f}",
                               time.line.back().y / time.line.back().x * 1e6, exponent);
      off.label = fmt::format("{:.1f} cm", off.line.back().y);
      seconds.push_back(std::move(time));
      deviation.push_back(std::move(off));
    }
    std::ofstream(file("walk_growth.svg")) << draw_panels(
        "Walks along a winding way", "Seven recorded clips; bends of radii from 0.9 m.",
        {{"Time until the walk can be played", "metres of path", "seconds, median", seconds},
         {"Deviation", "metres of path", "centimetres, mean", deviation}});
  }

  void avatars() const;

 private:
  std::filesystem::path file(const char* name) const {
    return std::filesystem::path(options_.out) / name;
  }

  void compare(const Walker& walker, const WalkShape& shape, WalkPicture& picture) {
    const Timed result = timed(walker, shape.path, options_.rounds);
    const WalkQuality q = measure_walk(graph_.motion->skeleton, rest_, result.walk, shape.path);
    const motion::Walk& walk = result.walk;
    fmt::print(
        "{:<20} {:<16} {:>9.2f} {:>9.2f} {:>7.1f} {:>7.1f} {:>7.1f} {:>7.0f} {:>7.0f} {:>7} "
        "{:>8.1f} "
        "{:>8.2f}\n",
        shape.name, walker.name, walk.search_seconds * 1e3, result.seconds * 1e3,
        q.deviation.mean * 100, q.deviation.largest * 100, q.skate * 100, q.drift * 1000,
        q.flat_share * 100, walk.transitions, q.seconds, q.end_gap);
    std::fflush(stdout);
    csv_ << fmt::format("\"{}\",\"{}\",{},{},{},{},{},{},{},{},{},{},{},{}\n", shape.name,
                        walker.name, walk.search_seconds, result.seconds, q.deviation.mean,
                        q.deviation.largest, q.skate, q.drift, q.flat_share, walk.transitions,
                        q.seconds, q.end_gap, q.deviation.reached, polyline_length(shape.path));
    picture.captions.push_back(fmt::format(
        "{}: {:.1f} / {:.1f}, skate {:.1f}, {:.1f} ms", walker.name, q.deviation.mean * 100,
        q.deviation.largest * 100, q.skate * 100, result.seconds * 1e3));
    picture.tracks.push_back({floor_track(walk), walker.colour});
  }

  const motion::WalkGraph& graph_;
  RestingHeights rest_ = resting_heights(*graph_.motion);
  const std::vector<Walker>& walkers_;
  const Options& options_;
  std::ofstream csv_;
};

/// A hall of avatars, each with a walk of its own and buffers of its own, as the kiosk has them.
class Hall {
 public:
  Hall(const motion::WalkGraph& graph, std::size_t avatars) : skeleton_(graph.motion->skeleton) {
    std::vector<motion::Walk> walks;
    for (const double length : {9.0, 10.0, 11.0, 12.0})
      walks.push_back(walk_by_docent(graph, winding_way(length), motion::Fidelity::Exact));
    for (std::size_t a = 0; a < avatars; ++a) walk_.push_back(walks[a % walks.size()]);
    const std::size_t joints = skeleton_.joint.size();
    inverse_bind_.assign(joints, Mat4(1));
    rotation_.resize(avatars * joints);
    world_.resize(joints);
    palette_.resize(avatars * joints);
  }

  void step(double seconds) {
    const std::size_t joints = inverse_bind_.size();
    for (std::size_t a = 0; a < walk_.size(); ++a) {
      motion::PoseView pose{{}, std::span(rotation_).subspan(a * joints, joints)};
      motion::sample(walk_[a], std::fmod(seconds + 0.7 * static_cast<double>(a), 8), pose);
      motion::to_world_space(skeleton_, pose, world_);
      motion::fill_skinning_palette(world_, inverse_bind_,
                                    std::span(palette_).subspan(a * joints, joints));
    }
  }

 private:
  const Skeleton& skeleton_;
  std::vector<motion::Walk> walk_;
  std::vector<Mat4> inverse_bind_, world_, palette_;
  std::vector<Quat> rotation_;
};

void Contest::avatars() const {
  Series median_line{
      .name = "docent, median", .colour = std::string(draw::ink::teal), .mark = Series::Mark::Disc};
  Series worst{.name = "docent, 99 %",
               .colour = std::string(draw::ink::vermilion),
               .mark = Series::Mark::Square};
  Series goal{.name = "goal",
              .colour = std::string(draw::ink::black),
              .label = "goal: 15 us each",
              .is_dashed = true};
  fmt::print("\n{:>8} {:>10} {:>10} {:>12}\n", "avatars", "ms", "ms, 99 %", "us an avatar");
  for (const std::size_t avatars : options_.avatars) {
    Hall hall(graph_, avatars);
    std::vector<double> seconds;
    for (int frame = 0; frame < 600; ++frame) {
      const double before = now();
      hall.step(frame / 60.0);
      if (frame >= 60) seconds.push_back(now() - before);
    }
    const auto n = static_cast<double>(avatars);
    median_line.line.emplace_back(n, median(seconds) * 1e3);
    worst.line.emplace_back(n, quantile(seconds, 0.99) * 1e3);
    goal.line.emplace_back(n, 0.015 * n);
    fmt::print("{:>8} {:>10.3f} {:>10.3f} {:>12.2f}\n", avatars, median(seconds) * 1e3,
               quantile(seconds, 0.99) * 1e3, median(seconds) / n * 1e6);
  }
  median_line.label =
      fmt::format("{:.1f} us each", median_line.line.back().y / median_line.line.back().x * 1e3);
  worst.label = "99 %";
  std::ofstream(file("avatars.svg")) << draw_panels(
      "Avatars in a frame",
      fmt::format(
          "Sampling a walk, world transforms and skinning palette of {} joints; each avatar "
          "has a walk of its own.",
          graph_.motion->skeleton.joint.size()),
      {{"Time on one core", "avatars", "milliseconds a frame", {median_line, worst, goal}}});
}

void run(const Options& options) {
  std::vector<Diagnostic> problems;
  MotionGraph motion = motion::offline::compile_motion(options.clips, {}, problems);
  const Result<motion::WalkGraph> graph = motion::make_walk_graph(motion);
  if (graph) motion.foresight = motion::make_foresight(*graph);
  if (!graph) throw std::runtime_error(graph.error().what);
  const MotionMatcher matcher(*graph);
  const std::vector<Walker> walkers = make_walkers(*graph, matcher, options.time_limit);
  fmt::print("{} clips, {} transitions; skate in cm/s, drift in mm (95 % of the plants)\n",
             motion.clips.size(), motion.transitions.size());
  Contest contest(*graph, walkers, options);
  contest.compare_on_paths();
  contest.grow();
  contest.avatars();
}

}  // namespace
}  // namespace docent::bench

int main(int argc, char** argv) {
  using namespace docent;
  bench::Options options;
  CLI::App app("Compares walks with the paper's search and with motion matching");
  app.add_option("--clips", options.clips, "folder of recordings")->check(CLI::ExistingDirectory);
  app.add_option("--time-limit", options.time_limit, "seconds of the paper's search for a path")
      ->check(CLI::PositiveNumber);
  app.add_option("--repeat", options.rounds, "rounds")->check(CLI::PositiveNumber);
  app.add_option("--lengths", options.lengths, "metres of winding way, ascending")->delimiter(',');
  app.add_option("--avatars", options.avatars, "how many, ascending")->delimiter(',');
  app.add_option("-o", options.out, "folder for walks.csv and the pictures")
      ->check(CLI::ExistingDirectory);
  CLI11_PARSE(app, argc, argv);
  try {
    bench::run(options);
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_walk: {}\n", error.what());
    return 2;
  }
  return 0;
}
