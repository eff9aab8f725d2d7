// What does it cost to ask about a point (is it inside, how far is a wall, whose region is it) and
// whether two points see each other, on floors of growing size?

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <random>

#include "tests/bench/bench_floor.h"
#include "tests/bench/generated_floors.h"
#include "tests/bench/measure.h"
#include "tests/support/reference_data.h"

namespace docent::bench {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t pairs = 2000;

/// Microseconds of one call: the median over the rounds of the mean over all pairs, because a
/// single call is too short for a clock.
template <class Ask>
double microseconds(const std::vector<Query>& queries, int rounds, Ask ask) {
  std::vector<double> times;
  volatile double sink = 0;  // So that no answer is left out.
  for (int round = 0; round < rounds; ++round) {
    double sum = 0;
    const double begin = now();
    for (const Query& query : queries) sum += ask(query);
    times.push_back((now() - begin) * 1e6 / static_cast<double>(queries.size()));
    sink = sum;
  }
  static_cast<void>(sink);
  return median(times);
}

void run_map(const Polymap& polymap, int rounds) {
  const auto floor = compile(polymap, std::vector{0.0});
  std::mt19937_64 random(1);
  const auto queries = random_queries(*floor->map, floor->floor.plan, 0, pairs, random);
  const path::FloorMap& map = *floor->map;
  const double inside = microseconds(
      queries, rounds, [&](const Query& q) { return path::is_inside(map, q.from) ? 1.0 : 0.0; });
  const double clearance = microseconds(
      queries, rounds, [&](const Query& q) { return path::clearance_at(map, q.from); });
  const double region = microseconds(queries, rounds, [&](const Query& q) {
    return static_cast<double>(path::region_at(map, q.from));
  });
  const double see = microseconds(queries, rounds, [&](const Query& q) {
    return path::can_see(map, q.from, q.to) ? 1.0 : 0.0;
  });
  fmt::print("{:<45.45} {:>8} {:>10.3f} {:>10.3f} {:>10.3f} {:>10.3f} {:>10.3f}\n", polymap.name,
             floor->floor.plan.vertex.size(), inside, clearance, region,
             inside + clearance + region, see);
}

void run(const std::string& folder, const std::vector<std::size_t>& generated, int rounds) {
  fmt::print("{:<45} {:>8} {:>10} {:>10} {:>10} {:>10} {:>10}\n", "map (microseconds)", "vertices",
             "inside", "clearance", "region", "all three", "see");
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  std::ranges::sort(files);
  for (const fs::path& file : files) run_map(read_polymap(file), rounds);
  for (const std::size_t vertices : generated)
    run_map(to_polymap(generated_museum(vertices, Turn::Slanting)), rounds);
}

}  // namespace
}  // namespace docent::bench

int main(int argc, char** argv) {
  using namespace docent;
  std::string folder = (test::reference_data() / "floorplans" / "reference" / "maps").string();
  std::vector<std::size_t> generated{2'000, 15'000};
  int rounds = 21;
  CLI::App app("Times questions about points and sight");
  app.add_option("--maps", folder, "folder of polymaps")->check(CLI::ExistingDirectory);
  app.add_option("--generated", generated, "vertices of generated museums")->delimiter(',');
  app.add_option("--repeat", rounds, "rounds")->check(CLI::PositiveNumber);
  CLI11_PARSE(app, argc, argv);
  try {
    bench::run(folder, generated, rounds);
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_locate: {}\n", error.what());
    return 2;
  }
  return 0;
}
