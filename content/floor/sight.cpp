#include "content/floor/sight.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "content/content_error.h"
#include "content/floor/bend.h"
#include "runtime/model/geometry/orientation.h"
#include "runtime/model/none.h"

namespace docent::floor {
namespace {

/// A finer grid makes shorter lists and costs memory: so many cells, as long as the lists have no
/// more than so many entries. Measured on the reference maps.
constexpr double cells_per_vertex = 10, entries_per_vertex = 400;
/// All lists together are one value of the database, of which SQLite takes 10^9 bytes: so many
/// entries, and one and a half times as many of cells at the edge of what is seen.
constexpr double most_entries = 8e7;
/// So many corners tell how much all of them see.
constexpr std::size_t most_sampled = 256;
/// The tangents of one radius are one value as well, of 48 bytes each, and the compiler holds those
/// of several radii: of points, who have most, so many.
constexpr double most_straight_ways = 8e6;
/// What the rounding of a sight line's end on a wall is given. Metres.
constexpr double margin = 1e-6;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<std::uint32_t, Kernel,
                                              CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>>;

/// The interior as triangles, counter-clockwise. Side 3 t + k of triangle t is opposite its vertex
/// 3 t + k.
struct Mesh {
  std::vector<Vec2> point;               ///< Each place once.
  std::vector<std::uint32_t> point_of;   ///< One per vertex of the plan.
  std::vector<std::uint32_t> vertex;     ///< Three points per triangle.
  std::vector<std::uint32_t> across;     ///< Each side, of the triangle beyond; none behind a wall.
  std::vector<std::uint32_t> fan_first;  ///< One per point and one more.
  std::vector<std::uint32_t> fan;        ///< The sides opposite each point.
};

/// The next side of a triangle, counter-clockwise.
constexpr std::uint32_t next_side(std::uint32_t side) {
  return side % 3 == 2 ? side - 2 : side + 1;
}

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
  for (const auto face : inside)
    for (int k = 0; k < 3; ++k) {
      const auto other = face->neighbor(k);
      const auto index_there = static_cast<std::uint32_t>(other->index(face));
      mesh.vertex.push_back(face->vertex(k)->info());
      mesh.across.push_back(face->is_constrained(k) ? none : 3 * other->info() + index_there);
      ++mesh.fan_first[mesh.vertex.back() + 1];
    }
  for (std::size_t i = 1; i < mesh.fan_first.size(); ++i)
    mesh.fan_first[i] += mesh.fan_first[i - 1];
  mesh.fan.resize(mesh.fan_first.back());
  std::vector<std::uint32_t> fill(mesh.fan_first.begin(), mesh.fan_first.end() - 1);
  for (std::uint32_t side = 0; side < mesh.vertex.size(); ++side)
    mesh.fan[fill[mesh.vertex[side]]++] = side;
  return mesh;
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
      const std::uint32_t side = mesh_.fan[i];
      const std::uint32_t right = mesh_.vertex[next_side(side)];
      const std::uint32_t left = mesh_.vertex[next_side(next_side(side))];
      see(right);
      see(left);
      std::optional<Window> window = beyond({side, right, left}, reach);
      while (window || !stack_.empty()) {
        if (!window) {
          window = stack_.back();
          stack_.pop_back();
        }
        window = look_through(*window, see, reach);
      }
    }
  }

 private:
  /// The view through a side of a triangle, between the rays to two points.
  struct Window {
    std::uint32_t side, right, left;
  };

  /// The same view from the triangle beyond; empty where it ends at a wall.
  template <class Reach>
  std::optional<Window> beyond(const Window& out, Reach reach) const {
    const std::uint32_t across = mesh_.across[out.side];
    if (across != none) return Window{across, out.right, out.left};
    const Vec2 a = mesh_.point[mesh_.vertex[next_side(out.side)]];
    const Vec2 b = mesh_.point[mesh_.vertex[next_side(next_side(out.side))]];
    reach(std::array{eye_, on_wall(a, b, out.right), on_wall(a, b, out.left)});
    return {};
  }

  /// Where the ray to a point meets the line of a wall.
  Vec2 on_wall(Vec2 a, Vec2 b, std::uint32_t through) const {
    const Vec2 ray = mesh_.point[through] - eye_;
    const double from = cross(ray, a - eye_), to = cross(ray, b - eye_);
    if (from == to) return a;
    return a + std::clamp(from / (from - to), 0.0, 1.0) * (b - a);
  }

  /// Looks into a triangle and returns a view out of it; another one goes on the stack.
  template <class See, class Reach>
  std::optional<Window> look_through(const Window& in, See see, Reach reach) {
    const std::uint32_t apex = mesh_.vertex[in.side];
    const Vec2 c = mesh_.point[apex];
    const int of_right = orientation(eye_, mesh_.point[in.right], c);
    // What is not left of the right ray is right of the left one: along a curve that hides itself
    // the view passes thousands of such points.
    const int of_left = of_right > 0 ? orientation(eye_, mesh_.point[in.left], c) : -1;
    if (of_right >= 0 && of_left <= 0) see(apex);
    // Seen from here the side that the view came in by runs from left to right.
    const std::uint32_t right_side = next_side(in.side), left_side = next_side(right_side);
    if (of_right <= 0) return beyond({left_side, in.right, in.left}, reach);
    if (of_left >= 0) return beyond({right_side, in.right, in.left}, reach);
    if (const auto window = beyond({right_side, in.right, apex}, reach)) stack_.push_back(*window);
    return beyond({left_side, apex, in.left}, reach);
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
    if (orientation(plan.vertex[previous[i]], plan.vertex[i], plan.vertex[plan.next[i]]) < 0)
      corners.push_back(i);
  return corners;
}

