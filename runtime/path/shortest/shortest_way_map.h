#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "runtime/model/geometry/floor.h"
#include "runtime/path/index/wall_grid.h"
#include "runtime/path/shortest/reflex_corner.h"
#include "runtime/path/shortest/tangent_search.h"

namespace docent::path {

/// A tangent graph with its labels made ready for queries. Immutable, so any thread may ask.
/// Borrows what it is made from.
class ShortestWayMap {
 public:
  ShortestWayMap(const FloorPlan& plan, const SightMap& sight, const TangentGraph& tangents,
                 const HubLabels& labels, const TangentSearchMap& search);

  const TangentGraph& graph() const noexcept { return graph_; }
  const HubLabels& labels() const noexcept { return labels_; }
  const WallGrid& walls() const noexcept { return walls_; }  ///< For the graph's radius.
  const TangentSearchMap& search() const noexcept { return search_; }

  std::size_t hubs() const noexcept { return hubs_; }
  /// The corner of a side in the sight map.
  std::uint32_t sight_corner(std::uint32_t side) const noexcept { return arc_[side / 2].corner; }

  /// Begins to fetch what a query will read of a side: in a new place a query waits mostly for
  /// memory.
  void prefetch_arc(std::uint32_t side) const noexcept { __builtin_prefetch(&arc_[side / 2]); }
  void prefetch_landmarks(std::uint32_t side) const noexcept {
    __builtin_prefetch(&search_.landmarks().of(arc_[side / 2].corner));
  }
  static void prefetch(std::span<const HubCost> label) noexcept {
    for (std::size_t i = 0; i < label.size(); i += 8) __builtin_prefetch(&label[i]);
  }

  std::span<const HubCost> leaving(std::uint32_t side) const noexcept {
    return labels_.leaving.of(side);
  }
  std::span<const HubCost> arriving(std::uint32_t side) const noexcept {
    return labels_.arriving.of(side);
  }

  /// Does the disc certainly have room here? Quick; may be false where there is room.
  bool surely_has_room(Vec2 point) const noexcept {
    const auto cell = walls_.cell_at(point);
    return cell && is_inside_[*cell] &&
           (walls_.is_clear(*cell) ||
            walls_.distance_within(*cell, point) >= least_clearance(graph_.radius));
  }

  /// The sides that a way from this point may touch first, and perhaps some more.
  std::span<const std::uint32_t> sides_about(Vec2 point) const noexcept;

  /// The length of the tangent from a point to a side, metres, if it touches the side's arc; not
  /// tested against walls. Walked backwards it is the tangent from the arc's other side to the
  /// point.
  std::optional<double> length_to(std::uint32_t side, Vec2 point) const noexcept;
  /// What a way saves at an end where it first touches a side (see savings.h). Metres.
  double saved_at(std::uint32_t side) const noexcept {
    return graph_.radius * arc_[side / 2].saved[side % 2] / ArcOfEnds::all_saved;
  }
  /// Where such a tangent of a known length touches.
  Vec2 touch_of(std::uint32_t side, Vec2 point, double length) const noexcept;
  /// How far along its side's arc that is, from where the side is entered. Radians; 0 for radius 0,
  /// where arcs are points.
  double turn_at(std::uint32_t side, Vec2 touch) const noexcept;

  /// How far along a side's arc an angle is, from where the side is entered, and back. Radians.
  double turn_along(std::uint32_t side, double angle) const noexcept {
    const TangentArc& arc = graph_.arc[side / 2];
    return side % 2 == 0 ? angle - arc.begin : arc.end - angle;
  }
  double angle_after(std::uint32_t side, double turn) const noexcept {
    const TangentArc& arc = graph_.arc[side / 2];
    return side % 2 == 0 ? arc.begin + turn : arc.end - turn;
  }

  /// The whole turn of a side's arc.
  double extent(std::uint32_t side) const noexcept {
    return graph_.arc[side / 2].end - graph_.arc[side / 2].begin;
  }

  /// Appends the points of a roll along a side's arc from one angle to another, both included.
  void append_roll(std::uint32_t side, double from, double to, std::vector<Vec2>& points) const;

 private:
  /// What a query's tangents need of an arc, in one cache line.
  struct alignas(64) ArcOfEnds {
    Vec2 centre, begin, end;  ///< `begin` and `end` are unit directions from the centre.
    double begin_angle;
    std::uint32_t corner;  ///< In the sight map.
    /// Of the radius, per side, what its ways save, rounded up.
    static constexpr double all_saved = 65'535;
    std::array<std::uint16_t, 2> saved;
  };
  bool may_touch(std::uint32_t side, Vec2 centre, double reach) const noexcept;

  const TangentGraph& graph_;
  const HubLabels& labels_;
  const SightMap& sight_;
  const TangentSearchMap& search_;
  WallGrid walls_;
  double rolling_;               ///< Radius of the circles on which ways bend.
  std::vector<bool> is_inside_;  ///< One per cell of the walls: certainly all of it.
  std::vector<ArcOfEnds> arc_;   ///< One per arc.
  std::vector<std::uint32_t> cell_first_, cell_side_;
  std::size_t hubs_ = 0;
};

/// Inlined where candidates are listed. Where they touch is found for the few that are looked at:
/// kept for all, it costs more.
[[gnu::always_inline]] inline std::optional<double> ShortestWayMap::length_to(
    std::uint32_t side, Vec2 point) const noexcept {
  const ArcOfEnds& arc = arc_[side / 2];
  const double sign = side % 2 == 0 ? 1 : -1;
  const Vec2 between = arc.centre - point;
  const double squared = dot(between, between);
  if (graph_.radius == 0) {
    // The direction from the corner to where it is touched, not yet of unit length.
    const Vec2 out = -sign * left_of(between);
    const double slack = same_angle * (std::abs(between.x) + std::abs(between.y));
    if (cross(arc.begin, out) < -slack || cross(out, arc.end) < -slack) return {};
    return std::sqrt(squared);
  }
  const double nearest = std::max(0.0, rolling_ - 2 * walls_.slack());
  if (squared < nearest * nearest) return {};
  const double length = std::sqrt(std::max(0.0, squared - rolling_ * rolling_));
  // From the centre to the touch, times the distance squared.
  const Vec2 out = -(rolling_ * between + sign * length * left_of(between));
  const double slack = same_angle * squared;
  if (cross(arc.begin, out) < -slack || cross(out, arc.end) < -slack) return {};
  return length;
}

}  // namespace docent::path
