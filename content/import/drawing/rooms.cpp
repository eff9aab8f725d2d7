#include "content/import/drawing/rooms.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <set>
#include <span>
#include <utility>

#include "content/import/drawing/arrangement.h"
#include "content/import/drawing/floor_words.h"
#include "content/import/drawing/gap.h"
#include "content/import/drawing/inscribed.h"
#include "content/import/drawing/label.h"
#include "content/import/drawing/segment_grid.h"
#include "content/import/drawing/stairs.h"
#include "content/import/drawing/swing.h"
#include "runtime/model/geometry/polygon.h"
#include "runtime/model/geometry/segment.h"

namespace docent::import {
namespace {

constexpr double apart = 1.5;            ///< Metres: what is farther from all else is another plan.
constexpr double narrowest_room = 0.38;  ///< Half its width: less is a wall's inside or a niche.
constexpr double smallest_room = 0.9;    ///< Square metres.
constexpr double smallest_column = 0.02;
constexpr double largest_furniture = 6;  ///< Square metres.
constexpr double snap_reach = 0.35;      ///< From a drawn door's edge to the wall it belongs to.
constexpr double slip_reach = 0.12;      ///< Lines that miss another by less were meant to meet it.
constexpr double overrun_reach = 0.06;  ///< Lines that run past a corner by less were meant to end.
constexpr double usual_gap = 1.25;      ///< Metres: most doors are no wider.
constexpr double widest_seal = 8;       ///< Metres of glass or nothing at a hall's end.
constexpr std::size_t most_lines = 120'000;
constexpr double widest_plan = 20'000;  ///< Metres across.

/// What an edge of the arrangement is; less wins where two lie on one another.
enum LineKind : std::uint32_t { Wall = 0, Window = 1, LeafLine = 2, GapLine = 3, SealLine = 4 };

struct Box {
  Vec2 low{std::numeric_limits<double>::max()}, high{std::numeric_limits<double>::lowest()};
  void add(Vec2 p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  bool meets(const Box& other) const {
    return other.low.x <= high.x && other.low.y <= high.y && other.high.x >= low.x &&
           other.high.y >= low.y;
  }
  bool holds(Vec2 p) const {
    return p.x >= low.x && p.y >= low.y && p.x <= high.x && p.y <= high.y;
  }
};

double length_of(const WallLine& line) {
  return glm::length(line.b - line.a);
}

/// The lines that could be walls and the arcs that could be doors, before any geometry.
struct Chosen {
  std::vector<WallLine> lines;
  std::vector<WallLine> stairs;         ///< On layers of stairs.
  std::vector<WallLine> leaves;         ///< Strokes on layers of doors; more may be among `lines`.
  std::vector<std::uint32_t> arcs;      ///< Those that swing like a door about a hinge.
  std::vector<std::uint32_t> any_arcs;  ///< These and those that might, whatever their centre.
  /// Strokes of the latter: walls where no leaf is found.
  std::vector<std::pair<std::uint32_t, WallLine>> strokes_of_arcs;
};

/// A place to the tenth of a millimetre.
std::pair<std::int64_t, std::int64_t> key_of(Vec2 p) {
  return {std::llround(p.x * 1e4), std::llround(p.y * 1e4)};
}

/// Strokes that are drawn again say nothing new.
class Seen {
 public:
  bool again(Vec2 a, Vec2 b) {
    const auto [low, high] = std::minmax({key_of(a), key_of(b)});
    return !seen_.emplace(low, high).second;
  }

 private:
  using Key = std::pair<std::int64_t, std::int64_t>;
  std::set<std::pair<Key, Key>> seen_;
};

class Chooser {
 public:
  Chooser(const Drawing& drawing, const std::vector<LayerKind>& kinds, FoundPlans& found)
      : drawing_(drawing), kinds_(kinds), found_(found) {
    double walls = 0, dashed = 0, all = 0;
    for (const DrawnSegment& segment : drawing.segments) {
      const double length = glm::length(segment.b - segment.a);
      if (kinds[segment.layer] == LayerKind::Wall) walls += length;
      if (kinds[segment.layer] == LayerKind::Other) continue;
      all += length;
      if (segment.dashed) dashed += length;
    }
    walls_are_named_ = walls > 10;
    all_are_dashed_ = dashed > 0.6 * all;
  }

  Chosen choose() {
    Chosen chosen;
    Seen arcs, strokes;
    for (std::uint32_t i = 0; i < drawing_.arcs.size(); ++i) {
      const DrawnArc& arc = drawing_.arcs[i];
      if (kinds_[arc.layer] == LayerKind::Other) continue;
      if (arcs.again(arc.start + arc.centre, arc.end + arc.centre)) continue;
      if (swings_like_a_door(arc)) chosen.arcs.push_back(i);
      if (swings_like_a_door(arc) || could_end_at_a_leaf(arc)) chosen.any_arcs.push_back(i);
    }
    for (const DrawnSegment& segment : drawing_.segments) {
      if (kinds_[segment.layer] == LayerKind::Stairs)
        chosen.stairs.push_back({segment.a, segment.b, Wall});
      if (kinds_[segment.layer] == LayerKind::Door && !segment.of_curve)
        chosen.leaves.push_back({segment.a, segment.b, Wall});
      if (segment.dashed && !all_are_dashed_ && kinds_[segment.layer] != LayerKind::Wall) {
        ++found_.culled["dashed strokes: axes, and what is overhead"];
        continue;
      }
      if (!could_be_wall(segment)) {
        ++found_.culled["strokes on layers that draw no walls"];
        continue;
      }
      if (segment.arc != no_arc && swings_like_a_door(drawing_.arcs[segment.arc])) {
        ++found_.culled["strokes of door swings"];
        continue;
      }
      if (strokes.again(segment.a, segment.b)) {
        ++found_.culled["strokes drawn again"];
        continue;
      }
      const bool window = kinds_[segment.layer] == LayerKind::Window;
      const WallLine line{segment.a, segment.b, window ? Window : Wall};
      if (segment.arc != no_arc && could_end_at_a_leaf(drawing_.arcs[segment.arc]))
        chosen.strokes_of_arcs.emplace_back(segment.arc, line);
      else
        chosen.lines.push_back(line);
    }
    return chosen;
  }

