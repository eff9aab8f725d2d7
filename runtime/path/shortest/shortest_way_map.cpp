#include "runtime/path/shortest/shortest_way_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "runtime/path/flatten.h"
#include "runtime/path/shortest/arc_angle.h"
#include "runtime/path/shortest/make_tangent_graph.h"
#include "runtime/path/shortest/savings.h"

namespace docent::path {

ShortestWayMap::ShortestWayMap(const FloorPlan& plan, const SightMap& sight,
                               const TangentGraph& tangents, const HubLabels& labels,
                               const TangentSearchMap& search)
    : graph_(tangents),
      labels_(labels),
      sight_(sight),
      search_(search),
      walls_(plan, tangents.radius),
      rolling_(rolling_radius(tangents.radius, walls_.slack())) {
  const double farthest = walls_.cell_size() * std::numbers::sqrt2 / 2 + walls_.slack();
  for (std::size_t cell = 0; cell < walls_.cells(); ++cell) {
    const Vec2 centre = walls_.centre_of(cell);
    const WallGrid::Nearest nearest = walls_.nearest_wall(centre);
    is_inside_.push_back((walls_.is_clear(cell) || nearest.distance > farthest) &&
                         walls_.is_inside(centre, nearest));
  }
  const std::vector<ReflexCorner> corners = corners_of_arcs(plan, tangents);
  for (std::size_t a = 0; a < corners.size(); ++a) {
    const ReflexCorner& corner = corners[a];
    arc_.push_back({corner.position,
                    corner.direction_at(graph_.arc[a].begin),
                    corner.direction_at(graph_.arc[a].end),
                    graph_.arc[a].begin,
                    0,
                    {}});
  }
  if (graph_.radius > 0) {
    const std::vector<double> saved = savings(graph_);
    for (std::uint32_t side = 0; side < saved.size(); ++side)
      arc_[side / 2].saved[side % 2] = static_cast<std::uint16_t>(std::min(
          ArcOfEnds::all_saved, std::ceil(ArcOfEnds::all_saved * saved[side] / graph_.radius) + 1));
  }
  for (const auto* table : {&labels.leaving, &labels.arriving})
    for (const HubCost& hub : table->hub) hubs_ = std::max(hubs_, std::size_t{hub.hub} + 1);

  // The arcs of each corner lie together, in the order of the vertices.
  std::vector<std::uint32_t> first_arc;
  std::uint32_t arc = 0;
  for (std::uint32_t c = 0; c < sight.corner.size(); ++c) {
    while (arc < graph_.arc.size() && graph_.arc[arc].vertex < sight.corner[c]) ++arc;
    first_arc.push_back(arc);
    for (std::uint32_t a = arc; a < graph_.arc.size() && graph_.arc[a].vertex == sight.corner[c];
         ++a)
      arc_[a].corner = c;
  }
  const double reach = sight.cell_size * std::numbers::sqrt2 / 2;
  cell_first_.reserve(sight.cell_first.size());
  cell_first_.push_back(0);
  for (std::size_t cell = 0; cell + 1 < sight.cell_first.size(); ++cell) {
    const std::size_t row = cell / sight.columns, column = cell % sight.columns;
    const Vec2 centre = sight.origin + sight.cell_size * Vec2{static_cast<double>(column) + 0.5,
                                                              static_cast<double>(row) + 0.5};
    for (std::uint32_t i = sight.cell_first[cell]; i < sight.cell_first[cell + 1]; ++i) {
      const std::uint32_t seen = sight.cell_corner[i];
      for (std::uint32_t a = first_arc[seen];
           a < graph_.arc.size() && graph_.arc[a].vertex == sight.corner[seen]; ++a)
        for (const std::uint32_t side : {2 * a, 2 * a + 1})
          if (may_touch(side, centre, reach)) cell_side_.push_back(side);
    }
    cell_first_.push_back(static_cast<std::uint32_t>(cell_side_.size()));
  }
  cell_side_.shrink_to_fit();
}

bool ShortestWayMap::may_touch(std::uint32_t side, Vec2 centre, double reach) const noexcept {
  const double distance = glm::length(centre - arc_[side / 2].centre);
  const double nearest = distance - reach;
  if (nearest <= rolling_) return true;
  const double tangent = std::sqrt(nearest * nearest - rolling_ * rolling_);
  // The tangent's direction turns by one over its length for every metre that its end moves.
  const double slack = reach / tangent + same_angle;
  if (slack > 1) return true;
  const double left = rolling_ * (side % 2 == 0 ? 1 : -1);
  const auto line = tangent_line(centre, 0, arc_[side / 2].centre, left, 2 * walls_.slack());
  if (!line) return true;
  const Vec2 direction = (side % 2 == 0 ? -1.0 : 1.0) * line->left;
  // Is the direction within the slack of the arc? Measured from the arc's middle, so that neither
  // end is taken for the other where a sharp tip's arc spans nearly half a turn. The cosine is flat
  // at 0: it tells angles apart to 1e-6 there, and what is listed too much does no harm.
  constexpr double cosine_slack = 1e-12;
  const TangentArc& arc = graph_.arc[side / 2];
  const double half = (arc.end - arc.begin) / 2;
  const Vec2 begin = arc_[side / 2].begin;
  const Vec2 middle = std::cos(half) * begin + std::sin(half) * left_of(begin);
  return dot(middle, direction) >=
         std::cos(std::min(half + slack, std::numbers::pi)) - cosine_slack;
}

std::span<const std::uint32_t> ShortestWayMap::sides_about(Vec2 point) const noexcept {
  const auto cell = sight_.cell_at(point);
  if (!cell) return {};
  return std::span(cell_side_)
      .subspan(cell_first_[*cell], cell_first_[*cell + 1] - cell_first_[*cell]);
}

double ShortestWayMap::turn_at(std::uint32_t side, Vec2 touch) const noexcept {
  if (graph_.radius == 0) return 0;
  const ArcOfEnds& arc = arc_[side / 2];
  const Vec2 out = touch - arc.centre;
  return side % 2 == 0 ? angle_between(arc.begin, out) : angle_between(out, arc.end);
}

void ShortestWayMap::append_roll(std::uint32_t side, double from, double to,
                                 std::vector<Vec2>& points) const {
  const ArcOfEnds& arc = arc_[side / 2];
  append_arc(arc.centre, arc.begin, graph_.radius, from - arc.begin_angle, to - arc.begin_angle,
             points);
}

Vec2 ShortestWayMap::touch_of(std::uint32_t side, Vec2 point, double length) const noexcept {
  const ArcOfEnds& arc = arc_[side / 2];
  if (graph_.radius == 0) return arc.centre;
  const double sign = side % 2 == 0 ? 1 : -1;
  const Vec2 between = arc.centre - point;
  return arc.centre -
         rolling_ * (rolling_ * between + sign * length * left_of(between)) / dot(between, between);
}

}  // namespace docent::path
