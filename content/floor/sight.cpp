#include "content/floor/sight.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "runtime/model/none.h"

namespace docent::floor {
namespace {

/// A finer grid makes shorter lists and costs memory: so many cells, as long as the lists have no
/// more than so many entries. Measured on the reference maps.
constexpr double cells_per_vertex = 10, entries_per_vertex = 400;
/// What the rounding of a sight line's end on a wall is given. Metres.
constexpr double margin = 1e-6;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<std::uint32_t, Kernel,
                                              CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>>;

/// The interior as triangles, counter-clockwise. Side k of a triangle is opposite its vertex k.
struct Mesh {
  struct Triangle {
    std::array<std::uint32_t, 3> vertex;
    std::array<std::uint32_t, 3> across;  ///< The triangle beyond each side; none behind a wall.
  };
  std::vector<Vec2> point;              ///< Each place once.
  std::vector<std::uint32_t> point_of;  ///< One per vertex of the plan.
  std::vector<Triangle> triangle;
  std::vector<std::uint32_t> fan_first;  ///< One per point and one more.
  std::vector<std::uint32_t> fan;        ///< The triangles about each point.
};

/// Numbers the faces of the interior: those with an odd number of walls between them and outside.
std::vector<Cdt::Face_handle> number_interior(Cdt& cdt) {
  constexpr std::uint32_t unseen = none - 1;
  for (const auto face : cdt.all_face_handles()) face->info() = unseen;
  std::vector<Cdt::Face_handle> inside;
  std::vector<std::pair<Cdt::Face_handle, bool>> stack{{cdt.infinite_face(), false}};
  cdt.infinite_face()->info() = none;
  while (!stack.empty()) {
    const auto [face, is_inside] = stack.back();
    stack.pop_back();
    for (int side = 0; side < 3; ++side) {
      const auto other = face->neighbor(side);
      if (other->info() != unseen) continue;
      const bool other_inside = is_inside != face->is_constrained(side);
      other->info() = none;
      if (other_inside && !cdt.is_infinite(other)) {
        other->info() = static_cast<std::uint32_t>(inside.size());
        inside.push_back(other);
      }
      stack.emplace_back(other, other_inside);
    }
  }
  return inside;
}

Mesh triangulate(const FloorPlan& plan) {
  Mesh mesh;
  Cdt cdt;
  mesh.point_of.resize(plan.vertex.size());
  std::map<std::pair<double, double>, std::uint32_t> known;
  std::vector<Kernel::Point_2> points;
  for (std::size_t i = 0; i < plan.vertex.size(); ++i) {
    const Vec2 p = plan.vertex[i];
    const auto [place, is_new] =
        known.emplace(std::pair{p.x, p.y}, static_cast<std::uint32_t>(points.size()));
    if (is_new) {
      points.emplace_back(p.x, p.y);
      mesh.point.push_back(p);
    }
    mesh.point_of[i] = place->second;
  }
  std::vector<std::pair<std::size_t, std::size_t>> walls;
  for (std::size_t i = 0; i < plan.vertex.size(); ++i)
    walls.emplace_back(mesh.point_of[i], mesh.point_of[plan.next[i]]);
  cdt.insert_constraints(points.begin(), points.end(), walls.begin(), walls.end());
  for (const auto vertex : cdt.finite_vertex_handles())
    vertex->info() = known.at({vertex->point().x(), vertex->point().y()});

  const std::vector<Cdt::Face_handle> inside = number_interior(cdt);
  mesh.fan_first.assign(points.size() + 1, 0);
  for (const auto face : inside) {
    Mesh::Triangle triangle{};
    for (int k = 0; k < 3; ++k) {
      const auto side = static_cast<std::size_t>(k);
      triangle.vertex[side] = face->vertex(k)->info();
      triangle.across[side] = face->is_constrained(k) ? none : face->neighbor(k)->info();
      ++mesh.fan_first[triangle.vertex[side] + 1];
    }
    mesh.triangle.push_back(triangle);
  }
  for (std::size_t i = 1; i < mesh.fan_first.size(); ++i)
    mesh.fan_first[i] += mesh.fan_first[i - 1];
  mesh.fan.resize(mesh.fan_first.back());
  std::vector<std::uint32_t> fill(mesh.fan_first.begin(), mesh.fan_first.end() - 1);
  for (std::uint32_t t = 0; t < mesh.triangle.size(); ++t)
    for (const std::uint32_t vertex : mesh.triangle[t].vertex) mesh.fan[fill[vertex]++] = t;
  return mesh;
}

int side_of(Vec2 a, Vec2 b, Vec2 c) {
  return static_cast<int>(CGAL::orientation(Kernel::Point_2(a.x, a.y), Kernel::Point_2(b.x, b.y),
                                            Kernel::Point_2(c.x, c.y)));
}

/// Marks the cells of a grid that triangles touch, each once a round.
class CellMarks {
 public:
  CellMarks(const SightMap& map) : map_(map), marked_(std::size_t{map.columns} * map.rows, none) {}

