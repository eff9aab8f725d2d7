#include "content/import/drawing/tidy_rooms.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "content/import/drawing/floor_words.h"
#include "content/import/drawing/inscribed.h"
#include "content/import/drawing/label.h"
#include "runtime/model/geometry/polygon.h"

namespace docent::import {
namespace {

constexpr double largest_furniture = 6;  ///< Square metres.

class RoomTidier {
 public:
  RoomTidier(const Drawing& drawing, RoomFaces faces, FoundPlan& plan, FoundPlans& found)
      : drawing_(drawing),
        faces_(std::move(faces)),
        plan_(plan),
        found_(found),
        boxes_(boxes_of(plan)) {}

  void tidy() {
    name_rooms();
    drop_furniture();
    drop_shafts();
  }

 private:
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
      faces_.sealed[kept] = faces_.sealed[i];
      faces_.frames[kept] = faces_.frames[i];
      ++kept;
    }
    plan_.rooms.resize(kept);
  }

  void drop_shafts() {
    std::size_t index = 0;
    const auto gone = std::ranges::remove_if(plan_.rooms, [&](const FoundRoom& room) {
      if (faces_.frames[index++] && room.doors == 0) {
        ++found_.culled["frames around the plan"];
        return true;
      }
      if (faces_.sealed[index - 1] && room.doors < 3 && (room.name.empty() || room.doors == 0)) {
        ++found_.culled["corners of the outside"];
        return true;
      }
      const bool shaft = room.doors == 0 && room.name.empty() && room.area < 2;
      if (shaft) ++found_.culled["shafts without door and name"];
      return shaft;
    });
    plan_.rooms.erase(gone.begin(), gone.end());
  }

  const Drawing& drawing_;
  RoomFaces faces_;
  FoundPlan& plan_;
  FoundPlans& found_;
  std::vector<DrawnBox> boxes_;
};

}  // namespace

void tidy_rooms(const Drawing& drawing, RoomFaces faces, FoundPlan& plan, FoundPlans& found) {
  RoomTidier(drawing, std::move(faces), plan, found).tidy();
}

void add_stairs(std::span<const Flight> flights, const DrawnBox& box, FoundPlan& plan) {
  for (const Flight& flight : flights) {
    const Vec2 middle = flight.middle();
    if (!box.holds(middle)) continue;
    const bool known = std::ranges::any_of(plan.stairs, [&](const FoundStairs& other) {
      return glm::length(other.middle - middle) < 2 * std::max(flight.width, 1.5);
    });
    if (known) continue;
    FoundStairs stairs{.middle = middle, .width = flight.width};
    for (const FoundRoom& room : plan.rooms)
      if (inside(room.rings, middle)) stairs.name = room.name;
    plan.stairs.push_back(std::move(stairs));
  }
  add_named_stairs(plan);
}

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

}  // namespace docent::import