 private:
  bool could_be_wall(const DrawnSegment& segment) const {
    switch (kinds_[segment.layer]) {
      case LayerKind::Wall:
      case LayerKind::Window:
        return true;
      case LayerKind::Door:  // Leaves and frames are no walls; gaps are shut without them.
        return false;
      case LayerKind::Unknown:
        return !walls_are_named_ && !(segment.of_block && segment.of_curve);
      case LayerKind::Room:
        return !walls_are_named_;
      case LayerKind::Stairs:
      case LayerKind::Other:
        break;
    }
    return false;
  }

  const Drawing& drawing_;
  const std::vector<LayerKind>& kinds_;
  FoundPlans& found_;
  bool walls_are_named_ = false, all_are_dashed_ = false;
};

/// Parts lines into those that lie together; the members of each, largest box first.
std::vector<std::vector<std::uint32_t>> parts_that_lie_together(std::span<const WallLine> lines) {
  std::vector<std::uint32_t> parent(lines.size());
  std::iota(parent.begin(), parent.end(), 0U);
  const auto root = [&](std::uint32_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  double length = 0;
  for (const WallLine& line : lines) length += length_of(line);
  SegmentGrid grid(std::max(apart, length / 1e6));
  // Whoever comes to a cell joins the last one there: the chain holds all.
  std::vector<std::uint32_t> seen(lines.size(), no_face);
  for (std::uint32_t i = 0; i < lines.size(); ++i) {
    grid.near(lines[i].a, lines[i].b, apart / 2, [&](std::uint32_t j) {
      if (seen[j] == i) return;
      seen[j] = i;
      if (root(i) != root(j) &&
          segment_distance_squared(lines[i].a, lines[i].b, lines[j].a, lines[j].b) < apart * apart)
        parent[root(i)] = root(j);
    });
    grid.add(i, lines[i].a, lines[i].b);
  }
  std::map<std::uint32_t, std::vector<std::uint32_t>> parts;
  for (std::uint32_t i = 0; i < lines.size(); ++i) parts[root(i)].push_back(i);

  struct Part {
    Box box;
    std::vector<std::uint32_t> members;
    double size() const { return (box.high.x - box.low.x) * (box.high.y - box.low.y); }
  };
  std::vector<Part> sorted;
  for (auto& [key, members] : parts) {
    Part part;
    for (const std::uint32_t i : members) {
      part.box.add(lines[i].a);
      part.box.add(lines[i].b);
    }
    part.members = std::move(members);
    sorted.push_back(std::move(part));
  }
  std::ranges::stable_sort(sorted, std::greater{}, &Part::size);
  std::vector<Part> whole;  // What stands free in a hall belongs to the hall.
  for (Part& part : sorted) {
    const auto around =
        std::ranges::find_if(whole, [&](const Part& other) { return other.box.meets(part.box); });
    if (around == whole.end()) {
      whole.push_back(std::move(part));
      continue;
    }
    around->members.insert(around->members.end(), part.members.begin(), part.members.end());
    around->box.add(part.box.low);
    around->box.add(part.box.high);
  }
  std::vector<std::vector<std::uint32_t>> out;
  for (Part& part : whole) out.push_back(std::move(part.members));
  return out;
}

/// A line that shuts an opening, and what was seen there.
struct Closing {
  Vec2 a{}, b{};
  bool swing = false, certain = false;
  bool seal = false;  ///< Wider than a door: keeps a room from running out of the house.
};

/// Rooms that are called stairs or lift, unless such are known in them.
void add_named_stairs(FoundPlan& plan) {
  for (const FoundRoom& room : plan.rooms) {
    const std::string kind = connection_of_room(room.name);
    if (kind.empty()) continue;
    const bool known = std::ranges::any_of(plan.stairs, [&](const FoundStairs& other) {
      return other.kind == kind && inside(room.rings, other.middle);
    });
    if (!known) plan.stairs.push_back({kind, room.name, room.middle, 0});
  }
}

/// Finds the rooms of lines that lie together.
class PlanFinder {
 public:
  PlanFinder(const Drawing& drawing, std::vector<WallLine> lines, std::span<const Swing> swings,
             std::span<const Flight> flights, FoundPlans& found)
      : drawing_(drawing), lines_(std::move(lines)), flights_(flights), found_(found) {
    for (const WallLine& line : lines_) {
      box_.add(line.a);
      box_.add(line.b);
    }
    plan_.low = box_.low;
    plan_.high = box_.high;
    for (const Swing& swing : swings)
      if (box_.holds(swing.hinge)) swings_.push_back(swing);
  }

  std::size_t swings() const { return swings_.size(); }

  FoundPlan find() {
    drop_leaves();
    shut_swings();
    if (!shut_gaps()) return std::move(plan_);
    find_faces();
    find_doors();
    find_thresholds();
    name_rooms();
    drop_furniture();
    drop_shafts();
    find_stairs();
    return std::move(plan_);
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
      closings_.push_back({a, b, true, true});
    }
  }

  bool shut_gaps() {
    std::vector<WallLine> all = lines_;
    for (const Closing& closing : closings_) all.push_back({closing.a, closing.b, LeafLine});
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
        closings_.push_back({gap.a, gap.b, false, gap.certain});
      }
      drawn = arrange(all);
      if (!drawn) return too_many();
    }
    if (seal(all, *drawn)) drawn = arrange(all);
    if (!drawn) return too_many();
    arrangement_ = std::move(*drawn);
    found_.culled["line pieces that end in nothing"] += remove_loose_pieces(arrangement_);
    faces_ = trace_faces(arrangement_);
    return true;
  }

