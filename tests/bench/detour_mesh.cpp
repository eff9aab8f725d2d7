#include "tests/bench/detour_mesh.h"

#include <DetourAlloc.h>
#include <DetourNavMesh.h>
#include <DetourNavMeshBuilder.h>
#include <DetourNavMeshQuery.h>
#include <Recast.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "tests/bench/navigation_mesh.h"

namespace docent::bench {
namespace {

/// A point of Recast's world: y is up, and the floor's y runs along z.
using Point3 = std::array<float, 3>;

Point3 lifted(Vec2 p) {
  return {static_cast<float>(p.x), 0.0F, static_cast<float>(p.y)};
}

template <auto release>
struct ReleaseWith {
  void operator()(auto* thing) const noexcept { release(thing); }
};
using Heightfield = std::unique_ptr<rcHeightfield, ReleaseWith<rcFreeHeightField>>;
using OpenSpans = std::unique_ptr<rcCompactHeightfield, ReleaseWith<rcFreeCompactHeightfield>>;
using Contours = std::unique_ptr<rcContourSet, ReleaseWith<rcFreeContourSet>>;
using PolyMesh = std::unique_ptr<rcPolyMesh, ReleaseWith<rcFreePolyMesh>>;

constexpr double most_cells = 6e6;
constexpr float cell_height = 0.2F;  // Metres.
constexpr int walkable_height = 10;  // Cells; nothing stands above the floor.
constexpr int longest_path = 4096;   // Polygons.
constexpr unsigned short can_walk = 1;
constexpr int corners_of_a_polygon = 6;  // Detour's own limit.

void require(bool done, const char* step) {
  if (!done) throw std::runtime_error(std::string("Recast cannot do ") + step);
}

/// The floor in cells, without those nearer to a wall than the radius.
OpenSpans rasterise(rcContext& context, const FloorPlan& plan, double radius, float cell_size) {
  const NavigationMesh floor = triangulate(plan);
  std::vector<float> vertices;
  for (const Vec2 p : floor.vertex)
    for (const float coordinate : lifted(p)) vertices.push_back(coordinate);
  const std::vector<int> corners(floor.corner.begin(), floor.corner.end());
  const int vertex_count = static_cast<int>(floor.vertex.size());
  const int triangle_count = static_cast<int>(floor.polygons());

  Point3 low{}, high{};
  rcCalcBounds(vertices.data(), vertex_count, low.data(), high.data());
  low[1] -= cell_height, high[1] += cell_height;
  int columns = 0, rows = 0;
  rcCalcGridSize(low.data(), high.data(), cell_size, &columns, &rows);
  const Heightfield field(rcAllocHeightfield());
  require(rcCreateHeightfield(&context, *field, columns, rows, low.data(), high.data(), cell_size,
                              cell_height),
          "rcCreateHeightfield");
  const std::vector<unsigned char> areas(floor.polygons(), RC_WALKABLE_AREA);
  require(rcRasterizeTriangles(&context, vertices.data(), vertex_count, corners.data(),
                               areas.data(), triangle_count, *field),
          "rcRasterizeTriangles");
  OpenSpans spans(rcAllocCompactHeightfield());
  require(rcBuildCompactHeightfield(&context, walkable_height, 1, *field, *spans),
          "rcBuildCompactHeightfield");
  const int radius_in_cells = static_cast<int>(std::ceil(radius / cell_size - 1e-3));
  if (radius_in_cells > 0)
    require(rcErodeWalkableArea(&context, radius_in_cells, *spans), "rcErodeWalkableArea");
  return spans;
}

/// The mesh with the figures of Recast's own demo: contours within 1.3 cells, edges up to 12 m.
PolyMesh make_mesh(rcContext& context, rcCompactHeightfield& spans) {
  require(rcBuildDistanceField(&context, spans), "rcBuildDistanceField");
  require(rcBuildRegions(&context, spans, 0, 8 * 8, 20 * 20), "rcBuildRegions");
  const Contours contours(rcAllocContourSet());
  require(rcBuildContours(&context, spans, 1.3F, static_cast<int>(12 / spans.cs), *contours),
          "rcBuildContours");
  PolyMesh mesh(rcAllocPolyMesh());
  require(rcBuildPolyMesh(&context, *contours, corners_of_a_polygon, *mesh), "rcBuildPolyMesh");
  std::fill_n(mesh->flags, mesh->npolys, can_walk);
  return mesh;
}

}  // namespace

struct DetourMesh::Parts {
  dtNavMesh mesh;
  dtNavMeshQuery query;
  dtQueryFilter filter;
  Point3 reach{};  ///< How far from a given point its polygon may be.
  std::array<dtPolyRef, longest_path> polygons{};
  std::array<Point3, longest_path> points{};
};

DetourMesh::DetourMesh(const FloorPlan& plan, double radius, double usual_radius)
    : parts_(std::make_unique<Parts>()) {
  Vec2 low = plan.vertex.front(), high = low;
  for (const Vec2 p : plan.vertex) low = glm::min(low, p), high = glm::max(high, p);
  const Vec2 size = high - low;
  cell_size_ = std::max(usual_radius / 5, std::sqrt(size.x * size.y / most_cells));

  rcContext context(false);
  const OpenSpans spans = rasterise(context, plan, radius, static_cast<float>(cell_size_));
  const PolyMesh poly_mesh = make_mesh(context, *spans);

  dtNavMeshCreateParams parameters{};
  parameters.verts = poly_mesh->verts;
  parameters.vertCount = poly_mesh->nverts;
  parameters.polys = poly_mesh->polys;
  parameters.polyAreas = poly_mesh->areas;
  parameters.polyFlags = poly_mesh->flags;
  parameters.polyCount = poly_mesh->npolys;
  parameters.nvp = poly_mesh->nvp;
  std::copy_n(poly_mesh->bmin, 3, parameters.bmin);
  std::copy_n(poly_mesh->bmax, 3, parameters.bmax);
  parameters.walkableHeight = walkable_height * cell_height;
  parameters.walkableRadius = static_cast<float>(radius);
  parameters.walkableClimb = cell_height;
  parameters.cs = poly_mesh->cs;
  parameters.ch = poly_mesh->ch;
  parameters.buildBvTree = true;
  unsigned char* data = nullptr;
  int bytes = 0;
  require(dtCreateNavMeshData(&parameters, &data, &bytes), "dtCreateNavMeshData");
  require(dtStatusSucceed(parts_->mesh.init(data, bytes, DT_TILE_FREE_DATA)), "dtNavMesh::init");

  // Room for a node per polygon: a smaller pool would end long searches early.
  const unsigned polygons = static_cast<unsigned>(poly_mesh->npolys);
  const int nodes = static_cast<int>(std::min(std::bit_ceil(polygons + 1), 32768U));
  require(dtStatusSucceed(parts_->query.init(&parts_->mesh, nodes)), "dtNavMeshQuery::init");
  const float reach = static_cast<float>(8 * cell_size_);
  parts_->reach = {reach, 1.0F, reach};
}

DetourMesh::~DetourMesh() = default;

FoundPath DetourMesh::find(Vec2 from, Vec2 to) {
  auto& [mesh, query, filter, reach, polygons, points] = *parts_;
  const Point3 start = lifted(from), goal = lifted(to);
  dtPolyRef start_polygon = 0, goal_polygon = 0;
  Point3 start_on_mesh{}, goal_on_mesh{};
  query.findNearestPoly(start.data(), reach.data(), &filter, &start_polygon, start_on_mesh.data());
  query.findNearestPoly(goal.data(), reach.data(), &filter, &goal_polygon, goal_on_mesh.data());
  if (start_polygon == 0 || goal_polygon == 0) return {};

  int count = 0;
  const dtStatus status =
      query.findPath(start_polygon, goal_polygon, start_on_mesh.data(), goal_on_mesh.data(),
                     &filter, polygons.data(), &count, longest_path);
  if (dtStatusFailed(status) || dtStatusDetail(status, DT_PARTIAL_RESULT)) return {};
  int bends = 0;
  query.findStraightPath(start_on_mesh.data(), goal_on_mesh.data(), polygons.data(), count,
                         points.front().data(), nullptr, nullptr, &bends, longest_path);

  FoundPath path{.length = 0};
  for (const Point3& p : std::span(points).first(static_cast<std::size_t>(bends))) {
    path.points.emplace_back(p[0], p[2]);
    if (path.points.size() > 1)
      path.length += glm::distance(path.points.end()[-2], path.points.back());
  }
  return path;
}

}  // namespace docent::bench
