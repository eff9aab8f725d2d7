#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "runtime/crowd/reservation_table.h"
#include "runtime/path/route.h"

namespace docent::crowd {

/// A body that wants to get on along its way, among others.
struct PassageQuery {
  std::uint32_t body = 0;
  double seconds = 0;            ///< Crowd's clock: when it sets out from the way's first point.
  double delay = 0;              ///< Seconds from then until it moves at full speed.
  double speed = 1;              ///< Metres a second.
  std::span<const Vec2> way;     ///< What is ahead of it, to its goal.
  std::span<const Vec2> behind;  ///< The way that it came, from where it is; may be empty.
  /// The bodies that are looked at; all others are taken to be far away.
  std::span<const std::uint32_t> near;
  /// Those of all bodies that will make room when asked, once they stand.
  std::span<const std::uint32_t> yields_when_asked;
};

/// How it gets on.
struct Passage {
  /// Where to go now; one point: stay. Ends at the goal, or at a place where standing is safe.
  std::vector<Vec2> points;
  std::vector<double> along;  ///< Per point: metres along the way; negative on the way it came.
  /// The points, by index, ascending, where it may stand for good without coming near a trajectory
  /// to which another is committed; the first point is always one.
  std::vector<std::uint32_t> stop;
  bool is_straight = false;  ///< The way itself is free; `points` are its first metres.
  bool reaches_goal = false;
  std::vector<Vec2> line;  ///< Where it will want to go: `points`, and what follows after waits.
  std::vector<std::uint32_t> in_the_way;  ///< Bodies that yield, and have to make room first.
};

/// Finds how to get along a way in the next ten seconds without coming near any other's trajectory:
/// straight along the way where it is free; else to its right, around others, waiting, or back,
/// whichever costs least time (A* over metres along the way, metres beside it, and time). Keeps the
/// body's circle clear of the walls.
Passage find_passage(const path::FloorMap& map, const ReservationTable& reservations,
                     const PassageQuery& query);

}  // namespace docent::crowd