  /// Halls and corridors that end in glass or a wide entrance run out of the house: shuts wide gaps
  /// where both sides are outside still.
  bool seal(std::vector<WallLine>& all, const Arrangement& drawn) {
    Arrangement tidy = drawn;
    remove_loose_pieces(tidy);
    const Faces faces = trace_faces(tidy);
    std::vector<std::vector<Vec2>> enclosed;
    std::vector<Box> boxes;
    for (const Face& face : faces.face) {
      enclosed.push_back(corners_of(tidy, face.outer));
      Box box;
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
      closings_.push_back({gap.a, gap.b, false, false, true});
      any = true;
    }
    return any;
  }

  bool too_many() {
    found_.refused = "the lines cross one another more than 400,000 times";
    return false;
  }

  std::vector<std::vector<Vec2>> rings_of(const Face& face) const {
    std::vector<std::vector<Vec2>> rings{corners_of(arrangement_, face.outer)};
    for (const std::vector<std::uint32_t>& hole : face.holes) {
      std::vector<Vec2> ring = corners_of(arrangement_, hole);
      if (std::abs(signed_area(ring)) > smallest_column) rings.push_back(std::move(ring));
    }
    return rings;
  }

  void find_faces() {
    double all = 0;
    for (const Face& face : faces_.face) all += std::max(0.0, face.area);
    for (const Face& face : faces_.face) {
      if (face.area < smallest_room) {
        keep_column(face);
        continue;
      }
      FoundRoom room;
      room.rings = rings_of(face);
      room.area = std::abs(signed_area(room.rings.front()));
      double held = 0;
      for (std::size_t i = 1; i < room.rings.size(); ++i)
        held += std::abs(signed_area(room.rings[i]));
      const double outer = room.area;
      room.area -= held;
      const InscribedCircle circle = inscribed_circle(room.rings);
      room.middle = circle.centre;
      if (is_inside_of_wall(room, circle.radius) || is_doorway(face, room, circle.radius)) {
        ++found_.culled["insides of walls and niches"];
        continue;
      }
      sealed_.push_back(is_sealed(face));
      room_face_.push_back(static_cast<std::uint32_t>(&face - faces_.face.data()));
      frames_.push_back(held > 0.5 * outer && held > 0.5 * all);
      plan_.rooms.push_back(std::move(room));
    }
  }

  bool is_sealed(const Face& face) const {
    return std::ranges::any_of(face.outer, [&](std::uint32_t half) {
      return arrangement_.edge[half / 2].kind == SealLine;
    });
  }

  /// In a thick wall, both sides of a doorway are shut: what lies between is no room.
  bool is_doorway(const Face& face, const FoundRoom& room, double radius) const {
    if (2 * radius > thickest_wall || room.area > 3) return false;
    const auto shut = std::ranges::count_if(face.outer, [&](std::uint32_t half) {
      return arrangement_.edge[half / 2].kind >= first_closing_kind;
    });
    return shut >= 2 && room.rings.front().size() <= 6;
  }

  /// Thin, or long and not wide.
  static bool is_inside_of_wall(const FoundRoom& room, double radius) {
    if (radius < narrowest_room) return true;
    double around = 0;
    for (const std::vector<Vec2>& ring : room.rings)
      for (std::size_t i = 0; i < ring.size(); ++i)
        around += glm::length(ring[(i + 1) % ring.size()] - ring[i]);
    return 2 * room.area < 0.75 * around && room.area > 20 * radius * radius;
  }

  void keep_column(const Face& face) {
    ++found_.culled["faces smaller than a room"];
    if (face.area < smallest_column) return;
    const std::vector<Vec2> ring = corners_of(arrangement_, face.outer);
    const bool free = std::ranges::all_of(face.outer, [&](std::uint32_t half) {
      if (arrangement_.edge[half / 2].kind >= first_closing_kind) return false;  // A doorway.
      const std::uint32_t other = faces_.face_of[half ^ 1U];
      return other != no_face && faces_.face[other].area > 4;
    });
    if (free) plan_.columns.push_back(ring);
  }

  /// The room that one meets first from the door's middle.
  std::optional<std::size_t> room_beside(Vec2 middle, Vec2 step) const {
    for (int i = 1; i <= 9; ++i) {
      const Vec2 p = middle + static_cast<double>(i) * 0.1 * step;
      for (std::size_t r = 0; r < plan_.rooms.size(); ++r)
        if (boxes_[r].holds(p) && inside(plan_.rooms[r].rings, p)) return r;
    }
    return std::nullopt;
  }

