#pragma once

#include <cstdint>
#include <vector>

#include "runtime/model/none.h"
#include "tests/bench/found_path.h"
#include "tests/bench/navigation_mesh.h"

namespace docent::bench {

/// Polyanya: the exact any-angle search over a mesh of convex polygons (Cui, Harabor and Grastien
/// 2017, "Compromise-free Pathfinding on a Navigation Mesh", IJCAI). Here to be compared with.
///
/// A search node is a root, where the path last bent, with an interval of a polygon's edge that the
/// root sees. The authors' code bounds intervals by computed points and compares with an absolute
/// epsilon, which goes wrong on small coordinates. Here the sight of a root is bounded by lines
/// through vertices of the mesh, so every decision about what is seen is an exact predicate on
/// given coordinates; computed points serve only to bound lengths from below.
///
/// One thread may search at a time.
class Polyanya {
 public:
  explicit Polyanya(NavigationMesh mesh);

  /// The shortest path of a point.
  FoundPath find(Vec2 from, Vec2 to);

 private:
  /// A directed line through two points, by their numbers.
  struct Line {
    std::uint32_t a = none, b = none;
  };
  /// Where an interval ends: at a vertex of the mesh, or where sight is cut off (`vertex` is none).
  struct End {
    Vec2 at{};
    std::uint32_t vertex = none;
  };
  /// Left and right as seen from the root.
  struct Interval {
    Line left_sight, right_sight;
    End left, right;
  };
  struct Node {
    std::uint32_t parent = none;
    std::uint32_t root = none;     ///< A vertex, or start_.
    double g = 0;                  ///< Length of the path up to the root.
    double f = 0;                  ///< Lower bound for a path through the interval.
    std::uint32_t polygon = none;  ///< Beyond the interval; none for a path that is complete.
    std::uint32_t entry = 0;       ///< The edge of that polygon which holds the interval.
    Interval interval{};
  };
  /// The edges of a polygon in the order in which they are met from right to left, beginning after
  /// the entry; and on which side of the lines of sight their ends lie.
  struct EdgeView {
    std::uint32_t edge = 0;
    std::uint32_t right = 0, left = 0;          ///< Vertices.
    int right_of_right = 0, right_of_left = 0;  ///< Side of vertex `right` from each line of sight.
    int left_of_right = 0, left_of_left = 0;    ///< Side of vertex `left`.
  };

  [[nodiscard]] int side(Line line, std::uint32_t vertex) const;
  [[nodiscard]] Vec2 meet(Line line, const EdgeView& edge) const;
  [[nodiscard]] double lower_bound(Vec2 root, const Interval& interval, const EdgeView& edge) const;
  [[nodiscard]] bool holds_goal(std::uint32_t polygon) const;

  void start_in(std::uint32_t polygon);
  void expand(const Node& node);
  void look_through(const Node& node, const EdgeView& edge);
  void turn_right(const Node& node, const EdgeView& edge, double g);
  void turn_left(const Node& node, const EdgeView& edge, double g);
  void add_whole_edge(const Node& node, std::uint32_t root, double g, const EdgeView& edge);
  void add(const Node& node, std::uint32_t root, double g, const EdgeView& edge,
           const Interval& interval);
  void reach_goal(const Node& node);
  void reach_goal_from(const Node& node, std::uint32_t root);
  void push_successors();
  void push(const Node& node);
  Node pop();
  [[nodiscard]] FoundPath path_to(const Node& last) const;

  NavigationMesh mesh_;
  PolygonGrid grid_;
  std::uint32_t start_ = 0;  ///< The number of the start, one past the vertices.
  std::vector<Vec2> point_;  ///< The vertices, and the start.
  double rounding_ = 0;      ///< Metres; lengths that differ by less are taken for equal.
  Vec2 goal_{};
  std::vector<std::uint32_t> start_polygons_, goal_polygons_;
  std::vector<double> best_g_;          ///< Per point, valid where reached_ is the present query.
  std::vector<std::uint32_t> reached_;  ///< The query that last reached a point.
  std::uint32_t query_ = 0;
  std::vector<Node> expanded_;  ///< Parents of other nodes.
  std::vector<Node> open_;      ///< A heap, the smallest f on top.
  std::vector<Node> successors_;
};

}  // namespace docent::bench
