#pragma once

#include <memory>

#include "runtime/model/geometry/floor_plan.h"
#include "tests/bench/found_path.h"

namespace docent::bench {

/// Recast and Detour as games use them: the floor rasterised into cells, eroded by the radius and
/// cut into a mesh of polygons by Recast, searched by Detour. Fast and not exact: the mesh follows
/// the walls only to about a cell, and the search runs from the middle of one polygon's edge to the
/// next. Here to be compared with. One thread may search at a time.
class DetourMesh {
 public:
  /// Cells of a fifth of the radius (0.05 m for a radius of 0.25 m), larger where the floor would
  /// have more than 6 million of them. `usual_radius` sets their size where the radius is 0.
  /// Throws std::runtime_error where Recast gives up.
  DetourMesh(const FloorPlan& plan, double radius, double usual_radius);
  ~DetourMesh();
  DetourMesh(const DetourMesh&) = delete;
  DetourMesh& operator=(const DetourMesh&) = delete;

  /// findNearestPoly at both ends, findPath, findStraightPath.
  FoundPath find(Vec2 from, Vec2 to);

  [[nodiscard]] double cell_size() const noexcept { return cell_size_; }

 private:
  struct Parts;
  double cell_size_ = 0;
  std::unique_ptr<Parts> parts_;
};

}  // namespace docent::bench