  bool in_a_room(Vec2 p) const {
    for (std::size_t r = 0; r < plan_.rooms.size(); ++r)
      if (boxes_[r].holds(p) && inside(plan_.rooms[r].rings, p)) return true;
    return false;
  }

  /// Both faces of a wall have a gap, and a swing may be drawn in it: one door.
  bool is_of_a_door(const Closing& closing) {
    const Vec2 middle = 0.5 * (closing.a + closing.b), along = closing.b - closing.a;
    for (FoundDoor& door : plan_.doors) {
      const Vec2 own = door.b - door.a, apart_by = middle - 0.5 * (door.a + door.b);
      const double length = glm::length(own);
      const double parallel = std::abs(cross(own, along)) / (length * glm::length(along));
      if (parallel > 0.3 || std::abs(cross(own, apart_by)) > (thickest_wall + 0.15) * length ||
          std::abs(dot(own, apart_by)) > 0.45 * length * length)
        continue;
      if (glm::length(apart_by) > 0.3 && in_a_room(middle - 0.5 * apart_by)) continue;
      door.certain = door.certain || closing.certain;
      return true;
    }
    return false;
  }

  void find_doors() {
    for (const FoundRoom& room : plan_.rooms) {
      Box box;
      for (const Vec2 p : room.rings.front()) box.add(p);
      boxes_.push_back(box);
    }
    for (const Closing& closing : closings_) {
      if (is_of_a_door(closing)) continue;
      const Vec2 middle = 0.5 * (closing.a + closing.b);
      const Vec2 across = glm::normalize(left_of(closing.b - closing.a));
      const auto left = room_beside(middle, across), right = room_beside(middle, -across);
      if (left == right) {
        ++found_.culled[left ? "openings inside one room" : "openings beside no room"];
        continue;
      }
      const bool to_outside = !left || !right;
      if (to_outside && !closing.swing) {
        ++found_.culled["gaps to the outside, taken for windows"];
        continue;
      }
      if (closing.seal) {
        plan_.doors.push_back({closing.a, closing.b, false, false, true, 2U});
        continue;
      }
      for (const auto& side : {left, right})
        if (side) ++plan_.rooms[*side].doors;
      plan_.doors.push_back(
          {closing.a, closing.b, closing.swing, closing.certain, false, to_outside ? 1U : 2U});
    }
  }

  /// A face inside a wall that could be a doorway: as long as doors are wide, a room along each
  /// side, and more of the wall at both ends.
  struct Doorway {
    Vec2 a{}, b{};
    std::size_t left = 0, right = 0;      ///< Rooms.
    std::vector<std::uint32_t> beyond{};  ///< Faces at its ends.
  };

  std::optional<Doorway> doorway_of(const Face& face,
                                    const std::vector<std::uint32_t>& room_of) const {
    if (!face.holes.empty()) return std::nullopt;
    std::optional<std::size_t> rooms[2];
    Vec2 ends[2];
    double depth[2] = {0, 0};
    Doorway door;
    std::size_t ended = 0;
    for (const std::uint32_t half : face.outer) {
      const std::uint32_t other = faces_.face_of[half ^ 1U];
      if (other == no_face) return std::nullopt;
      const Vec2 a = arrangement_.vertex[arrangement_.origin(half)];
      const Vec2 b = arrangement_.vertex[arrangement_.head(half)];
      if (room_of[other] != no_face) {
        const std::size_t room = room_of[other];
        if (!rooms[0] || *rooms[0] == room)
          rooms[0] = room;
        else if (!rooms[1] || *rooms[1] == room)
          rooms[1] = room;
        else
          return std::nullopt;
        continue;
      }
      door.beyond.push_back(other);
      if (ended == 2) return std::nullopt;
      ends[ended] = 0.5 * (a + b);
      depth[ended++] = glm::distance(a, b);
    }
    if (ended != 2 || !rooms[0] || !rooms[1]) return std::nullopt;
    const double width = glm::distance(ends[0], ends[1]);
    if (width < narrowest_gap || width > widest_side_gap ||
        std::max(depth[0], depth[1]) > thickest_wall ||
        std::abs(face.area - 0.5 * width * (depth[0] + depth[1])) > 0.1 * face.area)
      return std::nullopt;
    door.a = ends[0];
    door.b = ends[1];
    door.left = *rooms[0];
    door.right = *rooms[1];
    return door;
  }

