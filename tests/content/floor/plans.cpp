#include "tests/content/floor/plans.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>

#include "content/floor/mend.h"
#include "tests/support/reference_data.h"

namespace docent::test {
namespace {

import::ImportedRing drawn_ring(const Points& points, std::uint32_t line) {
  import::ImportedRing ring;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    ring.vertex.push_back(points[i]);
    ring.place.push_back({.file = 0, .line = line, .column = i + 1});
  }
  if (ring.vertex.size() > 1 && ring.vertex.front() == ring.vertex.back()) {
    ring.vertex.pop_back();
    ring.place.pop_back();
  }
  return ring;
}

Points points_of(const nlohmann::json& ring) {
  Points points;
  points.reserve(ring.size());
  for (const auto& p : ring) points.push_back({p[0].get<double>(), p[1].get<double>()});
  return points;
}

/// Cuts a ring where it touches itself.
std::vector<Points> simple_loops(const FloorPlan& plan, const Ring& ring) {
  std::vector<Points> loops;
  Points open;
  for (std::uint32_t i = 0; i < ring.count; ++i) {
    const Vec2 vertex = plan.vertex[ring.first + i];
    const auto before = std::ranges::find(open, vertex);
    if (before != open.end()) {
      loops.emplace_back(before, open.end());
      open.erase(before, open.end());
    }
    open.push_back(vertex);
  }
  loops.push_back(open);
  return loops;
}

int count_loops(const FloorPlan& plan, bool counter_clockwise) {
  int count = 0;
  for (const Ring& ring : plan.ring)
    for (const Points& loop : simple_loops(plan, ring))
      count += (signed_area(loop) > 0) == counter_clockwise ? 1 : 0;
  return count;
}

}  // namespace

import::ImportedPlan drawn(const Points& outer, const std::vector<Points>& holes) {
  import::ImportedPolygon polygon{.outer = drawn_ring(outer, 1), .holes = {}};
  for (std::uint32_t h = 0; h < holes.size(); ++h)
    polygon.holes.push_back(drawn_ring(holes[h], h + 2));
  return {.files = {"plan.geojson"}, .polygons = {polygon}, .left_out = {}};
}

Points rectangle(Vec2 low, Vec2 high) {
  return {low, {high.x, low.y}, high, {low.x, high.y}};
}

Points regular_polygon(Vec2 centre, double radius, int corners, double turned_degrees) {
  Points points;
  for (int i = 0; i < corners; ++i) {
    const double angle = (2.0 * i / corners + turned_degrees / 180) * std::numbers::pi;
    points.push_back(centre + radius * Vec2{std::cos(angle), std::sin(angle)});
  }
  return points;
}

FloorPlan mended(const import::ImportedPlan& plan) {
  std::vector<Diagnostic> mendings;
  return floor::mend(plan, mendings);
}

std::vector<std::string> codes_of(const std::vector<Diagnostic>& diagnostics) {
  std::vector<std::string> codes;
  for (const Diagnostic& diagnostic : diagnostics) codes.push_back(diagnostic.code);
  return codes;
}

Polymap read_polymap(const std::filesystem::path& file) {
  const auto json = nlohmann::json::parse(std::ifstream(file));
  Polymap map;
  map.name = file.stem().string();
  std::vector<Points> holes;
  for (const auto& hole : json.at("holes")) holes.push_back(points_of(hole));
  map.plan = drawn(points_of(json.at("outer")), holes);
  if (!json.contains("expect")) return map;
  const auto& expect = json.at("expect");
  map.accept = expect.at("accept") == true;
  map.must_fail = expect.at("accept") == false;
  map.free_area = expect.value("free_area", -1.0);
  map.components = expect.value("components", -1);
  map.holes = expect.value("holes_total", -1);
  return map;
}

std::vector<std::filesystem::path> plan_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(reference_data() / folder))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

double signed_area(const Points& ring) {
  double twice = 0;
  for (std::size_t i = 0; i < ring.size(); ++i)
    twice += cross(ring[i] - ring[0], ring[(i + 1) % ring.size()] - ring[0]);
  return twice / 2;
}

double floor_area(const FloorPlan& plan) {
  double area = 0;
  for (const Ring& ring : plan.ring)
    area += signed_area(
        Points(plan.vertex.begin() + ring.first, plan.vertex.begin() + ring.first + ring.count));
  return area;
}

int count_components(const FloorPlan& plan) {
  return count_loops(plan, true);
}
int count_holes(const FloorPlan& plan) {
  return count_loops(plan, false);
}

double distance_to_wall(const FloorPlan& plan, std::uint32_t wall, Vec2 point) {
  const Vec2 a = wall_start(plan, wall), along = wall_end(plan, wall) - a;
  const double t = std::clamp(dot(point - a, along) / dot(along, along), 0.0, 1.0);
  return glm::distance(point, a + t * along);
}

double distance_to_nearest_wall(const FloorPlan& plan, Vec2 point) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::uint32_t wall = 0; wall < plan.vertex.size(); ++wall)
    nearest = std::min(nearest, distance_to_wall(plan, wall, point));
  return nearest;
}

double distance_to_site(const FloorPlan& plan, Site site, Vec2 point) {
  return site.kind == Site::Kind::Wall ? distance_to_wall(plan, site.index, point)
                                       : glm::distance(plan.vertex[site.index], point);
}

bool is_inside(const FloorPlan& plan, Vec2 p) {
  bool inside = false;
  for (std::uint32_t wall = 0; wall < plan.vertex.size(); ++wall) {
    const Vec2 a = wall_start(plan, wall), b = wall_end(plan, wall);
    if ((a.y > p.y) == (b.y > p.y)) continue;
    const double side = cross(b - a, p - a);
    if ((b.y > a.y) == (side > 0)) inside = !inside;
  }
  return inside;
}

}  // namespace docent::test
