#include "tests/bench/navigation_mesh.h"
#include "runtime/model/geometry/orientation.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace docent::bench {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<bool, Kernel,
                                              CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
    CGAL::No_constraint_intersection_requiring_constructions_tag>;

/// Inserts the walls; each vertex of the triangulation knows its number in the mesh.
Triangulation triangulation_of(const FloorPlan& plan, NavigationMesh& mesh) {
  Triangulation triangulation;
  std::vector<Triangulation::Vertex_handle> handle;
  for (const Vec2 p : plan.vertex) {
    const std::size_t before = triangulation.number_of_vertices();
    handle.push_back(triangulation.insert({p.x, p.y}));
    if (triangulation.number_of_vertices() == before) continue;  // Two rings touch here.
    handle.back()->info() = static_cast<std::uint32_t>(mesh.vertex.size());
    mesh.vertex.push_back(p);
  }
  mesh.is_reflex.assign(mesh.vertex.size(), 0);
  for (std::uint32_t v = 0; v < plan.vertex.size(); ++v) {
    const std::uint32_t next = plan.next[v], after = plan.next[next];
    triangulation.insert_constraint(handle[v], handle[next]);
    if (orientation(plan.vertex[v], plan.vertex[next], plan.vertex[after]) < 0)
      mesh.is_reflex[handle[next]->info()] = 1;
  }
  return triangulation;
}

/// Tells the floor from what is outside: each wall that is crossed from infinity changes sides.
void mark_floor(Triangulation& triangulation) {
  std::map<Triangulation::Face_handle, bool> inside;
  std::vector<Triangulation::Face_handle> open{triangulation.infinite_face()};
  inside[open.front()] = false;
  while (!open.empty()) {
    const auto face = open.back();
    open.pop_back();
    for (int i = 0; i < 3; ++i) {
      const bool is_inside = inside[face] != triangulation.is_constrained({face, i});
      if (inside.try_emplace(face->neighbor(i), is_inside).second)
        open.push_back(face->neighbor(i));
    }
  }
  for (auto& [face, is_inside] : inside) face->info() = is_inside;
}

/// Half-edges of a mesh from which edges are taken out.
class HalfEdges {
 public:
  explicit HalfEdges(const NavigationMesh& mesh) : mesh_(mesh) {
    const std::size_t count = mesh.corner.size();
    next_.resize(count), previous_.resize(count), twin_.resize(count), gone_.resize(count);
    for (std::uint32_t p = 0; p < mesh.polygons(); ++p) {
      const std::uint32_t first = mesh.first[p], size = mesh.first[p + 1] - first;
      for (std::uint32_t k = 0; k < size; ++k) {
        const std::uint32_t h = first + k;
        next_[h] = first + (k + 1) % size;
        previous_[h] = first + (k + size - 1) % size;
        twin_[h] = mesh.across[h] == NavigationMesh::wall
                       ? NavigationMesh::wall
                       : mesh.first[mesh.across[h]] + mesh.across_edge[h];
      }
    }
  }

  void remove_longest_first() {
    std::vector<std::pair<double, std::uint32_t>> by_length;
    for (std::uint32_t h = 0; h < next_.size(); ++h)
      if (twin_[h] != NavigationMesh::wall && h < twin_[h])
        by_length.emplace_back(-glm::distance(origin(h), origin(next_[h])), h);
    std::ranges::sort(by_length);
    for (const auto& [length, h] : by_length)
      if (stays_convex(h) && stays_convex(twin_[h])) remove(h);
  }

  [[nodiscard]] NavigationMesh mesh() const {
    NavigationMesh result;
    result.vertex = mesh_.vertex;
    result.is_reflex = mesh_.is_reflex;
    std::vector<std::uint32_t> place(next_.size(), NavigationMesh::wall), polygon(next_.size());
    std::vector<std::uint32_t> half_edge;
    for (std::uint32_t begin = 0; begin < next_.size(); ++begin) {
      if (gone_[begin] || place[begin] != NavigationMesh::wall) continue;
      const auto number = static_cast<std::uint32_t>(result.first.size());
      result.first.push_back(static_cast<std::uint32_t>(half_edge.size()));
      std::uint32_t k = 0, h = begin;
      do {
        place[h] = k++, polygon[h] = number;
        half_edge.push_back(h);
        h = next_[h];
      } while (h != begin);
    }
    result.first.push_back(static_cast<std::uint32_t>(half_edge.size()));
    for (const std::uint32_t h : half_edge) {
      const bool is_wall = twin_[h] == NavigationMesh::wall;
      result.corner.push_back(mesh_.corner[h]);
      result.across.push_back(is_wall ? NavigationMesh::wall : polygon[twin_[h]]);
      result.across_edge.push_back(is_wall ? 0 : place[twin_[h]]);
    }
    return result;
  }

 private:
  [[nodiscard]] Vec2 origin(std::uint32_t h) const { return mesh_.vertex[mesh_.corner[h]]; }

  /// Would the corner at the beginning of this edge be strictly convex without the edge?
  [[nodiscard]] bool stays_convex(std::uint32_t h) const {
    return orientation(origin(previous_[h]), origin(h), origin(next_[next_[twin_[h]]])) > 0;
  }