  /// Doorways that are shut by lines from jamb to jamb: what is no doorway for certain, since walls
  /// meet there or it is too long, is wall; beside a wall is a doorway, and beside that a wall.
  /// Only for rooms into which nothing else leads.
  void find_thresholds() {
    const bool shut =
        std::ranges::any_of(plan_.rooms, [](const FoundRoom& room) { return room.doors == 0; });
    if (!shut) return;
    std::vector<std::uint32_t> room_of(faces_.face.size(), no_face);
    for (std::uint32_t r = 0; r < room_face_.size(); ++r) room_of[room_face_[r]] = r;
    std::map<std::uint32_t, Doorway> doorways;
    for (std::uint32_t f = 0; f < faces_.face.size(); ++f)
      if (room_of[f] == no_face)
        if (auto door = doorway_of(faces_.face[f], room_of)) doorways.emplace(f, std::move(*door));
    enum class Is : std::uint8_t { Unknown, Wall, Door };
    std::map<std::uint32_t, Is> is;
    std::vector<std::uint32_t> next;
    for (const auto& [f, door] : doorways)
      for (const std::uint32_t beyond : door.beyond)
        if (!doorways.contains(beyond) && is.emplace(beyond, Is::Wall).second)
          next.push_back(beyond);
    std::map<std::uint32_t, std::vector<std::uint32_t>> beside;
    for (const auto& [f, door] : doorways)
      for (const std::uint32_t beyond : door.beyond) beside[beyond].push_back(f);
    while (!next.empty()) {
      const std::uint32_t f = next.back();
      next.pop_back();
      for (const std::uint32_t other : beside[f])
        if (is.emplace(other, is[f] == Is::Wall ? Is::Door : Is::Wall).second)
          next.push_back(other);
    }
    for (const auto& [f, door] : doorways) {
      if (is[f] != Is::Door) continue;
      if (plan_.rooms[door.left].doors > 0 && plan_.rooms[door.right].doors > 0) continue;
      plan_.doors.push_back({door.a, door.b, false, false, false, 2U});
      shut_doorways_.emplace_back(door.left, door.right);
    }
    for (const auto& [left, right] : shut_doorways_) {
      ++plan_.rooms[left].doors;
      ++plan_.rooms[right].doors;
    }
  }

  void name_rooms() {
    std::vector<std::vector<DrawnText>> in(plan_.rooms.size());
    for (const DrawnText& text : drawing_.texts)
      if (const auto r = room_of(text.at)) in[*r].push_back(text);
    for (std::size_t r = 0; r < in.size(); ++r) {
      RoomLabel label = label_of(std::move(in[r]));
      plan_.rooms[r].name = std::move(label.name);
      plan_.rooms[r].stated_area = label.area;
    }
  }

  /// The room at a place; where a column or a chair is drawn, the smallest room about it.
  std::optional<std::size_t> room_of(Vec2 p) const {
    std::optional<std::size_t> about;
    for (std::size_t r = 0; r < plan_.rooms.size(); ++r) {
      if (!boxes_[r].holds(p)) continue;
      if (inside(plan_.rooms[r].rings, p)) return r;
      if (contains(plan_.rooms[r].rings.front(), p) &&
          (!about || plan_.rooms[r].area < plan_.rooms[*about].area))
        about = r;
    }
    return about;
  }

  /// What stands free in a room, has no door and is called nothing, is furniture: an obstacle, and
  /// the floor under it is the room's.
  void drop_furniture() {
    std::vector<bool> is_furniture(plan_.rooms.size(), false);
    for (FoundRoom& room : plan_.rooms)
      std::erase_if(room.rings, [&](const std::vector<Vec2>& ring) {
        if (&ring == &room.rings.front()) return false;
        const double area = std::abs(signed_area(ring));
        if (area > largest_furniture || area > 0.5 * room.area) return false;
        std::vector<std::size_t> within;
        for (std::size_t r = 0; r < plan_.rooms.size(); ++r)
          if (contains(ring, plan_.rooms[r].middle)) within.push_back(r);
        const bool is_room = std::ranges::any_of(within, [&](std::size_t r) {
          const FoundRoom& other = plan_.rooms[r];
          return other.doors > 0 ||
                 (!other.name.empty() && (!room.name.empty() || is_known(other)));
        });
        if (is_room || (within.empty() && area < smallest_room)) return false;
        for (const std::size_t r : within) {  // A room's name may stand on its table.
          is_furniture[r] = true;
          if (room.name.empty()) room.name = std::move(plan_.rooms[r].name);
        }
        room.area += area;
        std::erase_if(plan_.columns, [&](const std::vector<Vec2>& column) {
          return contains(ring, middle_of_corners(column));
        });
        plan_.columns.push_back(ring);
        if (!within.empty()) ++found_.culled["closed outlines that stand free: furniture"];
        return true;
      });
    erase_rooms(is_furniture);
  }

  static Vec2 middle_of_corners(const std::vector<Vec2>& ring) {
    Vec2 sum{};
    for (const Vec2 p : ring) sum += p;
    return sum / static_cast<double>(ring.size());
  }

  /// Lifts and stairs stand free, too.
  static bool is_known(const FoundRoom& room) {
    return !connection_of_room(room.name).empty() || !place_of_room(room.name).empty();
  }

