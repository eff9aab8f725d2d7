#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "runtime/model/geometry/floor.h"
#include "runtime/path/edge_curve.h"

namespace docent {

/// The Voronoi diagram and the roadmap of a floor made ready for queries. Borrows the floor.
/// Immutable after construction.
class MedialAxisMap {
 public:
  static constexpr std::uint32_t none = 0xffffffff;

  explicit MedialAxisMap(const Floor& floor);

  const Floor& floor() const noexcept { return *floor_; }
  const Roadmap& roadmap() const noexcept { return floor_->roadmap; }
  const VoronoiDiagram& diagram() const noexcept { return floor_->diagram; }

  /// The curve of a Voronoi edge.
  const EdgeCurve& curve(std::uint32_t voronoi_edge) const noexcept { return curve_[voronoi_edge]; }
  /// The curve of a roadmap edge, from its `from` to its `to`.
  const EdgeCurve& curve_of(const RoadmapEdge& edge) const noexcept {
    return curve_[edge.voronoi_edge];
  }
  /// The roadmap edges at a node.
  std::span<const std::uint32_t> edges_at(std::uint32_t node) const noexcept {
    return std::span(node_edge_)
        .subspan(node_first_[node], node_first_[node + 1] - node_first_[node]);
  }
  /// The node at a Voronoi vertex, or none.
  std::uint32_t node_at(std::uint32_t vertex) const noexcept { return vertex_node_[vertex]; }
  /// The Voronoi edge that leads from a Voronoi vertex of the axis towards the roadmap, or none at
  /// its nodes. What the roadmap leaves out are trees, so there is one way.
  std::uint32_t edge_to_road(std::uint32_t vertex) const noexcept { return edge_to_road_[vertex]; }
  std::uint32_t roadmap_edge(std::uint32_t voronoi_edge) const noexcept {
    return edge_roadmap_[voronoi_edge];
  }

  /// A place on the medial axis.
  struct Place {
    std::uint32_t voronoi_edge = none;
    double at = 0;  ///< As EdgeCurve counts it.
  };
  /// Where the straight line from a site through `point`, on from it, meets the medial axis first.
  /// The distance to the walls grows all along that line, at the rate of one. None where the floor
  /// has no diagram.
  std::optional<Place> place_above(std::uint32_t site, Vec2 point) const;

 private:
  void lead_to_road();

  const Floor* floor_;
  std::vector<EdgeCurve> curve_;  ///< Per Voronoi edge.
  std::vector<std::uint32_t> node_first_, node_edge_;
  std::vector<std::uint32_t> vertex_node_;   ///< Per Voronoi vertex: its node, or none.
  std::vector<std::uint32_t> edge_to_road_;  ///< Per Voronoi vertex.
  std::vector<std::uint32_t> edge_roadmap_;  ///< Per Voronoi edge: its roadmap edge, or none.
};

}  // namespace docent
