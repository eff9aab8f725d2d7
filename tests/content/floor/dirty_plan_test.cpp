// Random dirty plans, from the text of a file to the diagram: each becomes the right floor, or is
// refused with a reason.

#include <fmt/core.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "content/content_error.h"
#include "content/floor/medial_axis.h"
#include "content/floor/mend.h"
#include "content/floor/voronoi.h"
#include "tests/content/floor/diagram_check.h"
#include "tests/content/floor/dirty_plan.h"
#include "tests/content/floor/plans.h"
#include "tests/content/floor/raw_interior.h"

namespace docent::test::dirty_plan_test {
namespace {

/// Metres. Mending moves a wall by at most a corner's size, 1 mm, and once more where a crossing
/// comes to lie within that distance of a corner.
constexpr double farthest_moved = 0.002;
/// Square metres: pieces of floor below this are left out.
constexpr double speck = 0.01;

int count_specks(const std::vector<Diagnostic>& mendings) {
  int count = 0;
  for (const std::string& code : codes_of(mendings)) count += code == "speck-of-floor" ? 1 : 0;
  return count;
}

/// Points all over the plan, the same ones every time, on the R2 sequence (Roberts 2018).
Complaint check_points(const RawInterior& raw, const FloorPlan& plan, bool has_specks) {
  for (int i = 1; i <= 150; ++i) {
    const Vec2 part{std::fmod(0.7548776662466927 * i, 1.0), std::fmod(0.5698402909980532 * i, 1.0)};
    const Vec2 point = raw.low() + part * (raw.high() - raw.low());
    if (raw.distance_to_sides(point) < farthest_moved) continue;
    const bool expected = raw.holds(point), is = is_inside(plan, point);
    if (expected == is || (expected && has_specks)) continue;
    return fmt::format("[{}, {}] is {}floor", point.x, point.y, expected ? "no " : "");
  }
  return {};
}

Complaint check_floor(const RawInterior& raw, const FloorPlan& plan,
                      const std::vector<Diagnostic>& mendings) {
  const int specks = count_specks(mendings);
  const double expected = raw.area(), area = floor_area(plan);
  const double moved = farthest_moved * raw.length() + 1e-9;
  if (area > expected + moved || area < expected - moved - speck * specks)
    return fmt::format("{} square metres instead of {}", area, expected);
  if (Complaint complaint = check_points(raw, plan, specks > 0); !complaint.empty())
    return complaint;
  const VoronoiDiagram diagram = floor::voronoi_diagram(plan);
  floor::medial_axis(plan, diagram);
  // Doubles are 1e-9 apart at 5,000 km, and a steep parabola makes more of that.
  return check(plan, diagram, 4e-9, 1e-6);
}

/// What is wrong with the floor that a plan becomes, or with refusing it.
Complaint check_compiled(const DirtyPlan& dirty) {
  const std::string text = geojson(dirty);
  const import::GeoJsonText source{"dirty.geojson", text};
  const import::ImportedPlan read = import::parse_floor_plan({&source, 1}, coordinates_of(dirty));
  const RawInterior raw(read);
  std::vector<Diagnostic> mendings;
  FloorPlan plan;
  try {
    plan = floor::mend(read, mendings);
  } catch (const content::ContentError& error) {
    if (error.code != "no-floor") return fmt::format("refused: {}", error.what());
    const double left = raw.area();
    if (left > speck * 10 + farthest_moved * raw.length())
      return fmt::format("no floor found in {} square metres", left);
    return {};
  }
  return check_floor(raw, plan, mendings);
}

/// Ten plans a case, so that rapidcheck's hundred cases are a thousand.
RC_GTEST_PROP(DirtyPlan, BecomesTheRightFloorOrIsRefusedWithAReason, ()) {
  for (int i = 0; i < 10; ++i) {
    const Complaint complaint = check_compiled(*any_dirty_plan());
    if (!complaint.empty()) RC_FAIL(complaint);
  }
}

}  // namespace
}  // namespace docent::test::dirty_plan_test
