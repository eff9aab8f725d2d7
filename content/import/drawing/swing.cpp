#include "content/import/drawing/swing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "content/import/drawing/segment_grid.h"
#include "runtime/model/geometry/segment.h"

namespace docent::import {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double reach =
    0.35;  ///< Metres from a leaf's edge to the wall: frames and drawing habits.
constexpr double leaf_thickness = 0.07;

class Walls {
 public:
  explicit Walls(std::span<const WallLine> walls) : walls_(walls) {
    for (std::uint32_t i = 0; i < walls.size(); ++i) grid_.add(i, walls[i].a, walls[i].b);
  }

  /// To the nearest wall that is no leaf of this arc; `reach` where there is none.
  double distance(const DrawnArc& arc, Vec2 p) const {
    double best = reach;
    grid_.near(p, p, reach, [&](std::uint32_t i) {
      const WallLine& wall = walls_[i];
      for (const Vec2 end : {arc.start, arc.end})
        if (draws_the_leaf({arc.centre, {}, end, 0}, wall.a, wall.b)) return;
      best = std::min(best, distance_to_segment(p, wall.a, wall.b));
    });
    return best;
  }

  /// To the nearest wall but this one; `reach` where there is none.
  double distance_but(std::uint32_t leaf, Vec2 p) const {
    double best = reach;
    grid_.near(p, p, reach, [&](std::uint32_t i) {
      if (i != leaf) best = std::min(best, distance_to_segment(p, walls_[i].a, walls_[i].b));
    });
    return best;
  }

  /// Calls `found(index)` for the strokes about a point.
  template <typename Found>
  void each_at(Vec2 p, const Found& found) const {
    grid_.near(p, p, reach, found);
  }

  /// Is there a stroke from the hinge to this end of the arc?
  bool leaf(const DrawnArc& arc, Vec2 end) const {
    bool found = false;
    grid_.near(arc.centre, end, leaf_thickness, [&](std::uint32_t i) {
      const WallLine& wall = walls_[i];
      found = found || (draws_the_leaf({arc.centre, {}, end, 0}, wall.a, wall.b) &&
                        glm::length(wall.b - wall.a) > 0.8 * arc.radius);
    });
    return found;
  }

 private:
  std::span<const WallLine> walls_;
  SegmentGrid grid_{1};
};

constexpr double at_wall = 0.06;       ///< Metres: a hinge and a jamb are on a wall.
constexpr double off_the_wall = 0.04;  ///< Metres: the tip of a leaf that is open is not.

bool is_leaf_long(double length) {
  return length > 0.45 && length < 1.6;
}

/// A leaf whose tip is at `tip`, which shuts at `shut`.
std::optional<Swing> leaf_to(const Walls& near, std::span<const WallLine> walls, Vec2 tip,
                             Vec2 shut) {
  std::optional<Swing> best;
  double nearest = 0.2;  // Of the leaf's length: hands end leaves a little beyond their arcs.
  near.each_at(tip, [&](std::uint32_t i) {
    for (const auto& [hinge, end] :
         {std::pair{walls[i].a, walls[i].b}, std::pair{walls[i].b, walls[i].a}}) {
      const double leaf = glm::length(end - hinge), away = glm::length(end - tip) / leaf;
      if (!is_leaf_long(leaf) || away >= nearest) continue;
      if (std::abs(glm::length(shut - hinge) - leaf) > 0.15 * leaf) continue;
      if (near.distance_but(i, tip) < off_the_wall || near.distance_but(i, hinge) > at_wall ||
          near.distance_but(i, shut) > at_wall)
        continue;
      nearest = away;
      best = Swing{hinge, shut, end, 0};
    }
  });
  return best;
}

}  // namespace

bool could_end_at_a_leaf(const DrawnArc& arc) {
  const double chord = glm::length(arc.end - arc.start);
  return chord > 0.05 && chord < 2.3 && arc.radius < 20 && arc.sweep < 150 * degree;
}

std::vector<Swing> find_swings_by_leaves(const Drawing& drawing,
                                         std::span<const std::uint32_t> arcs,
                                         std::span<const WallLine> walls) {
  const Walls near(walls);
  std::vector<Swing> swings;
  for (const std::uint32_t index : arcs) {
    const DrawnArc& arc = drawing.arcs[index];
    auto swing = leaf_to(near, walls, arc.start, arc.end);
    if (!swing) swing = leaf_to(near, walls, arc.end, arc.start);
    if (!swing) continue;
    swing->arc = index;
    swings.push_back(*swing);
  }
  return swings;
}

