#include "runtime/path/shortest/make_tangent_graph.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "runtime/model/geometry/orientation.h"
#include "runtime/path/shortest/free_arcs.h"

namespace docent::path {
namespace {

/// Finds the tangents between the arcs of one floor.
class Builder {
 public:
  Builder(const FloorPlan& plan, const SightMap& sight, double radius)
      : sight_(sight), walls_(plan, radius), rolling_(rolling_radius(radius, walls_.slack())) {
    graph_.radius = radius;
    std::vector<std::uint32_t> previous(plan.vertex.size());
    for (std::uint32_t i = 0; i < plan.vertex.size(); ++i) previous[plan.next[i]] = i;
    for (const std::uint32_t i : sight.corner) {
      const auto first = static_cast<std::uint32_t>(graph_.arc.size());
      const auto found = reflex_corner(plan, previous[i], i);
      const ReflexCorner corner = found.value_or(ReflexCorner{.vertex = i});
      if (found)
        for (const ArcInterval& free : free_arcs(plan, walls_, corner, previous[i], radius))
          graph_.arc.push_back({i, free.begin, free.end});
      const auto end = static_cast<std::uint32_t>(graph_.arc.size());
      corner_.push_back({corner, end_direction(corner), first, end});
    }
  }

  TangentGraph build() {
    for (std::size_t i = 0; i < corner_.size(); ++i)
      for (const std::uint32_t j : seen_from(i))
        for (const Sense leaving : {Sense::CounterClockwise, Sense::Clockwise})
          for (const Sense arriving : {Sense::CounterClockwise, Sense::Clockwise})
            connect(corner_[i], leaving, corner_[j], arriving);
    sort_by_side();
    return std::move(graph_);
  }

 private:
  struct Corner {
    ReflexCorner corner;
    Vec2 end;  ///< Unit normal of the wall that ends at the corner.
    std::uint32_t first_arc, end_arc;
  };
  struct Found {
    std::uint32_t side;
    Tangent tangent;
  };

  /// The corners after i that it sees, if there is anything to touch at it.
  std::span<const std::uint32_t> seen_from(std::size_t i) const noexcept {
    const auto seen =
        std::span(sight_.pair_other)
            .subspan(sight_.pair_first[i], sight_.pair_first[i + 1] - sight_.pair_first[i]);
    if (corner_[i].first_arc == corner_[i].end_arc) return {};
    return seen.subspan(static_cast<std::size_t>(std::ranges::upper_bound(seen, i) - seen.begin()));
  }
  static Vec2 end_direction(const ReflexCorner& corner) {
    return std::cos(corner.extent) * corner.begin + std::sin(corner.extent) * left_of(corner.begin);
  }
  /// Can the circle be touched in this direction from its corner? Quick, and never wrongly no.
  static bool may_touch(const Corner& corner, Vec2 direction) noexcept {
    return cross(corner.corner.begin, direction) >= -same_angle &&
           cross(direction, corner.end) >= -same_angle;
  }
  std::uint32_t arc_at(const Corner& corner, double angle) const noexcept {
    for (std::uint32_t arc = corner.first_arc; arc < corner.end_arc; ++arc)
      if (angle >= graph_.arc[arc].begin - same_angle && angle <= graph_.arc[arc].end + same_angle)
        return arc;
    return TangentGraph::no_tangent;
  }
  static std::uint32_t side(std::uint32_t arc, Sense sense) noexcept {
    return 2 * arc + (sense == Sense::Clockwise ? 1 : 0);
  }
  static Sense reversed(Sense sense) noexcept {
    return sense == Sense::Clockwise ? Sense::CounterClockwise : Sense::Clockwise;
  }

