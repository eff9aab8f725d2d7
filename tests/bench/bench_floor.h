#pragma once

#include <filesystem>
#include <memory>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "runtime/model/geometry/floor.h"
#include "runtime/path/route.h"

namespace docent::bench {

/// A floor that a benchmark asks questions about, compiled as docent-content compiles it.
struct BenchFloor {
  std::string name;
  Floor floor;
  std::shared_ptr<const path::FloorMap> map;
  double compile_seconds = 0;
  double megabytes = 0;  ///< Of `floor` and `map` together.
};

/// A polymap (JSON of an outer ring and holes, as the reference data holds them).
struct Polymap {
  std::string name;
  bool in_metres = true;  ///< Else in the cells of a game's grid.
  std::string geojson;
};
Polymap read_polymap(const std::filesystem::path& file);
/// A plan of one outer ring, which comes first, and its holes.
Polymap to_polymap(const FloorPlan& plan);

/// Compiles a floor with tangents for some radii. Throws ContentError.
std::unique_ptr<BenchFloor> compile(const Polymap& map, std::span<const double> radii);

/// A question, and the answer where somebody knows it.
struct Query {
  Vec2 from{}, to{};
  double radius = 0;
  double known_length = 0;  ///< Infinite for no way, 0 where nobody has said it.
};

/// The rows of an answers CSV: x0,y0,x1,y1,r,length.
std::vector<Query> read_answers(const std::filesystem::path& file);

/// Pairs of random points where a disc has room, between which it can go.
std::vector<Query> random_queries(const path::FloorMap& map, const FloorPlan& plan, double radius,
                                  std::size_t count, std::mt19937_64& random);

}  // namespace docent::bench
