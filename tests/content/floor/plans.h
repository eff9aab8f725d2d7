#pragma once

#include <filesystem>
#include <initializer_list>
#include <string>
#include <vector>

#include "content/import/floor/imported_plan.h"
#include "runtime/model/diagnostic.h"
#include "runtime/model/geometry/floor_plan.h"
#include "runtime/model/geometry/voronoi_diagram.h"

namespace docent::test {

using Points = std::vector<Vec2>;

/// A drawn plan of one area with its holes; vertex i of ring r stands in line r + 1, column i + 1.
import::ImportedPlan drawn(const Points& outer, const std::vector<Points>& holes = {});
Points rectangle(Vec2 low, Vec2 high);
Points regular_polygon(Vec2 centre, double radius, int corners, double turned_degrees = 0);

/// Mends a plan whose mendings do not matter.
FloorPlan mended(const import::ImportedPlan& plan);
std::vector<std::string> codes_of(const std::vector<Diagnostic>& diagnostics);

/// What a plan of the reference data expects, and the plan.
struct Polymap {
  std::string name;
  import::ImportedPlan plan;
  bool accept = true;      ///< `expect.accept` is true, or there is no expectation.
  bool must_fail = false;  ///< `expect.accept` is false.
  double free_area = -1;   ///< Square metres; negative where nothing is said.
  int components = -1;
  int holes = -1;
};
Polymap read_polymap(const std::filesystem::path& file);
/// All plans in a folder of the reference data, by name.
std::vector<std::filesystem::path> plan_files(const std::filesystem::path& folder);

/// Independent oracles, all by brute force.
double signed_area(const Points& ring);
double floor_area(const FloorPlan& plan);
/// Counter-clockwise and clockwise loops, a ring that touches itself being several.
int count_components(const FloorPlan& plan);
int count_holes(const FloorPlan& plan);
double distance_to_wall(const FloorPlan& plan, std::uint32_t wall, Vec2 point);
double distance_to_nearest_wall(const FloorPlan& plan, Vec2 point);
double distance_to_site(const FloorPlan& plan, Site site, Vec2 point);
bool is_inside(const FloorPlan& plan, Vec2 point);

}  // namespace docent::test