  /// Calls `mark(cell)` for every cell that the triangle touches and that was not yet marked in
  /// this round.
  template <class Mark>
  void cover(const std::array<Vec2, 3>& triangle, std::uint32_t round, Mark mark) {
    const auto [low, high] = std::minmax({triangle[0].y, triangle[1].y, triangle[2].y});
    for (std::uint32_t row = index((low - margin - map_.origin.y), map_.rows),
                       last = index((high + margin - map_.origin.y), map_.rows);
         row <= last; ++row) {
      const double bottom = map_.origin.y + row * map_.cell_size;
      const auto [left, right] =
          extent_in(triangle, bottom - margin, bottom + map_.cell_size + margin);
      if (left > right) continue;
      for (std::uint32_t column = index(left - margin - map_.origin.x, map_.columns),
                         end = index(right + margin - map_.origin.x, map_.columns);
           column <= end; ++column) {
        const std::size_t cell = std::size_t{row} * map_.columns + column;
        if (std::exchange(marked_[cell], round) != round) mark(cell);
      }
    }
  }

 private:
  std::uint32_t index(double metres, std::uint32_t count) const {
    return static_cast<std::uint32_t>(std::clamp(metres / map_.cell_size, 0.0, count - 1.0));
  }
  /// The extent in x of the part of a triangle between two heights.
  static std::pair<double, double> extent_in(const std::array<Vec2, 3>& triangle, double bottom,
                                             double top) {
    double left = std::numeric_limits<double>::infinity(), right = -left;
    const auto include = [&](double x) {
      left = std::min(left, x);
      right = std::max(right, x);
    };
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2 a = triangle[k], b = triangle[(k + 1) % 3];
      if (a.y >= bottom && a.y <= top) include(a.x);
      for (const double y : {bottom, top})
        if ((a.y < y) != (b.y < y)) include(a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y)));
    }
    return {left, right};
  }

  const SightMap& map_;
  std::vector<std::uint32_t> marked_;
};

/// Looks about from one point of the mesh: which points it sees, and which triangles of the view
/// end at walls.
class View {
 public:
  explicit View(const Mesh& mesh) : mesh_(mesh) {}

  /// `see(point)` for every point of the mesh that is seen, perhaps twice; `reach(triangle)` for
  /// triangles that together are what is seen of the interior.
  template <class See, class Reach>
  void look(std::uint32_t from, See see, Reach reach) {
    eye_ = mesh_.point[from];
    for (std::uint32_t i = mesh_.fan_first[from]; i < mesh_.fan_first[from + 1]; ++i) {
      const Mesh::Triangle& triangle = mesh_.triangle[mesh_.fan[i]];
      const auto apex = static_cast<std::size_t>(std::ranges::find(triangle.vertex, from) -
                                                 triangle.vertex.begin());
      const std::uint32_t right = triangle.vertex[(apex + 1) % 3];
      const std::uint32_t left = triangle.vertex[(apex + 2) % 3];
      see(right);
      see(left);
      pass({mesh_.fan[i], apex, right, left}, reach);
      while (!stack_.empty()) {
        const Window window = stack_.back();
        stack_.pop_back();
        look_through(window, see, reach);
      }
    }
  }

 private:
  /// The view through one side of a triangle (out of it), between the rays to two points.
  struct Window {
    std::uint32_t triangle;
    std::size_t side;
    std::uint32_t right, left;
  };

  template <class Reach>
  void pass(const Window& window, Reach reach) {
    const Mesh::Triangle& triangle = mesh_.triangle[window.triangle];
    if (triangle.across[window.side] != none) {
      stack_.push_back(window);
      return;
    }
    const Vec2 a = mesh_.point[triangle.vertex[(window.side + 1) % 3]];
    const Vec2 b = mesh_.point[triangle.vertex[(window.side + 2) % 3]];
    reach(std::array{eye_, on_wall(a, b, window.right), on_wall(a, b, window.left)});
  }

  /// Where the ray to a point meets the line of a wall.
  Vec2 on_wall(Vec2 a, Vec2 b, std::uint32_t through) const {
    const Vec2 ray = mesh_.point[through] - eye_;
    const double from = cross(ray, a - eye_), to = cross(ray, b - eye_);
    if (from == to) return a;
    return a + std::clamp(from / (from - to), 0.0, 1.0) * (b - a);
  }

