#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "runtime/model/geometry/floor_plan.h"
#include "runtime/model/geometry/vec2.h"

namespace docent::test {

/// The shortest ways of a disc (of a point where the radius is 0) by another road than docent's:
/// every tangent of every pair of circles about reflex vertices is tested against every wall, the
/// circles are walked in either sense between neighbouring touches that are clear of every wall,
/// and Dijkstra searches what is left. No cell, no angle's side, no label and no bound is asked.
class BruteForceWays {
 public:
  /// What misses a wall by less than `slack` metres touches it.
  BruteForceWays(const FloorPlan& plan, double radius, double slack = 1e-9);

  /// Metres; infinite where there is no way. Both ends keep the radius from all walls.
  double length(Vec2 from, Vec2 to) const;

 private:
  struct Edge {
    std::uint32_t to;
    double length;
  };
  /// A place where a way may touch a circle.
  struct Touch {
    std::uint32_t circle;
    double angle;  ///< From the x axis, in (-pi, pi].
    Vec2 place;
  };
  using Graph = std::vector<std::vector<Edge>>;

  bool is_clear(Vec2 p, Vec2 q) const;
  /// The arc from one angle counter-clockwise to another.
  bool is_arc_clear(std::uint32_t circle, double begin, double end) const;
  Touch touch(std::uint32_t circle, Vec2 direction) const;
  /// Tangents between a point and a circle: where they touch.
  std::vector<Touch> touches_from(Vec2 point, std::uint32_t circle) const;
  void connect_circles(std::uint32_t a, std::uint32_t b);
  void connect_along(std::uint32_t circle);
  /// The graph with the ends of a query.
  struct Joined {
    Graph graph;
    std::vector<Touch> touch;
    std::vector<std::vector<std::uint32_t>> on_circle;
  };
  /// Joins a point to the graph; returns its node.
  std::uint32_t join(Vec2 point, Joined& joined) const;
  void join_along(std::uint32_t node, Joined& joined) const;

  const FloorPlan& plan_;
  double radius_, slack_;
  std::vector<Vec2> centre_;
  std::vector<Touch> touch_;  ///< One per node.
  Graph graph_;
  std::vector<std::vector<std::uint32_t>> on_circle_;  ///< Its touches, by angle.
};

}  // namespace docent::test
