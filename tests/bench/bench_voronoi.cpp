// How do the time and memory of a floor's Voronoi diagram alone grow with its walls, along the axes
// (many ties) and at an angle (none), and how do they compare with Boost.Polygon's diagram of the
// same walls in the same run?

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <fstream>
#include <functional>

#include "content/draw/svg.h"
#include "content/floor/voronoi.h"
#include "tests/bench/boost_diagram.h"
#include "tests/bench/generated_floors.h"
#include "tests/bench/measure.h"
#include "tests/bench/plot.h"

namespace docent::bench {
namespace {

struct Cost {
  double seconds = 0;    ///< The median of the rounds.
  double megabytes = 0;  ///< At most, beyond what was in use before.
};

Cost cost_of(int rounds, const std::function<void()>& make) {
  forget_peak();
  const double before = peak_megabytes();
  std::vector<double> seconds;
  for (int round = 0; round < rounds; ++round) {
    const double begin = now();
    make();
    seconds.push_back(now() - begin);
  }
  return {median(seconds), peak_megabytes() - before};
}

/// One maker of diagrams on one layout of walls, as a line of each plot.
struct Growth {
  Series seconds, megabytes;

  Growth(const std::string& name, std::string_view colour, Series::Mark mark)
      : seconds{.name = name, .colour = std::string(colour), .mark = mark}, megabytes(seconds) {}

  void add(std::size_t walls, const Cost& cost) {
    const auto n = static_cast<double>(walls);
    seconds.line.emplace_back(n, cost.seconds);
    megabytes.line.emplace_back(n, std::max(cost.megabytes, 0.1));
  }
  void finish() {
    for (Series* series : {&seconds, &megabytes}) {
      const double exponent = fit_power_law(series->line).exponent;
      series->label = fmt::format("slope {:.2f}", exponent);
    }
    fmt::print("{}: time grows with exponent {:.2f}\n", seconds.name,
               fit_power_law(seconds.line).exponent);
  }
};

void measure_layout(Turn turn, std::span<const std::size_t> sizes, int rounds, Growth& ours,
                    Growth& boost) {
  const char* layout = turn == Turn::Straight ? "straight" : "slanting";
  for (const std::size_t size : sizes) {
    const FloorPlan plan = generated_museum(size, turn);
    const std::size_t walls = plan.vertex.size();
    const Cost our_cost = cost_of(rounds, [&] { floor::voronoi_diagram(plan); });
    const Cost boost_cost = cost_of(rounds, [&] { make_boost_diagram(plan); });
    ours.add(walls, our_cost);
    boost.add(walls, boost_cost);
    fmt::print("{:<9} {:>8} {:>10.4f} {:>10.4f} {:>8.2f} {:>10.1f} {:>10.1f}\n", layout, walls,
               our_cost.seconds, boost_cost.seconds, our_cost.seconds / boost_cost.seconds,
               our_cost.megabytes, boost_cost.megabytes);
    std::fflush(stdout);
  }
  ours.finish();
  boost.finish();
}

void run(std::span<const std::size_t> sizes, int rounds, const std::filesystem::path& out) {
  using Mark = Series::Mark;
  Growth straight("docent, straight walls", draw::ink::vermilion, Mark::Disc);
  Growth slanting("docent, slanting walls", draw::ink::ochre, Mark::Ring);
  Growth boost_straight("Boost.Polygon, straight", draw::ink::teal, Mark::Square);
  Growth boost_slanting("Boost.Polygon, slanting", draw::ink::black, Mark::Diamond);
  fmt::print("{:<9} {:>8} {:>10} {:>10} {:>8} {:>10} {:>10}\n", "walls", "how many", "ours s",
             "Boost s", "ratio", "ours MB", "Boost MB");
  measure_layout(Turn::Straight, sizes, rounds, straight, boost_straight);
  measure_layout(Turn::Slanting, sizes, rounds, slanting, boost_slanting);

  Panel time{"Time", "walls", "seconds, median of the rounds", {}};
  Panel memory{"Memory while it is made", "walls", "megabytes at most", {}};
  for (Growth* growth : {&straight, &slanting, &boost_straight, &boost_slanting}) {
    time.series.push_back(growth->seconds);
    memory.series.push_back(growth->megabytes);
  }
  std::ofstream(out / "voronoi.svg") << draw_panels(
      "The segment Voronoi diagram of a floor",
      "Generated museums. Ours is of the floor alone, with regions and clearance; Boost's is of "
      "both sides of the walls.",
      {time, memory});
}

}  // namespace
}  // namespace docent::bench

int main(int argc, char** argv) {
  using namespace docent;
  std::string out = ".";
  std::vector<std::size_t> sizes{1'000, 2'000, 5'000, 10'000, 20'000, 50'000, 100'000};
  int rounds = 3;
  CLI::App app("Times Voronoi diagrams of floors of growing size");
  app.add_option("--walls", sizes, "about how many, ascending")->delimiter(',');
  app.add_option("--repeat", rounds, "rounds")->check(CLI::PositiveNumber);
  app.add_option("-o", out, "folder for voronoi.svg")->check(CLI::ExistingDirectory);
  CLI11_PARSE(app, argc, argv);
  try {
    bench::run(sizes, rounds, out);
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_voronoi: {}\n", error.what());
    return 2;
  }
  return 0;
}
