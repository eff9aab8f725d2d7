// On a floor without holes, how does the cost of a shortest path grow with the corners that it
// passes? It should be linear, and depend on the path's corridor rather than on the rest of the
// floor: so a corridor is walked from end to end, with more and more turns, and the first turns of
// one long corridor are.

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <fstream>
#include <functional>
#include <random>

#include "content/draw/svg.h"
#include "tests/bench/contest.h"
#include "tests/bench/generated_floors.h"
#include "tests/bench/measure.h"
#include "tests/bench/plot.h"

namespace docent::bench {
namespace {

constexpr double disc_radius = 0.25;
constexpr std::size_t queries_each = 24;
constexpr int rounds = 9;

using MakeCorridor = std::function<Corridor(std::size_t)>;

/// Queries from about the middle of the first leg to that of the leg before another turn.
std::vector<Query> queries_along(const Corridor& corridor, std::size_t last, double radius,
                                 std::mt19937_64& random) {
  std::uniform_real_distribution<double> beside(-0.3, 0.3);
  const auto before = [&](std::size_t turn) {
    const double x = beside(random);
    return (corridor.turns[turn - 1] + corridor.turns[turn]) / 2.0 + Vec2{x, beside(random)};
  };
  std::vector<Query> queries;
  for (std::size_t i = 0; i < queries_each; ++i) {
    const Vec2 from = before(1);
    queries.push_back({from, before(last), radius});
  }
  return queries;
}

/// The median microseconds from one end of the corridor to a turn.
double microseconds_to(const BenchFloor& floor, const Corridor& corridor, std::size_t last,
                       double radius) {
  std::mt19937_64 random(1);
  const std::vector<Query> queries = queries_along(corridor, last, radius, random);
  return contest(std::vector{our_entrant(floor, 0)}, queries, rounds, random).front().median_us;
}

/// Growth with the corners, of corridors walked from end to end and of parts of the longest one.
Panel measure_corridor(const std::string& title, const MakeCorridor& make,
                       std::span<const std::size_t> sizes) {
  using Mark = Series::Mark;
  const std::vector<double> radii{0.0, disc_radius};
  std::vector<Series> whole{{"point, end to end", std::string(draw::ink::vermilion), Mark::Disc},
                            {"disc, end to end", std::string(draw::ink::teal), Mark::Square}};
  std::vector<Series> part{{"point, part of it", std::string(draw::ink::ochre), Mark::Ring},
                           {"disc, part of it", std::string(draw::ink::quiet), Mark::Diamond}};
  for (const std::size_t turns : sizes) {
    const Corridor corridor = make(turns);
    const auto floor = compile(to_polymap(corridor.plan), radii);
    for (std::size_t r = 0; r < radii.size(); ++r)
      whole[r].line.emplace_back(turns, microseconds_to(*floor, corridor, turns - 1, radii[r]));
    if (turns != sizes.back()) continue;
    for (const std::size_t some : sizes)
      for (std::size_t r = 0; r < radii.size(); ++r)
        part[r].line.emplace_back(some, microseconds_to(*floor, corridor, some - 1, radii[r]));
  }

  Panel panel{title, "turns of the corridor", "microseconds, median", {}};
  for (std::vector<Series>* group : {&whole, &part})
    for (Series& series : *group) {
      // The upper half, where what every query costs hardly counts.
      const auto upper = std::span(series.line).subspan((series.line.size() - 1) / 2);
      const double exponent = fit_power_law(upper).exponent;
      for (const Vec2 p : series.line)
        fmt::print("{:<8} {:<20} {:>6} turns {:>10.2f} us {:>8.3f} us a turn\n", title, series.name,
                   p.x, p.y, p.y / p.x);
      fmt::print("{:<8} {:<20} grows with exponent {:.2f}\n", title, series.name, exponent);
      series.label = fmt::format("slope {:.2f}", exponent);
      panel.series.push_back(std::move(series));
    }
  return panel;
}

}  // namespace
}  // namespace docent::bench

int main(int argc, char** argv) {
  using namespace docent;
  std::string out = ".";
  std::vector<std::size_t> sizes{8, 16, 32, 64, 128, 256, 512, 1024, 2048};
  CLI::App app("Times shortest paths along corridors of growing length");
  app.add_option("--turns", sizes, "of the corridors, ascending; two or more")
      ->delimiter(',')
      ->expected(2, -1);
  app.add_option("-o", out, "folder for corridor.svg")->check(CLI::ExistingDirectory);
  CLI11_PARSE(app, argc, argv);
  try {
    const std::vector panels{bench::measure_corridor("zigzag", bench::zigzag_corridor, sizes),
                             bench::measure_corridor("spiral", bench::spiral_corridor, sizes)};
    std::ofstream(std::filesystem::path(out) / "corridor.svg") << bench::draw_panels(
        "A shortest path on floors without holes",
        "Corridors walked from end to end, and the first turns of the longest "
        "one. A slope of 1 is linear.",
        panels);
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_corridor: {}\n", error.what());
    return 2;
  }
  return 0;
}
