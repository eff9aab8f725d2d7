#include "runtime/path/make_tangent_graph.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "runtime/path/predicates.h"

namespace docent {
namespace {

struct Interval {
  double begin = 0, end = 0;
};

/// Directions, as angles in (-pi, pi], in which the circle of `radius` about `centre` may come to
/// or leave the places nearer than `reach` to the wall a b: where it meets the two circles about
/// the wall's ends and the two lines beside it.
void add_crossings(Vec2 centre, double radius, Vec2 a, Vec2 b, double reach,
                   std::vector<Vec2>& directions) {
  for (const Vec2 end : {a, b}) {
    const Vec2 to = end - centre;
    const double distance = std::sqrt(dot(to, to));
    if (distance == 0 || distance > radius + reach || distance < std::abs(radius - reach)) continue;
    const double along =
        (radius * radius - reach * reach + distance * distance) / (2 * distance * radius);
    const double across = std::sqrt(std::max(0.0, 1 - along * along));
    const Vec2 unit = to / distance;
    for (const double side : {-1.0, 1.0})
      directions.push_back(along * unit + side * across * left_of(unit));
  }
  const Vec2 wall = b - a;
  const double length = std::sqrt(dot(wall, wall));
  if (length == 0) return;
  const Vec2 unit = wall / length;
  const double height = cross(unit, centre - a);  // of the circle's centre above the wall
  for (const double line : {-reach, reach}) {
    const double sine = (line - height) / radius;
    if (std::abs(sine) > 1) continue;
    const double cosine = std::sqrt(1 - sine * sine);
    for (const double side : {-1.0, 1.0})
      directions.push_back(side * cosine * unit + sine * left_of(unit));
  }
}

/// The parts of the corner's circle that keep the radius from every wall, in ascending order.
std::vector<Interval> free_arcs(const FloorPlan& plan, const WallGrid& walls,
                                const ReflexCorner& corner, std::uint32_t before) {
  const double radius = walls.radius();
  if (radius == 0) return {{0, corner.extent}};
  const double reach = radius - touching;
  std::vector<double> cuts{0, corner.extent};
  std::vector<std::uint32_t> near = walls.walls_about(corner.position, radius);
  std::erase(near, corner.vertex);
  std::erase(near, before);
  std::vector<Vec2> directions;
  for (const std::uint32_t wall : near)
    add_crossings(corner.position, radius, wall_start(plan, wall), wall_end(plan, wall), reach,
                  directions);
  for (const Vec2 direction : directions) {
    const double angle = corner.angle_of(direction);
    if (angle > 0 && angle < corner.extent) cuts.push_back(angle);
  }
  std::ranges::sort(cuts);

  std::vector<Interval> free;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const Vec2 middle = corner.point_at((cuts[i] + cuts[i + 1]) / 2, radius);
    const bool blocked = std::ranges::any_of(near, [&](std::uint32_t wall) {
      return nearest_on_segment(middle, wall_start(plan, wall), wall_end(plan, wall))
                 .distance_squared < reach * reach;
    });
    if (blocked) continue;
    if (!free.empty() && free.back().end == cuts[i])
      free.back().end = cuts[i + 1];
    else
      free.push_back({cuts[i], cuts[i + 1]});
  }
  return free;
}

/// Finds the tangents between the arcs of one floor.
class Builder {
 public:
  Builder(const FloorPlan& plan, double radius) : walls_(plan, radius) {
    graph_.radius = radius;
    std::vector<std::uint32_t> previous(plan.vertex.size());
    for (std::uint32_t i = 0; i < plan.vertex.size(); ++i) previous[plan.next[i]] = i;
    for (std::uint32_t i = 0; i < plan.vertex.size(); ++i) {
      const auto corner = reflex_corner(plan, previous[i], i);
      if (!corner) continue;
      const auto first = static_cast<std::uint32_t>(graph_.arc.size());
      for (const Interval& free : free_arcs(plan, walls_, *corner, previous[i]))
        graph_.arc.push_back({i, free.begin, free.end});
      const auto end = static_cast<std::uint32_t>(graph_.arc.size());
      if (end > first) corner_.push_back({*corner, end_direction(*corner), first, end});
    }
  }

  TangentGraph build() {
    for (std::size_t i = 0; i < corner_.size(); ++i)
      for (std::size_t j = i + 1; j < corner_.size(); ++j)
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
    const double radius = graph_.radius;
    const auto line = tangent_line(from.corner.position, radius * sign_of(leaving),
                                   to.corner.position, radius * sign_of(arriving), touching);
    if (!line) return;
    // The circle's centre is to the left where the way turns counter-clockwise.
    const Vec2 out = -sign_of(leaving) * line->left, in = -sign_of(arriving) * line->left;
    if (!may_touch(from, out) || !may_touch(to, in)) return;
    const double leave_angle = from.corner.angle_of(out), arrive_angle = to.corner.angle_of(in);
    const std::uint32_t from_arc = arc_at(from, leave_angle), to_arc = arc_at(to, arrive_angle);
    if (from_arc == TangentGraph::no_tangent || to_arc == TangentGraph::no_tangent) return;
    const Vec2 leave = from.corner.position + radius * out;
    const Vec2 arrive = to.corner.position + radius * in;
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

  WallGrid walls_;
  TangentGraph graph_;
  std::vector<Corner> corner_;
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

TangentGraph make_tangent_graph(const FloorPlan& plan, double radius) {
  if (!(radius >= 0) || !std::isfinite(radius)) return {.side_first = {0}};
  return Builder(plan, radius < smallest_radius ? 0 : radius).build();
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

}  // namespace docent
