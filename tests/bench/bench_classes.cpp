// How much of a motion graph of several classes does a search touch, and how long does it take,
// with classes (section 3.2 of the paper) and without, and how well is the path kept to?

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>

#include "content/motion/compile_motion.h"
#include "runtime/motion/make_foresight.h"
#include "tests/bench/measure.h"
#include "tests/bench/walk_quality.h"
#include "tests/bench/walk_shapes.h"
#include "tests/support/reference_data.h"

namespace docent::bench {
namespace {

struct Options {
  std::vector<std::string> clips{(test::reference_data() / "mocap/cmu-walk").string(),
                                 (test::reference_data() / "mocap/cmu-varied").string()};
  int rounds = 9;
};

std::vector<WalkShape> shapes() {
  std::vector<Vec2> eight;
  for (int i = 0; i <= 400; ++i) {
    const double u = 2 * std::numbers::pi * i / 400;
    eight.emplace_back(4.3 * std::sin(u), 2.75 * std::sin(2 * u));
  }
  std::vector<WalkShape> shapes{{"ellipse, 33 m", elliptic_arc()},
                                {"figure eight", eight},
                                {"square of 6 m", {{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 0}}},
                                {"winding, 66 m", winding_way(66)}};
  for (WalkShape& shape : basic_shapes()) shapes.push_back(std::move(shape));
  return shapes;
}

/// A graph and what is needed to walk on it; stays where it is, because the graph is borrowed.
struct Walker {
  Walker(const char* of, MotionGraph of_motion) : name(of), motion(std::move(of_motion)) {
    motion.foresight = motion::make_foresight(motion::make_walk_graph(motion).value());
    graph = motion::make_walk_graph(motion).value();
  }
  Walker(const Walker&) = delete;
  Walker& operator=(const Walker&) = delete;
  ~Walker() = default;

  [[nodiscard]] std::size_t transitions_within(std::uint32_t scope) const {
    std::size_t within = 0;
    for (std::size_t t = 0; t < motion.transitions.size(); ++t)
      within += graph.clip[motion.transitions[t].from.clip].rank <= scope &&
                motion::leads_to_stand(graph, t, scope);
    return within;
  }

  const char* name;
  MotionGraph motion;
  motion::WalkGraph graph;
};

/// Of all measured paths.
struct Sums {
  double considered = 0, seconds = 0, mean = 0, largest = 0;
};

void print_classes(const Walker& walker) {
  const MotionGraph& motion = walker.motion;
  fmt::print("{:<16} {:>6} {:>8} {:>12}  coefficients\n", "class", "clips", "seconds",
             "transitions");
  for (const MotionClass& c : motion.classes) {
    std::size_t clips = 0;
    double seconds = 0;
    for (const MotionClip& clip : motion.clips) {
      if (clip.motion_class != c.name) continue;
      ++clips;
      seconds += frame_count(clip) / clip.frame_rate;
    }
    const auto own = std::ranges::count_if(motion.transitions, [&](const Transition& way) {
      return motion.clips[way.from.clip].motion_class == c.name &&
             motion.clips[way.to.clip].motion_class == c.name;
    });
    fmt::print("{:<16} {:>6} {:>8.1f} {:>12} ", c.name, clips, seconds, own);
    for (const float coefficient : c.coefficient) fmt::print(" {:>6.2f}", coefficient);
    fmt::print("\n");
  }
  for (std::uint32_t scope = 0; scope < walker.graph.scopes; ++scope)
    fmt::print("scope {}: {} of {} transitions\n", scope, walker.transitions_within(scope),
               motion.transitions.size());
}

/// The share of a walk's frames that each class gives, "walk 90 %, jog 10 %".
std::string classes_of(const motion::Walk& walk, const std::vector<MotionClip>& clips) {
  std::map<std::string, std::size_t> frames;
  std::size_t all = 0;
  for (std::size_t f = 0; f < walk.source.size(); ++f)
    if (walk.gait[f] == motion::Gait::Walk)
      ++frames[clips[walk.source[f].clip].motion_class], ++all;
  std::string text;
  for (const auto& [name, count] : frames)
    text += fmt::format("{}{} {:.0f} %", text.empty() ? "" : ", ", name,
                        100.0 * static_cast<double>(count) / static_cast<double>(all));
  return text;
}

void measure(const Walker& walker, const WalkShape& shape, motion::Fidelity fidelity, int rounds,
             Sums& sums) {
  motion::WalkRequest request;
  request.path = shape.path;
  request.fidelity = fidelity;
  std::vector<double> seconds;
  motion::Walk walk;
  for (int round = 0; round < rounds; ++round) {
    walk = motion::make_walk(walker.graph, request).value();
    seconds.push_back(walk.search_seconds);
  }
  const WalkQuality quality =
      measure_walk(walker.motion.skeleton, resting_heights(walker.motion), walk, shape.path);
  fmt::print("{:<18} {:<16} {:>8} {:>9} {:>8.2f} {:>8.1f} {:>8.1f}  {}\n", shape.name, walker.name,
             walker.transitions_within(walk.scope), walk.considered, median(seconds) * 1e3,
             quality.deviation.mean * 100, quality.deviation.largest * 100,
             classes_of(walk, walker.motion.clips));
  sums.considered += walk.considered;
  sums.seconds += median(seconds);
  sums.mean += quality.deviation.mean;
  sums.largest = std::max(sums.largest, quality.deviation.largest);
}

void compare(std::span<const Walker* const> walkers, motion::Fidelity fidelity, int rounds) {
  fmt::print("\n{}\n{:<18} {:<16} {:>8} {:>9} {:>8} {:>8} {:>8}\n",
             fidelity == motion::Fidelity::Raw ? "raw" : "exact", "path", "search", "in scope",
             "touched", "ms", "mean cm", "max cm");
  const std::vector<WalkShape> paths = shapes();
  std::vector<Sums> sums(walkers.size());
  for (const WalkShape& shape : paths)
    for (std::size_t i = 0; i < walkers.size(); ++i)
      measure(*walkers[i], shape, fidelity, rounds, sums[i]);
  for (std::size_t i = 0; i < walkers.size(); ++i)
    fmt::print("{:<18} {:<16} {:>8} {:>9.0f} {:>8.2f} {:>8.1f} {:>8.1f}\n", "all paths",
               walkers[i]->name, "", sums[i].considered, sums[i].seconds * 1e3,
               sums[i].mean * 100 / static_cast<double>(paths.size()), sums[i].largest * 100);
}

void run(const Options& options) {
  std::vector<Diagnostic> problems;
  const std::vector<std::filesystem::path> folders(options.clips.begin(), options.clips.end());
  const MotionGraph motion = motion::offline::compile_motion(folders, {}, problems);
  MotionGraph classless = motion;
  classless.classes.clear();
  const Walker with("with classes", motion), without("without classes", std::move(classless));
  print_classes(with);
  const Walker* const walkers[] = {&with, &without};
  for (const motion::Fidelity fidelity : {motion::Fidelity::Raw, motion::Fidelity::Exact})
    compare(walkers, fidelity, options.rounds);
}

}  // namespace
}  // namespace docent::bench

int main(int argc, char** argv) {
  using namespace docent;
  bench::Options options;
  CLI::App app("Searches in a motion graph of several classes, with and without classes");
  app.add_option("--clips", options.clips, "folders of recordings")->check(CLI::ExistingDirectory);
  app.add_option("--repeat", options.rounds, "rounds")->check(CLI::PositiveNumber);
  CLI11_PARSE(app, argc, argv);
  try {
    bench::run(options);
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_classes: {}\n", error.what());
    return 2;
  }
  return 0;
}
