#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/model/geometry/vec2.h"

namespace docent {

/// The vertices of one ring: [first, first + count) of FloorPlan::vertex.
struct Ring {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

/// How a door is opened by whoever comes from the side from which `a` is on the left; from the
/// other side, in brackets.
enum class DoorOpens : std::uint8_t {
  None,     ///< It has no leaf, or stands open always.
  Push,     ///< Pushed (pushed too: it swings both ways).
  Pull,     ///< Pulled (pushed).
  Sliding,  ///< Slid aside.
  Count
};

/// Which end of a door its leaf hangs at; of a sliding one, to which it is slid.
enum class DoorHinge : std::uint8_t { A, B, Both, Count };

/// A doorway that staff can close. Its segment crosses free floor between two walls.
struct Door {
  std::string name;  ///< Stable: what staff call it, or its id.
  Vec2 a{}, b{};
  bool closed = false;  ///< For good: the plan has a wall there.
  std::string hours{};  ///< When it is open (opening_hours.h); empty: always.
  DoorOpens opens = DoorOpens::None;
  DoorHinge hinge = DoorHinge::Both;  ///< Both: it has two leaves.
};

/// The walls of one floor, mended: what remains is the walkable interior.
///
/// Frame: floor (metres, x east, y north).
/// Invariants, made by the content compiler and checked once on load:
///  - wall i runs from vertex i to the next vertex of its ring: one index for walls and vertices;
///  - the interior lies to the left of every wall (outer rings counter-clockwise, holes clockwise);
///  - rings cross neither themselves nor each other; vertices of a ring are at least 0.1 mm apart.
/// Immutable once loaded, so any thread may read it.
struct FloorPlan {
  std::string name;
  std::int32_t ordinal = 0;  ///< Which storey it is: of two floors the upper one's is greater.
  double height = 0;         ///< Metres, world y of the floor.
  std::string short_name{};  ///< What a lift's button says: "G", "1".
  std::vector<Vec2> vertex;
  std::vector<Ring> ring;
  std::vector<std::uint32_t> next;  ///< One per vertex: the vertex after it in its ring.
  std::vector<Door> doors;
};

inline Vec2 wall_start(const FloorPlan& plan, std::uint32_t wall) noexcept {
  return plan.vertex[wall];
}
inline Vec2 wall_end(const FloorPlan& plan, std::uint32_t wall) noexcept {
  return plan.vertex[plan.next[wall]];
}

/// The diagonal of the box about all walls, metres. No straight line on the floor is longer.
inline double diagonal(const FloorPlan& plan) noexcept {
  if (plan.vertex.empty()) return 0;
  Vec2 low = plan.vertex.front(), high = low;
  for (const Vec2 v : plan.vertex) {
    low = glm::min(low, v);
    high = glm::max(high, v);
  }
  return glm::distance(low, high);
}

}  // namespace docent
