#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "runtime/model/geometry/floor.h"
#include "runtime/model/none.h"
#include "runtime/path/index/box_tree.h"
#include "runtime/path/index/interval_tree.h"
#include "runtime/path/medial_axis/edge_curve.h"
#include "runtime/path/medial_axis/road_graph.h"
#include "runtime/path/shortest/reflex_corner.h"

namespace docent::path {

/// The Voronoi diagram and the roadmap of a floor made ready for queries. Borrows the floor.
/// Immutable after construction.
class MedialAxisMap {
 public:
  explicit MedialAxisMap(const Floor& floor);
  MedialAxisMap(const MedialAxisMap&) = delete;
  MedialAxisMap& operator=(const MedialAxisMap&) = delete;

  const Floor& floor() const noexcept { return *floor_; }
  const Roadmap& roadmap() const noexcept { return floor_->roadmap; }
  const VoronoiDiagram& diagram() const noexcept { return floor_->diagram; }

  /// The curve of a Voronoi edge.
  const EdgeCurve& curve(std::uint32_t voronoi_edge) const noexcept { return curve_[voronoi_edge]; }
  /// The roadmap, ready to be searched.
  const RoadGraph& roads() const noexcept { return roads_; }
  /// The place of the roadmap nearest to `point` for which `accepts(place, its point)` is true;
  /// `accepts` is asked about the nearest place of each edge, nearest first. None where it takes
  /// none.
  template <class Accepts>
  std::optional<RoadGraph::Place> nearest_road(Vec2 point, Accepts accepts) const;

  /// The node at a Voronoi vertex, or none.
  std::uint32_t node_at(std::uint32_t vertex) const noexcept { return vertex_node_[vertex]; }
  /// The Voronoi edge that leads from a Voronoi vertex of the axis towards the roadmap; none at the
  /// roadmap's nodes. The parts that the roadmap leaves out are trees, so there is only one way.
  std::uint32_t edge_to_road(std::uint32_t vertex) const noexcept { return edge_to_road_[vertex]; }
  std::uint32_t roadmap_edge(std::uint32_t voronoi_edge) const noexcept {
    return edge_roadmap_[voronoi_edge];
  }

  /// The edges of the medial axis at a Voronoi vertex, dead ends into corners included.
  std::span<const std::uint32_t> axis_edges_at(std::uint32_t vertex) const noexcept {
    return std::span(axis_edge_)
        .subspan(axis_first_[vertex], axis_first_[vertex + 1] - axis_first_[vertex]);
  }
  /// The place of a Voronoi edge in VoronoiDiagram::region_edge, in the loop of one of its sites.
  std::uint32_t place_in_loop(std::uint32_t voronoi_edge, std::uint32_t site) const noexcept {
    return diagram().edge[voronoi_edge].left == site ? left_place_[voronoi_edge]
                                                     : right_place_[voronoi_edge];
  }
  /// The reflex corner of a site that is one.
  const ReflexCorner& corner(std::uint32_t site) const noexcept { return corner_[site]; }
  /// The clearance along a Voronoi edge is at least `low` and at most `high`, and reaches both.
  const Interval& clearances(std::uint32_t voronoi_edge) const noexcept {
    return clearance_[voronoi_edge];
  }
  /// Calls visit(e) for each Voronoi edge whose clearance is somewhere above `level` and somewhere
  /// not.
  template <class Visitor>
  void visit_edges_across(double level, Visitor visit) const {
    by_clearance_.visit_containing(level, visit);
  }

  /// A place on the medial axis.
  struct Place {
    std::uint32_t voronoi_edge = none;
    double at = 0;  ///< As EdgeCurve counts it.
  };
  /// Where the straight line that comes from a site through `point` meets the medial axis first
  /// beyond `point`. All along that line the clearance grows by a metre for each metre. None where
  /// the floor has no diagram.
  std::optional<Place> place_above(std::uint32_t site, Vec2 point) const;

 private:
  void lead_to_road();
  void spread_roads();
  void follow_regions();
  RoadGraph::Place nearest_place(std::uint32_t thing, Vec2 point) const;

  const Floor* floor_;
  std::vector<EdgeCurve> curve_;  ///< Per Voronoi edge.
  RoadGraph roads_;
  BoxTree road_tree_;  ///< Of the roadmap's edges, then of the nodes without edges.
  std::vector<std::uint32_t> lone_node_;
  std::vector<std::uint32_t> axis_first_, axis_edge_;
  std::vector<std::uint32_t> left_place_, right_place_;  ///< Per Voronoi edge.
  std::vector<ReflexCorner> corner_;                     ///< Per site; unused for walls.
  std::vector<Interval> clearance_;                      ///< Per Voronoi edge.
  IntervalTree by_clearance_;                            ///< Of the Voronoi edges.
  std::vector<std::uint32_t> vertex_node_;               ///< Per Voronoi vertex: its node, or none.
  std::vector<std::uint32_t> edge_to_road_;              ///< Per Voronoi vertex.
  std::vector<std::uint32_t> edge_roadmap_;  ///< Per Voronoi edge: its roadmap edge, or none.
};

template <class Accepts>
std::optional<RoadGraph::Place> MedialAxisMap::nearest_road(Vec2 point, Accepts accepts) const {
  std::optional<RoadGraph::Place> found;
  const auto squared_distance_of = [&](std::uint32_t thing) {
    const Vec2 apart = roads_.point_at(nearest_place(thing, point)) - point;
    return dot(apart, apart);
  };
  road_tree_.meet_nearest_first(point, squared_distance_of, [&](std::uint32_t thing) {
    const RoadGraph::Place place = nearest_place(thing, point);
    if (accepts(place, roads_.point_at(place))) found = place;
    return !found;
  });
  return found;
}

}  // namespace docent::path
