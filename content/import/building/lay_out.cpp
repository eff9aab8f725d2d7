#include "content/import/building/lay_out.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>

#include "runtime/model/geometry/segment.h"

namespace docent::import {
namespace {

/// Rooms that share more than this much floor overlap. Square metres.
constexpr double overlap_worth_telling = 0.5;
/// Two open rooms whose common edge is at least this long have no wall there. Metres.
constexpr double open_edge = 0.3;
/// Drawn edges this near to each other are one. Metres.
constexpr double as_one = 0.03;
/// How wide a way is that is drawn as a line. Metres.
constexpr double way_width = 1.2;
/// A way's corner this near to an outline is on it, and how wide it leads in there. Metres.
constexpr double on_outline = 0.05;
constexpr double entered_width = 1.0;
/// Half the width of walls and of strips of floor that are none. Metres.
constexpr double crack = 0.015;
/// The thickest wall that a door goes through. Metres.
constexpr double thickest = 1.2;

struct LaidRoom {
  Shape drawn;  ///< As it was drawn, without what others have of it.
  Box box{};
  bool open = false;  ///< A hall or a corridor.
  bool hall = false;
  bool joined = false;  ///< A door or an open edge leads to it.
};

class Layout {
 public:
  Layout(const ImportedLevel& level, std::vector<Doubt>& doubts) : level_(level), doubts_(doubts) {}

  LaidLevel made() && {
    take_rooms();
    set_outlines_aside();
    part_overlaps();
    join_open_rooms();
    raise_walls();
    LaidLevel laid;
    for (std::size_t i = 0; i < level_.doors.size(); ++i) cut_door(i, laid);
    walk_ways();
    tell_closed_rooms();
    std::vector<Shape> all = floors_;
    all.insert(all.end(), passages_.begin(), passages_.end());
    laid.floor = on_grid(without_cracks(united(all)), 1e-3);
    return laid;
  }

 private:
  void doubt(const char* code, Vec2 at, std::string message, const char* hint) {
    doubts_.push_back({code, level_.name, at, std::move(message), hint});
  }
  [[nodiscard]] std::string called(std::size_t room) const {
    const ImportedRoom& drawn = level_.rooms[room];
    if (!drawn.name.empty()) return fmt::format("'{}'", drawn.name);
    return drawn.source_id.empty() ? "a room without a name"
                                   : fmt::format("the room {}", drawn.source_id);
  }

  void take_rooms() {
    for (const ImportedRoom& room : level_.rooms) {
      LaidRoom laid{.drawn = shape_of(room.rings)};
      laid.box = laid.drawn.bounds();
      laid.hall = room.kind == "hall";
      laid.open = laid.hall || room.kind == "corridor";
      rooms_.push_back(std::move(laid));
    }
  }

  /// An area that others cover almost wholly is the outline of a part of the building.
  void set_outlines_aside() {
    for (std::size_t i = 0; i < rooms_.size(); ++i) {
      const double area = rooms_[i].drawn.area();
      std::vector<Shape> others;
      for (std::size_t j = 0; j < rooms_.size(); ++j)
        if (j != i && !rooms_[j].drawn.empty() && meet(rooms_[i].box, rooms_[j].box, 0) &&
            rooms_[j].drawn.area() < 0.8 * area)
          others.push_back(rooms_[j].drawn);
      if (others.size() < 3 || common(rooms_[i].drawn, united(others)).area() < 0.8 * area)
        continue;
      doubt("covers-rooms", middle_of(rooms_[i].drawn),
            fmt::format("{} covers {} other rooms and was taken for their outline", called(i),
                        others.size()),
            "leave it out of the plan, or draw it without the rooms");
      rooms_[i].drawn = {};
      rooms_[i].joined = true;
    }
  }

  [[nodiscard]] bool may_meet(std::size_t i, std::size_t j, double margin) const {
    return !rooms_[i].drawn.empty() && !rooms_[j].drawn.empty() &&
           meet(rooms_[i].box, rooms_[j].box, margin);
  }