  void connect(const Corner& from, Sense leaving, const Corner& to, Sense arriving) {
    const auto line =
        tangent_line(from.corner.position, rolling_ * sign_of(leaving), to.corner.position,
                     rolling_ * sign_of(arriving), 2 * walls_.slack());
    if (!line) return;
    // The circle's centre is to the left where the way turns counter-clockwise.
    const Vec2 out = -sign_of(leaving) * line->left, in = -sign_of(arriving) * line->left;
    if (!may_touch(from, out) || !may_touch(to, in)) return;
    const double leave_angle = from.corner.angle_of(out), arrive_angle = to.corner.angle_of(in);
    const std::uint32_t from_arc = arc_at(from, leave_angle), to_arc = arc_at(to, arrive_angle);
    if (from_arc == TangentGraph::no_tangent || to_arc == TangentGraph::no_tangent) return;
    const Vec2 leave = from.corner.position + rolling_ * out;
    const Vec2 arrive = to.corner.position + rolling_ * in;
    if (!walls_.segment_clear(leave, arrive)) return;
    const double length = std::sqrt(dot(arrive - leave, arrive - leave));
    found_.push_back({side(from_arc, leaving),
                      {leave, leave_angle, arrive_angle, length, side(to_arc, arriving), 0}});
    found_.push_back(
        {side(to_arc, reversed(arriving)),
         {arrive, arrive_angle, leave_angle, length, side(from_arc, reversed(leaving)), 0}});
  }

  void sort_by_side() {
    // Along side s the angle grows where s is even (counter-clockwise) and falls where it is odd.
    const auto along = [](std::uint32_t s, double angle) { return s % 2 == 0 ? angle : -angle; };
    std::ranges::sort(found_, [&](const Found& a, const Found& b) {
      if (a.side != b.side) return a.side < b.side;
      const double a_at = along(a.side, a.tangent.leave_angle);
      const double b_at = along(b.side, b.tangent.leave_angle);
      if (a_at != b_at) return a_at < b_at;
      if (a.tangent.arrive_side != b.tangent.arrive_side)
        return a.tangent.arrive_side < b.tangent.arrive_side;
      return a.tangent.length < b.tangent.length;
    });
    graph_.side_first.assign(2 * graph_.arc.size() + 1, 0);
    for (const Found& found : found_) ++graph_.side_first[found.side + 1];
    for (std::size_t s = 1; s < graph_.side_first.size(); ++s)
      graph_.side_first[s] += graph_.side_first[s - 1];
    for (const Found& found : found_) graph_.tangent.push_back(found.tangent);
    for (Tangent& tangent : graph_.tangent) {
      const std::uint32_t s = tangent.arrive_side;
      const auto leaving =
          std::span(graph_.tangent)
              .subspan(graph_.side_first[s], graph_.side_first[s + 1] - graph_.side_first[s]);
      const double arrival = along(s, tangent.arrive_angle) - same_angle;
      const auto onward = std::ranges::lower_bound(
          leaving, arrival, {}, [&](const Tangent& t) { return along(s, t.leave_angle); });
      tangent.onward = onward == leaving.end()
                           ? TangentGraph::no_tangent
                           : static_cast<std::uint32_t>(&*onward - graph_.tangent.data());
    }
  }

  const SightMap& sight_;
  WallGrid walls_;
  double rolling_;  ///< Radius of the circles.
  TangentGraph graph_;
  std::vector<Corner> corner_;  ///< One per corner of the sight map.
  std::vector<Found> found_;
};

}  // namespace

std::optional<ReflexCorner> reflex_corner(const FloorPlan& plan, std::uint32_t before,
                                          std::uint32_t vertex) {
  const Vec2 a = plan.vertex[before], v = plan.vertex[vertex], b = plan.vertex[plan.next[vertex]];
  if (orientation(a, v, b) >= 0) return {};
  const Vec2 in = glm::normalize(v - a), out = glm::normalize(b - v);
  // From the normal of `out` counter-clockwise to that of `in`: the turn, which is to the right.
  const double extent = std::atan2(-cross(in, out), dot(in, out));
  return ReflexCorner{vertex, v, left_of(out), std::max(extent, 0.0)};
}

TangentGraph make_tangent_graph(const FloorPlan& plan, const SightMap& sight, double radius) {
  if (!(radius >= 0) || !std::isfinite(radius)) return {.side_first = {0}};
  return Builder(plan, sight, radius < smallest_radius ? 0 : radius).build();
}

std::vector<ReflexCorner> corners_of_arcs(const FloorPlan& plan, const TangentGraph& graph) {
  std::vector<std::uint32_t> previous(plan.vertex.size());
  for (std::uint32_t i = 0; i < plan.vertex.size(); ++i) previous[plan.next[i]] = i;
  std::vector<ReflexCorner> corners;
  corners.reserve(graph.arc.size());
  for (const TangentArc& arc : graph.arc)
    corners.push_back(reflex_corner(plan, previous[arc.vertex], arc.vertex)
                          .value_or(ReflexCorner{.vertex = arc.vertex}));
  return corners;
}

}  // namespace docent::path