/// Joins narrow triangles of a view that lie beside each other, so that the many small walls of a
/// curve are as quick to cover as a straight one. What comes out covers all that went in, and
/// reaches at most half a cell further.
class NarrowTriangles {
 public:
  explicit NarrowTriangles(double cell_size) : most_(cell_size / 2) {}

  template <class Cover>
  void add(const std::array<Vec2, 3>& triangle, Cover cover) {
    const double right = glm::length(triangle[1] - triangle[0]);
    const double left = glm::length(triangle[2] - triangle[0]);
    const Fan fan{triangle[0], (triangle[1] - triangle[0]) / right,
                  (triangle[2] - triangle[0]) / left, std::min(right, left), std::max(right, left)};
    if (!(fan.near > 0) || !is_narrow(fan)) {
      cover(triangle);
    } else if (!is_joined_ || !join(fan)) {
      finish(cover);
      joined_ = fan;
      is_joined_ = true;
    }
  }
  /// Before another point looks about.
  template <class Cover>
  void finish(Cover cover) {
    if (!std::exchange(is_joined_, false)) return;
    // As far as the middle of the chord is as far as the ends were.
    const double half = glm::length(joined_.left - joined_.right) / 2;
    const double reach = joined_.far / std::sqrt(1 - half * half);
    cover(std::array{joined_.eye, joined_.eye + reach * joined_.right,
                     joined_.eye + reach * joined_.left});
  }

 private:
  struct Fan {
    Vec2 eye, right, left;  ///< `right` and `left` are unit directions.
    double near, far;       ///< Of the wall from the eye. Metres.
  };
  bool is_narrow(const Fan& fan) const {
    return fan.far - fan.near <= most_ && is_close(fan.left, fan.right, fan.far);
  }
  bool is_close(Vec2 direction, Vec2 other, double far) const {
    return far * glm::length(direction - other) <= std::min(most_, far / 2);
  }
  bool join(const Fan& fan) {
    const Fan both{fan.eye, cross(joined_.right, fan.right) < 0 ? fan.right : joined_.right,
                   cross(joined_.left, fan.left) > 0 ? fan.left : joined_.left,
                   std::min(joined_.near, fan.near), std::max(joined_.far, fan.far)};
    if (!is_close(joined_.right, fan.right, both.far) || !is_narrow(both)) return false;
    joined_ = both;
    return true;
  }

  double most_;  ///< Metres.
  bool is_joined_ = false;
  Fan joined_{};
};

/// `seen_area`: what each corner sees of the floor, of all corners together. Square metres.
void lay_grid(const FloorPlan& plan, double seen_area, SightMap& map) {
  if (plan.vertex.empty()) return;
  Vec2 low = plan.vertex.front(), high = low;
  for (const Vec2 p : plan.vertex) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const Vec2 extent = high - low;
  const auto vertices = static_cast<double>(plan.vertex.size());
  const double cell_area =
      std::max(extent.x * extent.y / (cells_per_vertex * vertices),
               seen_area / std::min(entries_per_vertex * vertices, most_entries));
  map.origin = low;
  map.cell_size = std::max(std::sqrt(cell_area), std::max(extent.x, extent.y) / 4096);
  map.columns = 1 + static_cast<std::uint32_t>(extent.x / map.cell_size);
  map.rows = 1 + static_cast<std::uint32_t>(extent.y / map.cell_size);
}