  /// What two rooms have in common belongs to one: to the one whose door is in its edge there, else
  /// to the smaller, which stands in the larger.
  void part_overlaps() {
    std::vector<std::size_t> held(rooms_.size(), 0);  // Rooms that stand wholly in each.
    std::vector<Overlap> told;
    for (std::size_t i = 0; i < rooms_.size(); ++i)
      for (std::size_t j = i + 1; j < rooms_.size(); ++j) {
        if (!may_meet(i, j, 0)) continue;
        const Shape both = common(rooms_[i].drawn, rooms_[j].drawn);
        if (both.area() < 1e-4) continue;
        const double smaller = std::min(rooms_[i].drawn.area(), rooms_[j].drawn.area());
        const bool inside = both.area() > 0.95 * smaller;
        const std::size_t loser = keeps(i, j) ? j : i;
        if (inside) ++held[loser];
        if (both.area() > overlap_worth_telling && !(inside && (rooms_[i].hall || rooms_[j].hall)))
          told.push_back({i, j, loser, middle_of(both), both.area()});
        if (inside && (rooms_[i].hall || rooms_[j].hall)) inside_.push_back({i, j});
        rooms_[loser].drawn = without(rooms_[loser].drawn, both);
      }
    tell_overlaps(told, held);
  }

  struct Overlap {
    std::size_t one = 0, other = 0, loser = 0;
    Vec2 at{};
    double area = 0;
  };

  /// A floor's outline with all its rooms in it is told once: what is left of it is where one
  /// walks.
  void tell_overlaps(const std::vector<Overlap>& overlaps, const std::vector<std::size_t>& held) {
    constexpr std::size_t all_rooms = 4;
    for (std::size_t i = 0; i < rooms_.size(); ++i)
      if (held[i] >= all_rooms)
        doubt("covers-rooms", middle_of(rooms_[i].drawn),
              fmt::format("{} has {} other rooms in it; what is left between them was taken for it",
                          called(i), held[i]),
              "draw the corridors as areas of their own, if they are several");
    for (const Overlap& overlap : overlaps)
      if (held[overlap.loser] < all_rooms)
        doubt("rooms-overlap", overlap.at,
              fmt::format("{} and {} overlap by {:.1f} square metres", called(overlap.one),
                          called(overlap.other), overlap.area),
              "draw the wall between them once, where it stands");
  }

  [[nodiscard]] bool keeps(std::size_t i, std::size_t j) const {
    const int i_doors = doors_inside(i, j), j_doors = doors_inside(j, i);
    if (i_doors != j_doors) return i_doors > j_doors;
    return rooms_[i].drawn.area() <= rooms_[j].drawn.area();
  }

  /// How many doors are in the edge of one room, inside the other.
  [[nodiscard]] int doors_inside(std::size_t room, std::size_t other) const {
    int count = 0;
    for (const ImportedDoor& door : level_.doors) {
      const Vec2 at = (door.a + door.b) / 2.0;
      if (holds(rooms_[other].drawn, at) && edge_distance(room, at) < 0.05 &&
          edge_distance(other, at) > 0.05)
        ++count;
    }
    return count;
  }

  struct NearestEdge {
    double distance = INFINITY;
    Vec2 run{};
  };
  [[nodiscard]] NearestEdge nearest_edge(std::size_t room, Vec2 at) const {
    NearestEdge nearest;
    for (const BuildingRing& ring : level_.rooms[room].rings)
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
        const double distance = distance_to_segment(at, a, b);
        if (distance < nearest.distance) nearest = {distance, b - a};
      }
    return nearest;
  }
  [[nodiscard]] double edge_distance(std::size_t room, Vec2 at) const {
    return nearest_edge(room, at).distance;
  }

  /// Halls and corridors that touch are one space; so is a hall inside a room.
  void join_open_rooms() {
    space_of_.resize(rooms_.size());
    std::iota(space_of_.begin(), space_of_.end(), std::size_t{0});
    for (std::size_t i = 0; i < rooms_.size(); ++i)
      for (std::size_t j = i + 1; j < rooms_.size(); ++j)
        if (rooms_[i].open && rooms_[j].open && may_meet(i, j, as_one) && share_edge(i, j))
          join(i, j);
    for (const auto& [i, j] : inside_) join(i, j);
  }

  void join(std::size_t i, std::size_t j) {
    space_of_[root(i)] = root(j);
    rooms_[i].joined = rooms_[j].joined = true;
  }
  std::size_t root(std::size_t i) {
    while (space_of_[i] != i) i = space_of_[i] = space_of_[space_of_[i]];
    return i;
  }

  [[nodiscard]] bool share_edge(std::size_t i, std::size_t j) const {
    const Shape edge = common(grown(rooms_[i].drawn, as_one), grown(rooms_[j].drawn, as_one));
    return edge.area() > open_edge * as_one;
  }

