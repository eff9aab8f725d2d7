#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "content/content_error.h"
#include "content/floor/medial_axis.h"
#include "content/floor/mend.h"
#include "content/floor/voronoi.h"

using namespace docent;

namespace {

constexpr std::uint8_t next_area = 254, next_hole = 255;
constexpr std::size_t most_vertices = 80;  // More only takes more time.

/// Three bytes a corner: decimetres east and north, and what is to be added to both in steps of
/// 0.25 mm. Two bytes are no corner: the next ring follows.
import::ImportedPlan rings_from(std::span<const std::uint8_t> bytes) {
  import::ImportedPlan plan;
  plan.files = {"fuzz"};
  import::ImportedRing* ring = &plan.polygons.emplace_back().outer;
  std::size_t vertices = 0;
  for (std::size_t i = 0; i < bytes.size() && vertices < most_vertices;) {
    if (bytes[i] == next_area) {
      ring = &plan.polygons.emplace_back().outer;
      ++i;
    } else if (bytes[i] == next_hole) {
      ring = &plan.polygons.back().holes.emplace_back();
      ++i;
    } else if (i + 2 < bytes.size()) {
      const int east = bytes[i + 2] % 16, north = bytes[i + 2] / 16;
      ring->vertex.emplace_back(0.1 * bytes[i] + 0.00025 * east,
                                0.1 * bytes[i + 1] + 0.00025 * north);
      ring->place.push_back({});
      ++vertices;
      i += 3;
    } else {
      break;
    }
  }
  const auto is_empty = [](const import::ImportedRing& r) { return r.vertex.empty(); };
  for (import::ImportedPolygon& polygon : plan.polygons) std::erase_if(polygon.holes, is_empty);
  std::erase_if(plan.polygons, [&](const import::ImportedPolygon& p) { return is_empty(p.outer); });
  return plan;
}

std::optional<FloorPlan> mended(const import::ImportedPlan& drawn) {
  try {
    std::vector<Diagnostic> mendings;
    return floor::mend(drawn, mendings);
  } catch (const content::ContentError& error) {
    if (error.code.empty()) __builtin_trap();
    return std::nullopt;
  }
}

double distance_to_wall(const FloorPlan& plan, std::uint32_t wall, Vec2 p) {
  const Vec2 a = wall_start(plan, wall), along = wall_end(plan, wall) - a;
  return glm::distance(p, a + std::clamp(dot(p - a, along) / dot(along, along), 0.0, 1.0) * along);
}

}  // namespace

/// Whatever rings are drawn, they are refused or mended, and what is mended has a diagram whose
/// vertices are as far from the walls as they claim.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const import::ImportedPlan drawn = rings_from({data, size});
  if (drawn.polygons.empty()) return 0;
  const std::optional<FloorPlan> plan = mended(drawn);
  if (!plan) return 0;
  const VoronoiDiagram diagram =
      floor::voronoi_diagram(*plan);  // Of mended walls, it never throws.
  for (std::size_t v = 0; v < diagram.vertex.size(); ++v) {
    double nearest = HUGE_VAL;
    for (std::uint32_t wall = 0; wall < plan->next.size(); ++wall)
      nearest = std::min(nearest, distance_to_wall(*plan, wall, diagram.vertex[v]));
    if (!(std::abs(nearest - diagram.clearance[v]) < 1e-9)) __builtin_trap();
  }
  floor::medial_axis(*plan, diagram);
  return 0;
}