  void erase_rooms(const std::vector<bool>& gone) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < plan_.rooms.size(); ++i) {
      if (gone[i]) continue;
      if (kept != i) plan_.rooms[kept] = std::move(plan_.rooms[i]);
      sealed_[kept] = sealed_[i];
      frames_[kept] = frames_[i];
      ++kept;
    }
    plan_.rooms.resize(kept);
  }

  void drop_shafts() {
    std::size_t index = 0;
    const auto gone = std::ranges::remove_if(plan_.rooms, [&](const FoundRoom& room) {
      if (frames_[index++] && room.doors == 0) {
        ++found_.culled["frames around the plan"];
        return true;
      }
      if (sealed_[index - 1] && room.doors < 3 && (room.name.empty() || room.doors == 0)) {
        ++found_.culled["corners of the outside"];
        return true;
      }
      const bool shaft = room.doors == 0 && room.name.empty() && room.area < 2;
      if (shaft) ++found_.culled["shafts without door and name"];
      return shaft;
    });
    plan_.rooms.erase(gone.begin(), gone.end());
  }

  /// Flights side by side or one after another are one pair of stairs.
  void find_stairs() {
    for (const Flight& flight : flights_) {
      const Vec2 middle = flight.middle();
      if (!box_.holds(middle)) continue;
      const bool known = std::ranges::any_of(plan_.stairs, [&](const FoundStairs& other) {
        return glm::length(other.middle - middle) < 2 * std::max(flight.width, 1.5);
      });
      if (known) continue;
      FoundStairs stairs{.middle = middle, .width = flight.width};
      for (const FoundRoom& room : plan_.rooms)
        if (inside(room.rings, middle)) stairs.name = room.name;
      plan_.stairs.push_back(std::move(stairs));
    }
    add_named_stairs(plan_);
  }

  const Drawing& drawing_;
  std::vector<WallLine> lines_;
  std::span<const Flight> flights_;
  std::vector<Swing> swings_;
  FoundPlans& found_;
  FoundPlan plan_;
  Box box_;
  std::vector<Closing> closings_;
  Arrangement arrangement_;
  Faces faces_;
  std::vector<Box> boxes_;
  std::vector<bool> sealed_;  ///< Of each room: was it shut by a line wider than a door?
  std::vector<std::uint32_t> room_face_;  ///< Of each room before any is dropped: its face.
  std::vector<std::pair<std::size_t, std::size_t>> shut_doorways_;  ///< The rooms of each.
  std::vector<bool> frames_;  ///< Of each room: does it lie around most of the plan?
};