  /// Each space shrinks by half a wall, and what stands in it is taken out.
  void raise_walls() {
    std::vector<Shape> solids;
    for (const BuildingRing& ring : level_.obstacles) solids.push_back(shape_of({&ring, 1}));
    const Shape solid = united(solids);
    spaces_.resize(rooms_.size());
    floors_.resize(rooms_.size());
    for (std::size_t space = 0; space < rooms_.size(); ++space) {
      std::vector<Shape> parts;
      for (std::size_t i = 0; i < rooms_.size(); ++i)
        if (root(i) == space) parts.push_back(rooms_[i].drawn);
      if (parts.size() > 1) {
        for (Shape& part : parts) part = grown(part, as_one);
        spaces_[space] = grown(united(parts), -as_one);
      } else if (!parts.empty()) {
        spaces_[space] = parts[0];
      }
      boxes_.push_back(spaces_[space].bounds());
      floors_[space] = without(grown(spaces_[space], -partition / 2), solid);
    }
  }

  /// A room that one comes to from a point, going a way.
  struct Reached {
    std::size_t space = 0;
    double distance = 0;
  };

  [[nodiscard]] std::optional<Reached> reach(Vec2 from, Vec2 way) const {
    constexpr double step = 0.04;
    for (double away = step; away < thickest; away += step) {
      const Vec2 at = from + away * way;
      for (std::size_t space = 0; space < floors_.size(); ++space)
        if (!floors_[space].empty() && meet(boxes_[space], {at, at}, 0) &&
            holds(floors_[space], at))
          return Reached{space, away};
    }
    return {};
  }

  void cut_door(std::size_t index, LaidLevel& laid) {
    const ImportedDoor& door = level_.doors[index];
    const Vec2 centre = (door.a + door.b) / 2.0;
    const double width = glm::distance(door.a, door.b);
    if (width < 0.1) return;
    const Vec2 along = (door.b - door.a) / width;
    const auto left = reach(centre, left_of(along)), right = reach(centre, -left_of(along));
    if (left) mark_joined(left->space);
    if (right) mark_joined(right->space);
    if (!left && !right) {
      if (!door.doubtful)
        doubt("door-leads-nowhere", centre,
              fmt::format("the door {} has no room on either side", door.source_id),
              "draw it on the wall of the room that it opens, or leave it out");
      return;
    }
    if (!left || !right) return;
    const Vec2 from = centre + (left->distance + 0.05) * left_of(along);
    const Vec2 to = centre - (right->distance + 0.05) * left_of(along);
    const Vec2 line[] = {from, to};
    const Shape passage =
        common(shape_about(line, width / 2, LineEnds::Flat), between(*left, *right, centre, width));
    if (passage.empty()) return;
    add_leaf(index, centre, along, width, passage, laid);
    passages_.push_back(passage);
  }

  /// Where strips of ways and doors meet at a slant, cracks remain that nobody drew.
  static Shape without_cracks(const Shape& floor) {
    return grown(grown(grown(floor, crack), -2 * crack), crack);
  }

  void mark_joined(std::size_t space) {
    for (std::size_t i = 0; i < rooms_.size(); ++i)
      if (root(i) == space) rooms_[i].joined = true;
  }

  /// The two spaces with the wall between them filled, as far as the walls about both: a passage
  /// that keeps to it opens neither the building nor a third room.
  [[nodiscard]] Shape between(const Reached& left, const Reached& right, Vec2 centre,
                              double width) const {
    const double reach = width + 2 * thickest;
    const BuildingRing window{{centre.x - reach, centre.y - reach},
                              {centre.x + reach, centre.y - reach},
                              {centre.x + reach, centre.y + reach},
                              {centre.x - reach, centre.y + reach}};
    const Shape near = shape_of({&window, 1});
    const double gap = (left.distance + right.distance) / 2 + as_one;
    const Shape both[] = {grown(common(spaces_[left.space], near), gap),
                          grown(common(spaces_[right.space], near), gap)};
    Shape filled = grown(united(both), -gap - partition / 2);
    for (std::size_t i = 0; i < spaces_.size(); ++i)
      if (i != left.space && i != right.space && !spaces_[i].empty() &&
          meet(boxes_[i], {centre, centre}, reach))
        filled = without(filled, grown(spaces_[i], partition / 2));
    return filled;
  }

