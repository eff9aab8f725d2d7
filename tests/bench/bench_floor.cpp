#include "tests/bench/bench_floor.h"

#include <fmt/core.h>

#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "content/compile/compile_floor.h"
#include "tests/bench/measure.h"
#include "tests/support/temporary_folder.h"

namespace docent::bench {
namespace {

constexpr double megabyte = 1024.0 * 1024.0;

/// GeoJSON repeats the first position of a ring at its end.
nlohmann::json closed(nlohmann::json ring) {
  ring.push_back(ring.front());
  return ring;
}

std::string polygon(nlohmann::json rings) {
  return nlohmann::json{{"type", "Polygon"}, {"coordinates", std::move(rings)}}.dump();
}

/// A point that is equally likely anywhere in the rectangle round the plan.
Vec2 random_point(Vec2 low, Vec2 high, std::mt19937_64& random) {
  const auto between = [&](double a, double b) {
    return std::uniform_real_distribution(a, b)(random);
  };
  const double x = between(low.x, high.x);
  return {x, between(low.y, high.y)};
}

}  // namespace

Polymap read_polymap(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error(file.string() + " cannot be read");
  const nlohmann::json map = nlohmann::json::parse(in);
  auto rings = nlohmann::json::array({closed(map.at("outer"))});
  for (const auto& hole : map.at("holes")) rings.push_back(closed(hole));
  return {.name = file.stem().string(),
          .in_metres = map.at("units") == "m",
          .geojson = polygon(std::move(rings))};
}

Polymap to_polymap(const FloorPlan& plan) {
  auto rings = nlohmann::json::array();
  for (const auto& [first, count] : plan.ring) {
    auto ring = nlohmann::json::array();
    for (const Vec2 p : std::span(plan.vertex).subspan(first, count)) ring.push_back({p.x, p.y});
    rings.push_back(closed(std::move(ring)));
  }
  return {.name = plan.name, .geojson = polygon(std::move(rings))};
}

std::unique_ptr<BenchFloor> compile(const Polymap& map, std::span<const double> radii) {
  const test::TemporaryFolder folder;
  const std::string file = (folder.path() / (map.name + ".geojson")).string();
  std::ofstream(file) << map.geojson;
  const double heap_before = heap_in_use();
  auto result = std::make_unique<BenchFloor>();
  result->name = map.name;
  const double begin = now();
  {
    compile::Report report;
    compile::Progress progress(compile::Progress::Output::Nothing);
    compile::plan_floor_stages(progress);
    const std::vector<std::string> files{file};
    compile::CompiledFloor compiled = compile::compile_floor(
        map.name, files, import::Coordinates::Metres, radii, report, progress);
    result->floor = std::move(compiled.floor);
  }
  result->compile_seconds = now() - begin;
  result->map = path::make_floor_map(result->floor);
  result->megabytes = (heap_in_use() - heap_before) / megabyte;
  return result;
}

std::vector<Query> read_answers(const std::filesystem::path& file) {
  std::vector<Query> queries;
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);  // The names of the columns.
  while (std::getline(in, line)) {
    for (char& c : line) c = c == ',' ? ' ' : c;
    std::istringstream row(line);
    Query query;
    std::string length;
    row >> query.from.x >> query.from.y >> query.to.x >> query.to.y >> query.radius >> length;
    query.known_length =
        length == "inf" ? std::numeric_limits<double>::infinity() : std::stod(length);
    queries.push_back(query);
  }
  return queries;
}

std::vector<Query> random_queries(const path::FloorMap& map, const FloorPlan& plan, double radius,
                                  std::size_t count, std::mt19937_64& random) {
  Vec2 low = plan.vertex.front(), high = low;
  for (const Vec2 p : plan.vertex) low = glm::min(low, p), high = glm::max(high, p);
  const double room = 1.02 * radius + 1e-3;  // As in the reference data.
  const auto free_point = [&] {
    for (int tries = 0; tries < 100'000; ++tries) {
      const Vec2 p = random_point(low, high, random);
      if (path::is_inside(map, p) && path::clearance_at(map, p) > room) return p;
    }
    throw std::runtime_error(fmt::format("{} has no room for a radius of {}", plan.name, radius));
  };
  std::vector<Query> queries;
  for (std::size_t tries = 0; tries < 10 * count && queries.size() < count; ++tries) {
    const Vec2 from = free_point(), to = free_point();
    const path::RouteQuery asked{.from = from, .to = to, .radius = radius};
    if (path::route(map, asked).status == path::RouteStatus::Ok)
      queries.push_back({from, to, radius});
  }
  return queries;
}

}  // namespace docent::bench
