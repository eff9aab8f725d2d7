#include "content/import/drawing/find_doors.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "content/import/drawing/gap.h"
#include "content/import/drawing/inscribed.h"

namespace docent::import {
namespace {

class DoorFinder {
 public:
  DoorFinder(const ClosedPlan& closed, const RoomFaces& rooms, FoundPlan& plan, FoundPlans& found)
      : closed_(closed), rooms_(rooms), plan_(plan), found_(found), boxes_(boxes_of(plan)) {}

  void find_in_closings() {
    for (const Closing& closing : closed_.closings) {
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

  /// Doorways that are shut by lines from jamb to jamb: what is no doorway for certain, since walls
  /// meet there or it is too long, is wall; beside a wall is a doorway, and beside that a wall.
  /// Only for rooms into which nothing else leads.
  void find_thresholds() {
    const bool is_shut_in =
        std::ranges::any_of(plan_.rooms, [](const FoundRoom& room) { return room.doors == 0; });
    if (!is_shut_in) return;
    std::vector<std::uint32_t> room_of(closed_.faces.face.size(), no_face);
    for (std::uint32_t r = 0; r < rooms_.face.size(); ++r) room_of[rooms_.face[r]] = r;
    std::map<std::uint32_t, Doorway> doorways;
    for (std::uint32_t f = 0; f < closed_.faces.face.size(); ++f)
      if (room_of[f] == no_face)
        if (auto door = doorway_of(closed_.faces.face[f], room_of))
          doorways.emplace(f, std::move(*door));
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
    std::vector<std::pair<std::size_t, std::size_t>> shut;  // the rooms of each
    for (const auto& [f, door] : doorways) {
      if (is[f] != Is::Door) continue;
      if (plan_.rooms[door.left].doors > 0 && plan_.rooms[door.right].doors > 0) continue;
      plan_.doors.push_back({door.a, door.b, false, false, false, 2U});
      shut.emplace_back(door.left, door.right);
    }
    for (const auto& [left, right] : shut) {
      ++plan_.rooms[left].doors;
      ++plan_.rooms[right].doors;
    }
  }

 private:
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
      const std::uint32_t other = closed_.faces.face_of[half ^ 1U];
      if (other == no_face) return std::nullopt;
      const Vec2 a = closed_.arrangement.vertex[closed_.arrangement.origin(half)];
      const Vec2 b = closed_.arrangement.vertex[closed_.arrangement.head(half)];
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

  const ClosedPlan& closed_;
  const RoomFaces& rooms_;
  FoundPlan& plan_;
  FoundPlans& found_;
  std::vector<DrawnBox> boxes_;
};

}  // namespace

void find_doors(const ClosedPlan& closed, const RoomFaces& rooms, FoundPlan& plan,
                FoundPlans& found) {
  DoorFinder finder(closed, rooms, plan, found);
  finder.find_in_closings();
  finder.find_thresholds();
}

}  // namespace docent::import