  static void add_leaf(std::size_t index, Vec2 centre, Vec2 along, double width,
                       const Shape& passage, LaidLevel& laid) {
    // Where the passage is, on the line between the jambs.
    constexpr int steps = 200;
    std::optional<double> low, high;
    for (int i = 0; i <= steps; ++i) {
      const double t = width * (static_cast<double>(i) / steps - 0.5);
      if (!holds(passage, centre + t * along)) continue;
      if (!low) low = t;
      high = t;
    }
    if (low && high && *high - *low > 0.2)
      laid.doors.push_back({index, centre + *low * along, centre + *high * along});
  }

  /// A mapped way is floor, as wide as two people, and leads through the walls that it crosses; in
  /// walls that it only passes it opens nothing.
  void walk_ways() {
    if (rooms_.empty()) return;
    for (const std::vector<Vec2>& way : level_.ways) {
      const Shape line = shape_about(way, 0.02, LineEnds::Flat);
      Shape walked = shape_about(way, way_width / 2, LineEnds::Square);
      const Box box = walked.bounds();
      for (std::size_t space = 0; space < spaces_.size(); ++space) {
        if (spaces_[space].empty() || !meet(boxes_[space], box, 0.1)) continue;
        if (common(line, floors_[space]).area() > 0.02 * 0.04)
          mark_joined(space);
        else
          walked = without(walked, grown(spaces_[space], partition / 2));
      }
      passages_.push_back(std::move(walked));
      for (const Vec2 corner : way) enter_from(corner);
    }
  }

  /// A way with a corner on a room's outline was drawn to lead there: it goes on into the room.
  void enter_from(Vec2 corner) {
    for (std::size_t i = 0; i < rooms_.size(); ++i) {
      if (rooms_[i].drawn.empty() || !meet(rooms_[i].box, {corner, corner}, on_outline)) continue;
      const NearestEdge edge = nearest_edge(i, corner);
      if (edge.distance > on_outline || !(glm::length(edge.run) > 0)) continue;
      const std::size_t space = root(i);
      for (const double side : {1.0, -1.0}) {
        const Vec2 inward = side * glm::normalize(left_of(edge.run));
        if (!holds(floors_[space], corner + 2 * partition * inward)) continue;
        const Vec2 line[] = {corner - 0.3 * inward, corner + 0.5 * inward};
        Shape passage = shape_about(line, entered_width / 2, LineEnds::Flat);
        for (std::size_t other = 0; other < spaces_.size(); ++other)
          if (other != space && !spaces_[other].empty() && meet(boxes_[other], passage.bounds(), 0))
            passage = without(passage, grown(spaces_[other], partition / 2));
        passages_.push_back(std::move(passage));
        mark_joined(space);
        break;
      }
    }
  }

  void tell_closed_rooms() {
    for (std::size_t i = 0; i < rooms_.size(); ++i)
      if (!rooms_[i].joined && !rooms_[i].drawn.empty())
        doubt("room-without-door", middle_of(rooms_[i].drawn),
              fmt::format("{} has no door: nobody gets in", called(i)),
              "draw its door in the plan and import again, or write a [[door]] in its wall, which "
              "opens "
              "it: floor, a and b");
  }

  const ImportedLevel& level_;
  std::vector<Doubt>& doubts_;
  std::vector<LaidRoom> rooms_;
  std::vector<std::pair<std::size_t, std::size_t>> inside_;
  std::vector<std::size_t> space_of_;
  std::vector<Shape> spaces_;  ///< By a space's first room; empty for the others.
  std::vector<Box> boxes_;
  std::vector<Shape> floors_;
  std::vector<Shape> passages_;
};

}  // namespace

LaidLevel lay_out(const ImportedLevel& level, std::vector<Doubt>& doubts) {
  return Layout(level, doubts).made();
}

bool settle(const Shape& standing, Vec2& point, double farthest) {
  if (standing.empty()) return false;
  if (holds(standing, point)) return true;
  const double away = distance(standing, point);
  if (away > farthest) return false;
  // The nearest place, and a little farther in: what is written is rounded.
  Vec2 best = point;
  double nearest = INFINITY;
  for (const auto& rings : polygons_of(standing))
    for (const BuildingRing& ring : rings)
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2 a = ring[i], run = ring[(i + 1) % ring.size()] - a;
        const double squared = dot(run, run);
        const double share = squared > 0 ? std::clamp(dot(point - a, run) / squared, 0.0, 1.0) : 0;
        const Vec2 at = a + share * run;
        if (glm::distance(at, point) >= nearest) continue;
        nearest = glm::distance(at, point);
        best = at;
      }
  point = best;
  return true;
}

}  // namespace docent::import