  template <class See, class Reach>
  void look_through(const Window& window, See see, Reach reach) {
    const Mesh::Triangle& before = mesh_.triangle[window.triangle];
    const std::uint32_t next = before.across[window.side];
    const Mesh::Triangle& triangle = mesh_.triangle[next];
    const std::uint32_t right_end = before.vertex[(window.side + 1) % 3];
    // The side that we enter by runs the other way round here.
    const auto at = static_cast<std::size_t>(std::ranges::find(triangle.vertex, right_end) -
                                             triangle.vertex.begin());
    const std::uint32_t apex = triangle.vertex[(at + 1) % 3];
    const Vec2 c = mesh_.point[apex];
    const int of_right = side_of(eye_, mesh_.point[window.right], c);
    const int of_left = side_of(eye_, mesh_.point[window.left], c);
    if (of_right >= 0 && of_left <= 0) see(apex);
    // Sides of the next triangle: right_end to apex is opposite `at + 2`, apex to the left end
    // opposite `at`.
    if (of_right > 0)
      pass({next, (at + 2) % 3, window.right, of_left < 0 ? apex : window.left}, reach);
    if (of_left < 0) pass({next, at, of_right > 0 ? apex : window.right, window.left}, reach);
  }

  const Mesh& mesh_;
  Vec2 eye_{};
  std::vector<Window> stack_;
};

/// The corners that a disc may bend at: those that do not turn left.
std::vector<std::uint32_t> corners_of(const FloorPlan& plan) {
  std::vector<std::uint32_t> previous(plan.vertex.size());
  for (std::uint32_t i = 0; i < plan.vertex.size(); ++i) previous[plan.next[i]] = i;
  std::vector<std::uint32_t> corners;
  for (std::uint32_t i = 0; i < plan.vertex.size(); ++i)
    if (side_of(plan.vertex[previous[i]], plan.vertex[i], plan.vertex[plan.next[i]]) < 0)
      corners.push_back(i);
  return corners;
}

/// `seen`: how many corners a corner sees on average.
void lay_grid(const FloorPlan& plan, double seen, SightMap& map) {
  if (plan.vertex.empty()) return;
  Vec2 low = plan.vertex.front(), high = low;
  for (const Vec2 p : plan.vertex) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const Vec2 extent = high - low;
  const double cells = std::min(cells_per_vertex, entries_per_vertex / std::max(seen, 1.0));
  map.origin = low;
  map.cell_size =
      std::max(std::sqrt(extent.x * extent.y / (cells * static_cast<double>(plan.vertex.size()))),
               std::max(extent.x, extent.y) / 4096);
  map.columns = 1 + static_cast<std::uint32_t>(extent.x / map.cell_size);
  map.rows = 1 + static_cast<std::uint32_t>(extent.y / map.cell_size);
}

}  // namespace

SightMap make_sight_map(const FloorPlan& plan) {
  SightMap map;
  map.corner = corners_of(plan);
  const Mesh mesh = triangulate(plan);
  std::vector<std::vector<std::uint32_t>> corners_at(mesh.point.size());
  for (std::uint32_t c = 0; c < map.corner.size(); ++c)
    corners_at[mesh.point_of[map.corner[c]]].push_back(c);

  View view(mesh);
  const auto nothing = [](const auto&) {};
  std::vector<std::uint32_t> seen;
  for (std::uint32_t c = 0; c < map.corner.size(); ++c) {
    seen.clear();
    const auto see = [&](std::uint32_t point) {
      seen.insert(seen.end(), corners_at[point].begin(), corners_at[point].end());
    };
    view.look(mesh.point_of[map.corner[c]], see, nothing);
    std::ranges::sort(seen);
    seen.erase(std::ranges::unique(seen).begin(), seen.end());
    std::erase(seen, c);
    map.pair_other.insert(map.pair_other.end(), seen.begin(), seen.end());
    map.pair_first.push_back(static_cast<std::uint32_t>(map.pair_other.size()));
  }

  const auto corners = static_cast<double>(std::max<std::size_t>(map.corner.size(), 1));
  lay_grid(plan, static_cast<double>(map.pair_other.size()) / corners, map);
  CellMarks marks(map);
  std::vector<std::vector<std::uint32_t>> seen_from(std::size_t{map.columns} * map.rows);
  for (std::uint32_t c = 0; c < map.corner.size(); ++c)
    view.look(mesh.point_of[map.corner[c]], nothing, [&](const std::array<Vec2, 3>& triangle) {
      marks.cover(triangle, c, [&](std::size_t cell) { seen_from[cell].push_back(c); });
    });
  for (const auto& listed : seen_from) {
    map.cell_corner.insert(map.cell_corner.end(), listed.begin(), listed.end());
    map.cell_first.push_back(static_cast<std::uint32_t>(map.cell_corner.size()));
  }
  return map;
}

}  // namespace docent::floor