bool swings_like_a_door(const DrawnArc& arc) {
  return arc.radius > 0.45 && arc.radius < 1.6 && arc.sweep > 8 * degree &&
         arc.sweep < 120 * degree;
}

bool draws_the_leaf(const Swing& swing, Vec2 a, Vec2 b) {
  const Vec2 leaf = swing.open - swing.hinge;
  const double length = glm::length(leaf);
  const auto beside = [&](Vec2 p) {
    const double along = dot(p - swing.hinge, leaf) / length;
    return along > -0.06 && along < length + 0.06 &&
           std::abs(cross(leaf, p - swing.hinge)) / length < leaf_thickness;
  };
  const double middle = dot(0.5 * (a + b) - swing.hinge, leaf) / length;
  return beside(a) && beside(b) && middle > 0.1 * length;
}

namespace {

/// Of two leaves that meet in the middle of a wide door, the ends where they meet are shut: there
/// both arcs end, as far from one another's hinges as both are long.
class Meeting {
 public:
  Meeting(const Drawing& drawing, std::span<const std::uint32_t> arcs) : drawing_(drawing) {
    for (const std::uint32_t index : arcs)
      for (const Vec2 end : {drawing.arcs[index].start, drawing.arcs[index].end})
        ends_.add(index, end, end);
  }

  bool meets_another(std::uint32_t index, Vec2 end) const {
    const DrawnArc& arc = drawing_.arcs[index];
    bool found = false;
    ends_.near(end, end, touching, [&](std::uint32_t i) {
      const DrawnArc& other = drawing_.arcs[i];
      if (i == index || std::abs(other.radius - arc.radius) > 0.1 * arc.radius) return;
      if (std::min(glm::distance(other.start, end), glm::distance(other.end, end)) > touching)
        return;
      const double hinges = glm::distance(other.centre, arc.centre);
      found = found || std::abs(hinges - arc.radius - other.radius) < 2 * touching;
    });
    return found;
  }

 private:
  static constexpr double touching = 0.06;  ///< Metres.
  const Drawing& drawing_;
  SegmentGrid ends_{1};
};

}  // namespace

std::vector<Swing> find_swings(const Drawing& drawing, std::span<const std::uint32_t> arcs,
                               std::span<const WallLine> walls, std::span<const WallLine> leaves) {
  const Walls near(walls), open(leaves);
  const Meeting meeting(drawing, arcs);
  std::vector<Swing> swings;
  for (const std::uint32_t index : arcs) {
    const DrawnArc& arc = drawing.arcs[index];
    if (!swings_like_a_door(arc) || near.distance(arc, arc.centre) >= reach) continue;
    double start = near.distance(arc, arc.start), end = near.distance(arc, arc.end);
    // Two leaves that meet in the middle of a wide door have no wall at their edges.
    const bool start_leaf = open.leaf(arc, arc.start), end_leaf = open.leaf(arc, arc.end);
    if (start_leaf && !end_leaf) start = reach + 1;
    if (end_leaf && !start_leaf) end = reach + 1;
    if (start_leaf && end_leaf) {  // A wall drawn through the doorway, too: it goes on behind it.
      start = near.distance(arc, arc.start + 0.3 * (arc.start - arc.centre));
      end = near.distance(arc, arc.end + 0.3 * (arc.end - arc.centre));
    }
    if (start == end) {
      if (meeting.meets_another(index, arc.start)) start = 0;
      if (meeting.meets_another(index, arc.end)) end = 0;
    }
    if (start == end) continue;
    // A door drawn ajar: only with its leaf, and a wall where it shuts.
    if (arc.sweep < 50 * degree && (!(start_leaf || end_leaf) || std::min(start, end) > 0.12))
      continue;
    const bool shut_at_start = start < end;
    swings.push_back({arc.centre, shut_at_start ? arc.start : arc.end,
                      shut_at_start ? arc.end : arc.start, index});
  }
  return swings;
}

}  // namespace docent::import
