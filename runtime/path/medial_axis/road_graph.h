#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "runtime/model/geometry/roadmap.h"
#include "runtime/model/none.h"
#include "runtime/path/medial_axis/edge_curve.h"
#include "runtime/path/way.h"

namespace docent::path {

/// The roadmap as a search sees it: every chain of its edges between two junctions is one road.
///
/// Junctions are the nodes at which other than two edges end, and one node of every loop without
/// any. Borrows the roadmap and its curves (those of Voronoi edges). Immutable.
class RoadGraph {
 public:
  /// How many junctions, far from each other, all distances are kept to, for `least_distance`.
  static constexpr std::size_t landmarks = 8;

  /// A step is a roadmap edge as its road runs through it.
  struct Step {
    std::uint32_t edge = 0;  ///< Of the roadmap.
    std::uint32_t road = 0;
    double begin = 0, end = 0;    ///< Places on the edge's curve, in the road's direction.
    double before = 0;            ///< Metres of road before the step.
    double clearance_before = 0;  ///< The smallest clearance of the road before the step.
    double clearance_after = 0;   ///< The same after it. Infinite where nothing is there.
    std::uint32_t first_point = 0, end_point = 0;  ///< The flattened step, both ends included.
  };
  struct Road {
    std::uint32_t from = 0, to = 0;           ///< Junctions.
    std::uint32_t first_step = 0, steps = 0;  ///< In order.
    double length = 0;                        ///< Metres.
    double clearance = 0;                     ///< Metres, the smallest.
    double greatest_clearance = 0;
  };
  /// A place on a road; or at a junction, where `step` is none.
  struct Place {
    std::uint32_t step = none;
    double at = 0;  ///< As the edge's curve counts.
    std::uint32_t junction = none;
  };
  /// How to get from a place to an end of its road.
  struct Exit {
    std::uint32_t junction = none;
    double length = 0;
    double clearance = std::numeric_limits<double>::infinity();
  };

  RoadGraph(const Roadmap& roadmap, std::span<const EdgeCurve> curve);

  std::size_t junctions() const noexcept { return junction_node_.size(); }
  std::span<const Road> roads() const noexcept { return road_; }
  Vec2 position(std::uint32_t junction) const noexcept {
    return roadmap_->position[junction_node_[junction]];
  }
  /// The roads at a junction: twice each road's number, plus one where the road ends there.
  std::span<const std::uint32_t> roads_at(std::uint32_t junction) const noexcept {
    return std::span(junction_road_)
        .subspan(junction_first_[junction],
                 junction_first_[junction + 1] - junction_first_[junction]);
  }

  Place place_on(std::uint32_t edge, double at) const noexcept {
    return {edge_step_[edge], at, none};
  }
  Place place_at(std::uint32_t node) const noexcept { return node_place_[node]; }
  Vec2 point_at(const Place& place) const noexcept;
  /// The ways from a place to the beginning and to the end of its road; at a junction there is one
  /// way, of length 0.
  std::array<Exit, 2> exits_of(const Place& place) const noexcept;
  /// The way between two places of one road, along that road; none where they are not on one.
  struct Between {
    double length = 0, clearance = 0;
  };
  std::optional<Between> between(const Place& from, const Place& to) const noexcept;

  /// The largest clearance that some way between two junctions keeps, metres; negative where there
  /// is no way, infinite for a junction and itself. Logarithmic in the number of junctions.
  double widest(std::uint32_t from, std::uint32_t to) const noexcept;
  /// A lower bound, metres, of every way on the roads between a junction and a place, whose
  /// distances to the landmarks `distances_of` gives.
  using Distances = std::array<double, landmarks>;
  Distances distances_of(const Place& place) const noexcept;
  double least_distance(std::uint32_t junction, const Distances& to) const noexcept;

  /// The beginning of a road, or its end, as a place on it.
  Place begin_of(std::uint32_t road) const noexcept {
    return {road_[road].first_step, step_[road_[road].first_step].begin, none};
  }
  Place end_of(std::uint32_t road) const noexcept {
    const std::uint32_t last = road_[road].first_step + road_[road].steps - 1;
    return {last, step_[last].end, none};
  }
  std::uint32_t node_of(std::uint32_t junction) const noexcept { return junction_node_[junction]; }
  std::uint32_t road_of_edge(std::uint32_t edge) const noexcept {
    return step_[edge_step_[edge]].road;
  }
  /// The road of a place; none at a junction.
  std::uint32_t road_of(const Place& place) const noexcept {
    return place.step == none ? none : step_[place.step].road;
  }
  /// Appends the points of the road between two places on it, both included.
  void append_between(const Place& from, const Place& to, std::vector<Vec2>& points) const;

 private:
  const EdgeCurve& curve_of(const Step& step) const noexcept {
    return curve_[roadmap_->edges[step.edge].voronoi_edge];
  }
  void find_junctions();
  void follow(std::uint32_t node, std::uint32_t edge, const std::vector<std::uint32_t>& first,
              const std::vector<std::uint32_t>& edges);
  void finish_road(Road road);
  void list_roads();
  void grow_widest_tree();
  void measure_landmarks();
  std::vector<double> distances_from(std::uint32_t junction) const;

  const Roadmap* roadmap_;
  std::span<const EdgeCurve> curve_;
  std::vector<Road> road_;
  std::vector<Step> step_;
  std::vector<Vec2> point_;                   ///< Of the flattened steps, in their order.
  std::vector<std::uint32_t> edge_step_;      ///< Per roadmap edge.
  std::vector<Place> node_place_;             ///< Per roadmap node.
  std::vector<std::uint32_t> junction_node_;  ///< Per junction: its roadmap node.
  std::vector<std::uint32_t> junction_first_, junction_road_;
  /// Per junction: which junction it was joined to, and by which clearance. A forest that gives the
  /// answers of a maximum spanning tree: clearances fall towards the root, and no branch is longer
  /// than the logarithm of the number of junctions.
  std::vector<std::uint32_t> joined_to_;
  std::vector<double> joined_by_;
  std::vector<Distances> distance_;  ///< Per junction, to each landmark; 0 where there is no way.
};

}  // namespace docent::path