/// The corners of a plan, as they look about.
struct Eyes {
  std::vector<std::uint32_t> eye;              ///< The point of the mesh that each is at.
  std::vector<std::vector<std::uint32_t>> at;  ///< Those at each point of the mesh.
  std::vector<Bend> bend;
};

/// Puts those at the points seen into `found`, each once, ascending, without the one that looks.
template <class Reach>
void look_about(View& view, const Eyes& eyes, std::uint32_t from, std::vector<std::uint32_t>& found,
                Reach reach) {
  found.clear();
  const auto see = [&](std::uint32_t point) {
    found.insert(found.end(), eyes.at[point].begin(), eyes.at[point].end());
  };
  view.look(eyes.eye[from], see, reach);
  std::ranges::sort(found);
  found.erase(std::ranges::unique(found).begin(), found.end());
  std::erase(found, from);
}

/// What all corners together see, judged by some of them.
struct Sample {
  double area = 0;           ///< Of the floor, by each corner. Square metres.
  double straight_ways = 0;  ///< Of points, from corner to corner.
};

Sample sample(View& view, const Eyes& eyes) {
  Sample sample;
  std::vector<std::uint32_t> seen;
  const std::size_t step = 1 + eyes.eye.size() / most_sampled;
  for (std::size_t i = 0; i < eyes.eye.size(); i += step) {
    look_about(
        view, eyes, static_cast<std::uint32_t>(i), seen, [&](const std::array<Vec2, 3>& triangle) {
          sample.area += std::abs(cross(triangle[1] - triangle[0], triangle[2] - triangle[0])) / 2;
        });
    for (const std::uint32_t other : seen)
      sample.straight_ways += straight_ways_of_a_point(eyes.bend[i], eyes.bend[other]);
  }
  sample.area *= static_cast<double>(step);
  sample.straight_ways *= static_cast<double>(step);
  return sample;
}

/// Refuses a floor whose ways no database would hold.
void check_straight_ways(double ways) {
  if (ways <= most_straight_ways) return;
  throw content::ContentError(
      "", 0, 0, "too-many-lines",
      fmt::format("the corners of this floor see each other along some {:.0f} million lines, and a "
                  "kiosk holds at most {:.0f} million: nearly every corner sees every other",
                  ways / 1e6, most_straight_ways / 1e6),
      "leave away what is jagged or drawn too finely, or make several floors of it");
}

}  // namespace

SightMap make_sight_map(const FloorPlan& plan, const VoronoiDiagram& diagram) {
  SightMap map;
  map.corner = corners_of(plan);
  const Mesh mesh = triangulate(plan);
  Eyes eyes{.eye = {}, .at = {}, .bend = bends_at(plan, diagram, map.corner)};
  eyes.at.resize(mesh.point.size());
  for (std::uint32_t c = 0; c < map.corner.size(); ++c) {
    eyes.eye.push_back(mesh.point_of[map.corner[c]]);
    eyes.at[eyes.eye[c]].push_back(c);
  }
  View view(mesh);
  const Sample sampled = sample(view, eyes);
  check_straight_ways(sampled.straight_ways);
  lay_grid(plan, sampled.area, map);

  CellMarks marks(map);
  NarrowTriangles narrow(map.cell_size);
  std::vector<std::vector<std::uint32_t>> seen_from(std::size_t{map.columns} * map.rows);
  std::vector<std::uint32_t> seen;
  for (std::uint32_t c = 0; c < map.corner.size(); ++c) {
    const auto cover = [&](const std::array<Vec2, 3>& triangle) {
      marks.cover(triangle, c, [&](std::size_t cell) { seen_from[cell].push_back(c); });
    };
    look_about(view, eyes, c, seen,
               [&](const std::array<Vec2, 3>& triangle) { narrow.add(triangle, cover); });
    narrow.finish(cover);
    std::ranges::copy_if(seen, std::back_inserter(map.pair_other), [&](std::uint32_t other) {
      return some_disc_goes_straight(eyes.bend[c], eyes.bend[other]);
    });
    map.pair_first.push_back(static_cast<std::uint32_t>(map.pair_other.size()));
  }
  for (const auto& listed : seen_from) {
    map.cell_corner.insert(map.cell_corner.end(), listed.begin(), listed.end());
    map.cell_first.push_back(static_cast<std::uint32_t>(map.cell_corner.size()));
  }
  return map;
}

}  // namespace docent::floor