  void remove(std::uint32_t h) {
    const std::uint32_t twin = twin_[h];
    const auto link = [&](std::uint32_t a, std::uint32_t b) { next_[a] = b, previous_[b] = a; };
    link(previous_[h], next_[twin]);
    link(previous_[twin], next_[h]);
    gone_[h] = gone_[twin] = true;
  }

  const NavigationMesh& mesh_;
  std::vector<std::uint32_t> next_, previous_, twin_;
  std::vector<bool> gone_;
};

void count_exits(NavigationMesh& mesh) {
  mesh.exits.assign(mesh.polygons(), 0);
  for (std::uint32_t p = 0; p < mesh.polygons(); ++p)
    for (std::uint32_t k = mesh.first[p]; k < mesh.first[p + 1]; ++k)
      mesh.exits[p] += mesh.across[k] == NavigationMesh::wall ? 0 : 1;
}

}  // namespace

NavigationMesh triangulate(const FloorPlan& plan) {
  NavigationMesh mesh;
  Triangulation triangulation = triangulation_of(plan, mesh);
  mark_floor(triangulation);
  std::map<Triangulation::Face_handle, std::uint32_t> number;
  for (const auto face : triangulation.finite_face_handles())
    if (face->info()) number.emplace(face, static_cast<std::uint32_t>(number.size()));

  std::vector<Triangulation::Face_handle> face_of(number.size());
  for (const auto& [face, n] : number) face_of[n] = face;
  for (const auto& face : face_of) {
    mesh.first.push_back(static_cast<std::uint32_t>(mesh.corner.size()));
    for (int i = 0; i < 3; ++i) {
      const int opposite = Triangulation::cw(i);  // Of the edge from corner i to the next.
      const bool is_wall = triangulation.is_constrained({face, opposite});
      const auto neighbour = face->neighbor(opposite);
      mesh.corner.push_back(face->vertex(i)->info());
      mesh.across.push_back(is_wall ? NavigationMesh::wall : number.at(neighbour));
      const int beyond = triangulation.mirror_index(face, opposite);
      mesh.across_edge.push_back(is_wall ? 0
                                         : static_cast<std::uint32_t>(Triangulation::ccw(beyond)));
    }
  }
  mesh.first.push_back(static_cast<std::uint32_t>(mesh.corner.size()));
  count_exits(mesh);
  return mesh;
}

NavigationMesh merge_polygons(const NavigationMesh& mesh) {
  HalfEdges edges(mesh);
  edges.remove_longest_first();
  NavigationMesh merged = edges.mesh();
  count_exits(merged);
  return merged;
}

PolygonGrid::PolygonGrid(const NavigationMesh& mesh) : mesh_(mesh) {
  Vec2 high = low_ = mesh.vertex.empty() ? Vec2{} : mesh.vertex.front();
  for (const Vec2 p : mesh.vertex) low_ = glm::min(low_, p), high = glm::max(high, p);
  const Vec2 size = high - low_;
  cells_per_metre_ = std::sqrt(mesh.polygons() / std::max(size.x * size.y, 1e-9));
  columns_ = static_cast<int>(size.x * cells_per_metre_) + 1;
  rows_ = static_cast<int>(size.y * cells_per_metre_) + 1;

  std::vector<std::pair<std::size_t, std::uint32_t>> entries;  // Cell, polygon.
  for (std::uint32_t p = 0; p < mesh.polygons(); ++p) {
    Vec2 from = mesh.vertex[mesh.corners(p)[0]], to = from;
    for (const std::uint32_t v : mesh.corners(p))
      from = glm::min(from, mesh.vertex[v]), to = glm::max(to, mesh.vertex[v]);
    for (int row = row_of(from.y); row <= row_of(to.y); ++row)
      for (int column = column_of(from.x); column <= column_of(to.x); ++column)
        entries.emplace_back(cell_of(column, row), p);
  }
  std::ranges::sort(entries);
  cell_first_.assign(cell_of(columns_ - 1, rows_ - 1) + 2, 0);
  for (const auto& [cell, polygon] : entries) {
    ++cell_first_[cell + 1];
    cell_polygon_.push_back(polygon);
  }
  for (std::size_t i = 1; i < cell_first_.size(); ++i) cell_first_[i] += cell_first_[i - 1];
}

int PolygonGrid::column_of(double x) const noexcept {
  return static_cast<int>(std::clamp((x - low_.x) * cells_per_metre_, 0.0, columns_ - 1.0));
}
int PolygonGrid::row_of(double y) const noexcept {
  return static_cast<int>(std::clamp((y - low_.y) * cells_per_metre_, 0.0, rows_ - 1.0));
}
std::size_t PolygonGrid::cell_of(int column, int row) const noexcept {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
         static_cast<std::size_t>(column);
}

void PolygonGrid::find(Vec2 point, std::vector<std::uint32_t>& polygons) const {
  const std::size_t cell = cell_of(column_of(point.x), row_of(point.y));
  for (std::uint32_t i = cell_first_[cell]; i < cell_first_[cell + 1]; ++i) {
    const std::uint32_t polygon = cell_polygon_[i];
    const auto corners = mesh_.corners(polygon);
    Vec2 before = mesh_.vertex[corners.back()];
    const bool holds = std::ranges::all_of(corners, [&](std::uint32_t v) {
      return orientation(std::exchange(before, mesh_.vertex[v]), mesh_.vertex[v], point) >= 0;
    });
    if (holds) polygons.push_back(polygon);
  }
}

}  // namespace docent::bench
