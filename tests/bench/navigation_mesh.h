#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "runtime/model/geometry/floor_plan.h"

namespace docent::bench {

/// A floor cut into strictly convex polygons that meet edge to edge.
///
/// The corners of polygon p are corner[first[p] .. first[p + 1]), counter-clockwise; entry k of
/// `across` and `across_edge` belongs to the edge from corner k to the next corner of its polygon.
/// `first` has one entry more than there are polygons. Immutable once made.
struct NavigationMesh {
  static constexpr std::uint32_t wall = 0xffffffff;
  std::vector<Vec2> vertex;
  std::vector<std::uint8_t> is_reflex;  ///< One per vertex: may a shortest path bend here?
  std::vector<std::uint32_t> first;
  std::vector<std::uint32_t> corner;       ///< Vertices.
  std::vector<std::uint32_t> across;       ///< The polygon beyond an edge, or `wall`.
  std::vector<std::uint32_t> across_edge;  ///< Which edge of that polygon it is, from 0.
  std::vector<std::uint32_t> exits;        ///< One per polygon: how many of its edges are no walls.

  [[nodiscard]] std::uint32_t polygons() const noexcept {
    return static_cast<std::uint32_t>(first.size() - 1);
  }
  [[nodiscard]] std::span<const std::uint32_t> corners(std::uint32_t polygon) const noexcept {
    return std::span(corner).subspan(first[polygon], first[polygon + 1] - first[polygon]);
  }
};

/// The constrained Delaunay triangulation of the walkable floor.
NavigationMesh triangulate(const FloorPlan& plan);

/// The mesh with edges taken out, the longest first, wherever what is left stays strictly convex
/// (Hertel and Mehlhorn 1983). Fewer and larger polygons make a faster search.
NavigationMesh merge_polygons(const NavigationMesh& mesh);

/// Finds the polygons that hold a point: a uniform grid of about as many cells as polygons.
/// Borrows the mesh.
class PolygonGrid {
 public:
  explicit PolygonGrid(const NavigationMesh& mesh);

  /// Appends every polygon whose closed area holds the point.
  void find(Vec2 point, std::vector<std::uint32_t>& polygons) const;

 private:
  [[nodiscard]] int column_of(double x) const noexcept;
  [[nodiscard]] int row_of(double y) const noexcept;
  [[nodiscard]] std::size_t cell_of(int column, int row) const noexcept;

  const NavigationMesh& mesh_;
  Vec2 low_{};
  double cells_per_metre_ = 1;
  int columns_ = 1, rows_ = 1;
  std::vector<std::uint32_t> cell_first_;
  std::vector<std::uint32_t> cell_polygon_;
};

}  // namespace docent::bench
