#include "content/floor/medial_axis.h"

#include <algorithm>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "runtime/model/geometry/bisector.h"
#include "runtime/model/none.h"

namespace docent::floor {
namespace {

/// Metres. A dead end whose discs reach less than this beyond its junction's disc is noise.
constexpr double smallest_reach = 0.05;
/// Metres. Nobody stands where the clearance is less: a dead end that closes to it and opens
/// towards its junction like a corner of 60 degrees or more is a corner that was traced with many
/// walls.
constexpr double smallest_tip = 0.15;
constexpr double corner_slope = 0.5;

/// The medial axis while it is being pruned; vertices and edges are the diagram's.
class Axis {
 public:
  explicit Axis(const VoronoiDiagram& diagram)
      : diagram_(diagram),
        edges_at_(diagram.vertex.size()),
        discs_(diagram.vertex.size()),
        is_node_(diagram.vertex.size(), false),
        is_kept_(diagram.edge.size(), false) {
    for (std::uint32_t e = 0; e < diagram.edge.size(); ++e) add(e);
  }

  void prune_noise() {
    for (std::uint32_t v = 0; v < edges_at_.size(); ++v) consider(v);
    while (!dead_ends_.empty()) {
      const auto [significance, leaf] = *dead_ends_.begin();
      if (significance >= 0) return;
      remove(leaf);
    }
  }

  [[nodiscard]] bool is_node(std::uint32_t vertex) const { return is_node_[vertex]; }
  [[nodiscard]] bool is_kept(std::uint32_t edge) const { return is_kept_[edge]; }

 private:
  /// Takes in an edge, unless it runs into a convex corner of the plan, where the clearance is 0:
  /// that counts as pruned already.
  void add(std::uint32_t e) {
    const VoronoiEdge& edge = diagram_.edge[e];
    if (!edge.on_medial_axis) return;
    const bool from = diagram_.clearance[edge.from] > 0, to = diagram_.clearance[edge.to] > 0;
    if (from) is_node_[edge.from] = true;
    if (to) is_node_[edge.to] = true;
    if (from && !to) discs_[edge.from].push_back(edge.to);
    if (to && !from) discs_[edge.to].push_back(edge.from);
    if (!from || !to) return;
    is_kept_[e] = true;
    edges_at_[edge.from].push_back(e);
    edges_at_[edge.to].push_back(e);
  }

  [[nodiscard]] std::uint32_t other_end(std::uint32_t e, std::uint32_t v) const {
    return diagram_.edge[e].from == v ? diagram_.edge[e].to : diagram_.edge[e].from;
  }

  /// How far the discs of a dead end, its leaf and what was pruned there, reach beyond the disc of
  /// the junction, less what may be forgiven: negative for one that matters to nobody.
  [[nodiscard]] double significance_of(std::uint32_t leaf) const {
    const std::uint32_t junction = other_end(edges_at_[leaf].front(), leaf);
    double tip = diagram_.clearance[leaf];
    for (const std::uint32_t v : discs_[leaf]) tip = std::min(tip, diagram_.clearance[v]);
    const auto unforgiven = [&](std::uint32_t v) {
      const double way = glm::distance(diagram_.vertex[v], diagram_.vertex[junction]);
      const double reach = way + diagram_.clearance[v] - diagram_.clearance[junction];
      const double corner = tip < smallest_tip ? (1 - corner_slope) * way : 0.0;
      return reach - std::max(smallest_reach, corner);
    };
    double most = unforgiven(leaf);
    for (const std::uint32_t v : discs_[leaf]) most = std::max(most, unforgiven(v));
    return most;
  }

  void consider(std::uint32_t v) {
    if (edges_at_[v].size() == 1) dead_ends_.insert({significance_of(v), v});
  }

  void remove(std::uint32_t leaf) {
    dead_ends_.erase({significance_of(leaf), leaf});
    const std::uint32_t edge = edges_at_[leaf].front();
    const std::uint32_t junction = other_end(edge, leaf);
    if (edges_at_[junction].size() == 1) dead_ends_.erase({significance_of(junction), junction});
    is_kept_[edge] = false;
    is_node_[leaf] = false;
    edges_at_[leaf].clear();
    std::erase(edges_at_[junction], edge);
    discs_[junction].push_back(leaf);
    discs_[junction].insert(discs_[junction].end(), discs_[leaf].begin(), discs_[leaf].end());
    consider(junction);
  }

  const VoronoiDiagram& diagram_;
  std::vector<std::vector<std::uint32_t>> edges_at_;      ///< Per vertex, those kept.
  std::vector<std::vector<std::uint32_t>> discs_;         ///< Per vertex, what was pruned there.
  std::vector<bool> is_node_;                             ///< Per vertex.
  std::vector<bool> is_kept_;                             ///< Per edge.
  std::set<std::pair<double, std::uint32_t>> dead_ends_;  ///< Significance, leaf; least first.
};

}  // namespace

Roadmap medial_axis(const FloorPlan& plan, const VoronoiDiagram& diagram) {
  Axis axis(diagram);
  axis.prune_noise();

  Roadmap roadmap;
  std::vector<std::uint32_t> node(diagram.vertex.size(), none);
  for (std::uint32_t v = 0; v < diagram.vertex.size(); ++v) {
    if (!axis.is_node(v)) continue;
    node[v] = static_cast<std::uint32_t>(roadmap.position.size());
    roadmap.position.push_back(diagram.vertex[v]);
    roadmap.clearance.push_back(diagram.clearance[v]);
    roadmap.voronoi_vertex.push_back(v);
  }
  for (std::uint32_t e = 0; e < diagram.edge.size(); ++e) {
    if (!axis.is_kept(e)) continue;
    const VoronoiEdge& edge = diagram.edge[e];
    roadmap.edges.push_back({.from = node[edge.from],
                             .to = node[edge.to],
                             .voronoi_edge = e,
                             .length = length_of(plan, diagram, edge),
                             .clearance = least_clearance(plan, diagram, edge)});
  }
  return roadmap;
}

}  // namespace docent::floor
