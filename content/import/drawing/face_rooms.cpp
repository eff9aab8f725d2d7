#include "content/import/drawing/face_rooms.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "content/import/drawing/gap.h"
#include "content/import/drawing/inscribed.h"
#include "content/import/drawing/line_kind.h"
#include "runtime/model/geometry/polygon.h"

namespace docent::import {
namespace {

constexpr double smallest_column = 0.02;

class FaceRooms {
 public:
  FaceRooms(const ClosedPlan& closed, FoundPlan& plan, FoundPlans& found)
      : closed_(closed), plan_(plan), found_(found) {}

  RoomFaces find() {
    RoomFaces rooms;
    double all = 0;
    for (const Face& face : closed_.faces.face) all += std::max(0.0, face.area);
    for (const Face& face : closed_.faces.face) {
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
      rooms.sealed.push_back(is_sealed(face));
      rooms.face.push_back(static_cast<std::uint32_t>(&face - closed_.faces.face.data()));
      rooms.frames.push_back(held > 0.5 * outer && held > 0.5 * all);
      plan_.rooms.push_back(std::move(room));
    }
    return rooms;
  }

 private:
  std::vector<std::vector<Vec2>> rings_of(const Face& face) const {
    std::vector<std::vector<Vec2>> rings{corners_of(closed_.arrangement, face.outer)};
    for (const std::vector<std::uint32_t>& hole : face.holes) {
      std::vector<Vec2> ring = corners_of(closed_.arrangement, hole);
      if (std::abs(signed_area(ring)) > smallest_column) rings.push_back(std::move(ring));
    }
    return rings;
  }

  bool is_sealed(const Face& face) const {
    return std::ranges::any_of(face.outer, [&](std::uint32_t half) {
      return closed_.arrangement.edge[half / 2].kind == SealLine;
    });
  }

  /// In a thick wall, both sides of a doorway are shut: what lies between is no room.
  bool is_doorway(const Face& face, const FoundRoom& room, double radius) const {
    if (2 * radius > thickest_wall || room.area > 3) return false;
    const auto shut = std::ranges::count_if(face.outer, [&](std::uint32_t half) {
      return closed_.arrangement.edge[half / 2].kind >= first_closing_kind;
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
    const std::vector<Vec2> ring = corners_of(closed_.arrangement, face.outer);
    const bool free = std::ranges::all_of(face.outer, [&](std::uint32_t half) {
      if (closed_.arrangement.edge[half / 2].kind >= first_closing_kind)
        return false;  // A doorway.
      const std::uint32_t other = closed_.faces.face_of[half ^ 1U];
      return other != no_face && closed_.faces.face[other].area > 4;
    });
    if (free) plan_.columns.push_back(ring);
  }

  const ClosedPlan& closed_;
  FoundPlan& plan_;
  FoundPlans& found_;
};

}  // namespace

RoomFaces find_face_rooms(const ClosedPlan& closed, FoundPlan& plan, FoundPlans& found) {
  return FaceRooms(closed, plan, found).find();
}

std::vector<DrawnBox> boxes_of(const FoundPlan& plan) {
  std::vector<DrawnBox> boxes(plan.rooms.size());
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (const Vec2 p : plan.rooms[i].rings.front()) boxes[i].add(p);
  return boxes;
}

}  // namespace docent::import
