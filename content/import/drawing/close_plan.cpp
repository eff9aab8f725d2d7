#include "content/import/drawing/close_plan.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "content/import/drawing/drawn_box.h"
#include "content/import/drawing/gap.h"
#include "content/import/drawing/line_kind.h"
#include "content/import/drawing/segment_grid.h"
#include "runtime/model/geometry/polygon.h"
#include "runtime/model/geometry/segment.h"

namespace docent::import {
namespace {

constexpr double snap_reach = 0.35;     ///< From a drawn door's edge to the wall it belongs to.
constexpr double slip_reach = 0.12;     ///< Lines that miss another by less were meant to meet it.
constexpr double overrun_reach = 0.06;  ///< Lines that run past a corner by less were meant to end.
constexpr double usual_gap = 1.25;      ///< Metres: most doors are no wider.
constexpr double widest_seal = 8;       ///< Metres of glass or nothing at a hall's end.

class PlanCloser {
 public:
  PlanCloser(std::vector<WallLine> lines, std::span<const Swing> swings, FoundPlans& found)
      : lines_(std::move(lines)), swings_(swings), found_(found) {}

  std::optional<ClosedPlan> close() {
    drop_leaves();
    shut_swings();
    if (!shut_gaps()) return std::nullopt;
    return std::move(closed_);
  }

 private:
  void drop_leaves() {
    SegmentGrid grid(1);
    for (std::uint32_t s = 0; s < swings_.size(); ++s)
      grid.add(s, swings_[s].hinge, swings_[s].open);
    const auto gone = std::ranges::remove_if(lines_, [&](const WallLine& line) {
      bool leaf = false;
      if (length_of(line) < 1.7)
        grid.near(line.a, line.b, 0.2, [&](std::uint32_t s) {
          leaf = leaf || draws_the_leaf(swings_[s], line.a, line.b);
        });
      if (leaf) ++found_.culled["strokes of door leaves"];
      return leaf;
    });
    lines_.erase(gone.begin(), gone.end());
  }

  /// The nearest corner of a wall, else the nearest place of one, else the point itself.
  Vec2 on_wall(const SegmentGrid& grid, Vec2 p) const {
    double corner = 0.6 * snap_reach, side = snap_reach;
    Vec2 at_corner = p, at_side = p;
    grid.near(p, p, snap_reach, [&](std::uint32_t i) {
      const WallLine& line = lines_[i];
      for (const Vec2 end : {line.a, line.b})
        if (glm::length(end - p) < corner) {
          corner = glm::length(end - p);
          at_corner = end;
        }
      const NearestOnSegment nearest = nearest_on_segment(p, line.a, line.b);
      if (std::sqrt(nearest.distance_squared) < side) {
        side = std::sqrt(nearest.distance_squared);
        at_side = line.a + nearest.t * (line.b - line.a);
      }
    });
    if (side < 0.01) return at_side;
    return at_corner != p && corner < side + 0.12 ? at_corner : at_side;
  }

  void shut_swings() {
    SegmentGrid grid(1);
    for (std::uint32_t i = 0; i < lines_.size(); ++i) grid.add(i, lines_[i].a, lines_[i].b);
    std::vector<bool> done(swings_.size(), false);
    for (std::size_t i = 0; i < swings_.size(); ++i) {
      if (done[i]) continue;
      Vec2 a = swings_[i].hinge, b = swings_[i].shut;
      for (std::size_t j = i + 1; j < swings_.size(); ++j) {
        if (done[j] || glm::length(swings_[j].hinge - swings_[i].hinge) < 0.5) continue;
        const bool two_leaves = glm::length(swings_[j].shut - swings_[i].shut) < 0.35;
        // The ends of two leaves may have been taken for one another.
        if (!two_leaves) continue;
        done[j] = true;
        b = swings_[j].hinge;
        break;
      }
      a = on_wall(grid, a);
      b = on_wall(grid, b);
      if (glm::length(b - a) < 0.3) continue;
      closed_.closings.push_back({a, b, true, true});
    }
  }

  bool shut_gaps() {
    std::vector<WallLine> all = lines_;
    for (const Closing& closing : closed_.closings) all.push_back({closing.a, closing.b, LeafLine});
    std::optional<Arrangement> drawn = arrange(all);
    if (!drawn) return too_many();
    found_.culled["line ends snapped to a neighbour"] += drawn->snapped;
    for (const Gap& slip : find_slips(*drawn, slip_reach)) {
      all.push_back({slip.a, slip.b, Wall});
      ++found_.culled["slips below 12 cm closed"];
    }
    drawn = arrange(all);
    if (!drawn) return too_many();
    found_.culled["lines that run past a corner, trimmed"] += trim_overruns(*drawn, overrun_reach);
    all = lines_of(*drawn);
    // Doors first: where both sides of a pier are shut, it does not look across the corridor.
    for (const double widest : {usual_gap, widest_gap}) {
      for (const Gap& gap : find_gaps(*drawn, widest, std::min(widest, widest_side_gap))) {
        all.push_back({gap.a, gap.b, GapLine});
        closed_.closings.push_back({gap.a, gap.b, false, gap.certain});
      }
      drawn = arrange(all);
      if (!drawn) return too_many();
    }
    if (seal(all, *drawn)) drawn = arrange(all);
    if (!drawn) return too_many();
    closed_.arrangement = std::move(*drawn);
    found_.culled["line pieces that end in nothing"] += remove_loose_pieces(closed_.arrangement);
    closed_.faces = trace_faces(closed_.arrangement);
    return true;
  }

  /// Halls and corridors that end in glass or a wide entrance run out of the house: shuts wide gaps
  /// where both sides are outside still.
  bool seal(std::vector<WallLine>& all, const Arrangement& drawn) {
    Arrangement tidy = drawn;
    remove_loose_pieces(tidy);
    const Faces faces = trace_faces(tidy);
    std::vector<std::vector<Vec2>> enclosed;
    std::vector<DrawnBox> boxes;
    for (const Face& face : faces.face) {
      enclosed.push_back(corners_of(tidy, face.outer));
      DrawnBox box;
      for (const Vec2 p : enclosed.back()) box.add(p);
      boxes.push_back(box);
    }
    const auto outside = [&](Vec2 p) {
      for (std::size_t i = 0; i < enclosed.size(); ++i)
        if (boxes[i].holds(p) && contains(enclosed[i], p)) return false;
      return true;
    };
    bool any = false;
    for (const Gap& gap : find_gaps(drawn, widest_seal, widest_seal)) {
      if (!outside(0.5 * (gap.a + gap.b))) continue;
      all.push_back({gap.a, gap.b, SealLine});
      closed_.closings.push_back({gap.a, gap.b, false, false, true});
      any = true;
    }
    return any;
  }

  bool too_many() {
    found_.refused = "the lines cross one another more than 400,000 times";
    return false;
  }

  std::vector<WallLine> lines_;
  std::span<const Swing> swings_;
  FoundPlans& found_;
  ClosedPlan closed_;
};

}  // namespace

std::optional<ClosedPlan> close_plan(std::vector<WallLine> lines, std::span<const Swing> swings,
                                     FoundPlans& found) {
  return PlanCloser(std::move(lines), swings, found).close();
}

}  // namespace docent::import