/// A layer of closed outlines with a text in most, or called so: its outlines are the rooms.
std::optional<std::uint32_t> layer_of_outlines(const Drawing& drawing,
                                               const std::vector<LayerKind>& kinds) {
  std::vector<std::size_t> large(drawing.layers.size(), 0), labelled(large), all(large);
  for (const DrawnRing& ring : drawing.rings) {
    ++all[ring.layer];
    const double area = std::abs(signed_area(ring.corners));
    if (area < 1.5 || area > 50'000 || inscribed_circle({{ring.corners}}).radius < narrowest_room)
      continue;
    ++large[ring.layer];
    labelled[ring.layer] += std::ranges::any_of(
        drawing.texts, [&](const DrawnText& text) { return contains(ring.corners, text.at); });
  }
  std::optional<std::uint32_t> best;
  for (std::uint32_t layer = 0; layer < large.size(); ++layer) {
    if (kinds[layer] == LayerKind::Other || kinds[layer] == LayerKind::Door) continue;
    const bool called_so = kinds[layer] == LayerKind::Room && large[layer] >= 2;
    const bool speaks = large[layer] >= 4 && 10 * labelled[layer] >= 6 * large[layer];
    if ((called_so || speaks) && 10 * large[layer] >= 6 * all[layer] &&
        (!best || labelled[layer] > labelled[*best]))
      best = layer;
  }
  return best;
}

/// Takes the outlines of a layer as they are.
FoundPlan rooms_of_outlines(const Drawing& drawing, std::uint32_t layer, FoundPlans& found) {
  FoundPlan plan;
  Box all;
  for (const DrawnRing& ring : drawing.rings) {
    if (ring.layer != layer) continue;
    const double area = std::abs(signed_area(ring.corners));
    const InscribedCircle circle = inscribed_circle({{ring.corners}});
    if (area < smallest_room || circle.radius < 0.25) {
      ++found.culled["outlines smaller than a room"];
      continue;
    }
    std::vector<DrawnText> texts;
    for (const DrawnText& text : drawing.texts)
      if (contains(ring.corners, text.at)) texts.push_back(text);
    RoomLabel label = label_of(std::move(texts));
    for (const Vec2 p : ring.corners) all.add(p);
    plan.rooms.push_back(
        {{ring.corners}, area, std::move(label.name), label.area, 0, ring.line, circle.centre});
  }
  plan.low = all.low;
  plan.high = all.high;
  add_named_stairs(plan);
  return plan;
}

/// Axes of a building's grid cross it and stand out on both sides: no wall does.
class Axes {
 public:
  explicit Axes(std::span<const WallLine> lines) : lines_(lines) {
    for (std::uint32_t i = 0; i < lines.size(); ++i) grid_.add(i, lines[i].a, lines[i].b);
  }

  bool is_axis(const WallLine& line) const {
    const double length = length_of(line);
    if (length < shortest_axis) return false;
    const Vec2 along = (line.b - line.a) / length;
    double first = length, last = 0;
    std::set<std::int64_t> crossed;  // Each wall once, whatever it is made of.
    grid_.near(line.a, line.b, 0.02, [&](std::uint32_t i) {
      const Vec2 a = lines_[i].a - line.a, b = lines_[i].b - line.a;
      const Vec2 run = lines_[i].b - lines_[i].a;
      const double across_a = cross(along, a), across_b = cross(along, b);
      if (glm::length(run) < 0.3 || std::abs(cross(along, run)) < 0.3 * glm::length(run)) return;
      if (std::max(across_a, across_b) < -0.02 || std::min(across_a, across_b) > 0.02) return;
      const double share = across_a / (across_a - across_b);
      const double at = dot(a + std::clamp(share, 0.0, 1.0) * (b - a), along);
      if (at < -0.02 || at > length + 0.02) return;
      first = std::min(first, at);
      last = std::max(last, at);
      crossed.insert(std::llround(at / 0.05));
    });
    return crossed.size() >= 4 && first > least_tail && length - last > least_tail;
  }

 private:
  static constexpr double shortest_axis = 4, least_tail = 0.8;  ///< Metres.
  std::span<const WallLine> lines_;
  SegmentGrid grid_{1};
};

/// Axes with the bubbles at their ends, which have the axes' names.
void drop_axes(std::vector<WallLine>& lines, FoundPlans& found) {
  const Axes axes(lines);
  std::vector<WallLine> walls;
  for (const WallLine& line : lines)
    if (!axes.is_axis(line)) walls.push_back(line);
  if (walls.size() < lines.size())
    found.culled["axes: lines that cross the plan and stand out of it"] +=
        lines.size() - walls.size();
  lines = std::move(walls);
}

/// Lines that lie twenty times farther out than nine tenths of all are strays.
void drop_strays(std::vector<WallLine>& lines, FoundPlans& found) {
  if (lines.size() < 20) return;
  const auto range = [&](auto coordinate) {
    std::vector<double> values;
    for (const WallLine& line : lines) {
      values.push_back(coordinate(line.a));
      values.push_back(coordinate(line.b));
    }
    std::ranges::sort(values);
    const double low = values[values.size() / 10], high = values[values.size() * 9 / 10];
    const double margin = 5 * (high - low) + 10;
    return std::pair{low - margin, high + margin};
  };
  const auto [left, right] = range([](Vec2 p) { return p.x; });
  const auto [low, high] = range([](Vec2 p) { return p.y; });
  const auto gone = std::ranges::remove_if(lines, [&](const WallLine& line) {
    const auto out = [&](Vec2 p) { return p.x < left || p.x > right || p.y < low || p.y > high; };
    return out(line.a) || out(line.b);
  });
  if (!gone.empty()) found.culled["strokes far away from the plan"] += gone.size();
  lines.erase(gone.begin(), gone.end());
}

/// The flights of stairs; their treads are no walls.
std::vector<Flight> take_flights(Chosen& chosen, FoundPlans& found) {
  std::vector<Flight> flights = find_flights(chosen.lines);
  std::vector<bool> is_tread(chosen.lines.size(), false);
  for (const Flight& flight : flights)
    for (const std::uint32_t tread : flight.treads) is_tread[tread] = true;
  std::vector<WallLine> others;
  for (std::size_t i = 0; i < chosen.lines.size(); ++i)
    if (!is_tread[i]) others.push_back(chosen.lines[i]);
  found.culled["treads of stairs"] = chosen.lines.size() - others.size();
  chosen.lines = std::move(others);
  std::ranges::move(find_flights(chosen.stairs), std::back_inserter(flights));
  return flights;
}

/// The doors among the arcs; the strokes of arcs that are none become walls.
std::vector<Swing> swings_of(const Drawing& drawing, Chosen& chosen, FoundPlans& found) {
  std::vector<WallLine> leaves = chosen.leaves;
  leaves.insert(leaves.end(), chosen.lines.begin(), chosen.lines.end());
  std::vector<Swing> swings = find_swings(drawing, chosen.arcs, chosen.lines, leaves);
  std::vector<bool> is_swing(drawing.arcs.size(), false);
  for (const Swing& swing : swings) is_swing[swing.arc] = true;
  std::vector<std::uint32_t> others;
  for (const std::uint32_t arc : chosen.any_arcs)
    if (!is_swing[arc]) others.push_back(arc);
  for (const Swing& swing : find_swings_by_leaves(drawing, others, chosen.lines)) {
    is_swing[swing.arc] = true;
    swings.push_back(swing);
  }
  for (const auto& [arc, line] : chosen.strokes_of_arcs)
    if (!is_swing[arc]) chosen.lines.push_back(line);
  found.culled["arcs that are no doors"] = static_cast<std::size_t>(
      std::ranges::count_if(chosen.arcs, [&](std::uint32_t arc) { return !is_swing[arc]; }));
  return swings;
}

std::size_t rooms_with_doors(const FoundPlan& plan) {
  return static_cast<std::size_t>(
      std::ranges::count_if(plan.rooms, [](const FoundRoom& room) { return room.doors > 0; }));
}

std::size_t rooms_with_doors(const FoundPlans& found) {
  std::size_t count = 0;
  for (const FoundPlan& plan : found.plans) count += rooms_with_doors(plan);
  return count;
}

/// A plan's title stands above or below it, in no room, nearer to it than to any other.
void read_titles(const Drawing& drawing, std::vector<FoundPlan>& plans) {
  constexpr double farthest_title = 12;  // Metres.
  for (const DrawnText& text : drawing.texts) {
    const auto ordinal = floor_said(text.text);
    if (!ordinal) continue;
    FoundPlan* nearest = nullptr;
    double away = farthest_title;
    for (FoundPlan& plan : plans) {
      const Vec2 beside = glm::clamp(text.at, plan.low, plan.high);
      const bool in_a_room = std::ranges::any_of(
          plan.rooms, [&](const FoundRoom& room) { return inside(room.rings, text.at); });
      if (in_a_room || glm::distance(beside, text.at) >= away) continue;
      away = glm::distance(beside, text.at);
      nearest = &plan;
    }
    if (nearest == nullptr || nearest->ordinal) continue;
    nearest->ordinal = ordinal;
    nearest->title = text.text.substr(0, text.text.find('\n'));
  }
}

/// Could both be floors of one building, drawn side by side? They are about as large, in one row or
/// one column, and each has rooms enough.
bool are_floors(const FoundPlan& a, const FoundPlan& b) {
  constexpr std::size_t fewest_rooms = 4;
  if (a.ordinal && b.ordinal) return *a.ordinal != *b.ordinal;
  if (rooms_with_doors(a) < fewest_rooms || rooms_with_doors(b) < fewest_rooms) return false;
  const Vec2 size_a = a.high - a.low, size_b = b.high - b.low;
  const Vec2 less = glm::min(size_a, size_b), more = glm::max(size_a, size_b);
  if (less.x < 0.5 * more.x || less.y < 0.5 * more.y) return false;
  const Vec2 off = glm::min(glm::abs(a.low - b.low), glm::abs(a.high - b.high));
  return off.x < 0.1 * more.x || off.y < 0.1 * more.y;
}

/// What is no floor of its own is a wing of the nearest plan that is.
void join_wings(FoundPlans& found) {
  std::vector<FoundPlan>& plans = found.plans;
  if (plans.size() < 2) return;
  std::vector<FoundPlan> floors, wings;
  for (std::size_t i = 0; i < plans.size(); ++i) {
    bool is_floor = false;
    for (std::size_t j = 0; j < plans.size(); ++j)
      is_floor = is_floor || (i != j && are_floors(plans[i], plans[j]));
    (is_floor || (i == 0 && floors.empty()) ? floors : wings).push_back(plans[i]);
  }
  const auto away = [](const FoundPlan& a, const FoundPlan& b) {
    return glm::length(glm::max(glm::max(a.low - b.high, b.low - a.high), Vec2(0)));
  };
  for (FoundPlan& wing : wings) {
    FoundPlan& nearest = *std::ranges::min_element(
        floors, {}, [&](const FoundPlan& floor) { return away(floor, wing); });
    std::ranges::move(wing.rooms, std::back_inserter(nearest.rooms));
    std::ranges::move(wing.doors, std::back_inserter(nearest.doors));
    std::ranges::move(wing.columns, std::back_inserter(nearest.columns));
    std::ranges::move(wing.stairs, std::back_inserter(nearest.stairs));
    nearest.low = glm::min(nearest.low, wing.low);
    nearest.high = glm::max(nearest.high, wing.high);
  }
  found.wings = wings.size();
  plans = std::move(floors);
}

/// The rooms of all strokes that could be walls by these kinds of layers.
FoundPlans find_by_lines(const Drawing& drawing, const std::vector<LayerKind>& kinds) {
  FoundPlans found;
  Chosen chosen = Chooser(drawing, kinds, found).choose();
  drop_strays(chosen.lines, found);
  drop_axes(chosen.lines, found);
  if (chosen.lines.size() > most_lines) {
    found.refused = fmt::format("{} strokes could be walls, more than the {} that are looked at",
                                chosen.lines.size(), most_lines);
    return found;
  }
  Box all;
  for (const WallLine& line : chosen.lines) {
    all.add(line.a);
    all.add(line.b);
  }
  if (const double across = glm::length(all.high - all.low);
      !chosen.lines.empty() && across > widest_plan) {
    found.refused =
        fmt::format("the lines lie {:.0f} km apart, which no building is wide", across / 1000);
    return found;
  }
  const std::vector<Flight> flights = take_flights(chosen, found);
  const std::vector<Swing> swings = swings_of(drawing, chosen, found);

  std::vector<PlanFinder> finders;
  std::size_t most_swings = 0;
  for (const std::vector<std::uint32_t>& part : parts_that_lie_together(chosen.lines)) {
    std::vector<WallLine> lines;
    for (const std::uint32_t i : part) lines.push_back(chosen.lines[i]);
    finders.emplace_back(drawing, std::move(lines), swings, flights, found);
    most_swings = std::max(most_swings, finders.back().swings());
  }
  for (PlanFinder& finder : finders) {
    // A section or a front has no swinging doors; where no plan has, the largest is the plan.
    const bool is_plan = most_swings > 0 ? finder.swings() > 0 : &finder == &finders.front();
    FoundPlan plan = is_plan ? finder.find() : FoundPlan{};
    const bool is_detail = 4 * finder.swings() < most_swings && rooms_with_doors(plan) < 2;
    if (is_plan && !is_detail && !plan.rooms.empty())
      found.plans.push_back(std::move(plan));
    else
      ++found.culled["parts of the drawing without doors: sections, fronts, details"];
  }
  read_titles(drawing, found.plans);
  join_wings(found);
  std::erase_if(found.culled, [](const auto& entry) { return entry.second == 0; });
  return found;
}

}  // namespace

FoundPlans find_rooms(const Drawing& drawing, const std::vector<LayerKind>& kinds) {
  if (const auto layer = layer_of_outlines(drawing, kinds)) {
    FoundPlans found;
    found.outlines_taken = true;
    found.plans.push_back(rooms_of_outlines(drawing, *layer, found));
    return found;
  }
  FoundPlans named = find_by_lines(drawing, kinds);
  if (rooms_with_doors(named) >= 3 || std::ranges::find(kinds, LayerKind::Wall) == kinds.end())
    return named;
  // Layers whose names promise walls and hold none: look at all that are not known to be others.
  std::vector<LayerKind> unnamed = kinds;
  for (LayerKind& kind : unnamed)
    if (kind == LayerKind::Wall) kind = LayerKind::Unknown;
  FoundPlans all = find_by_lines(drawing, unnamed);
  return rooms_with_doors(all) > 2 * rooms_with_doors(named) ? all : named;
}

}  // namespace docent::import
