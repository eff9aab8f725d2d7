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
  double seconds = 0;            ///< When it sets out from the way's first point.
  double delay = 0;              ///< Seconds from then until it moves at full speed.
  double speed = 1;              ///< Metres a second.
  std::span<const Vec2> way;     ///< What is ahead of it, to its goal.
  std::span<const Vec2> behind;  ///< The way that it came, from where it is; may be empty.
  /// Bodies that count; all others are taken to be far away.
  std::span<const std::uint32_t> near;
  /// Of all, those that will make room when they are asked, once they stand.
  std::span<const std::uint32_t> yields_when_asked;
};

/// How it gets on.
struct Passage {
  /// Where to go now; one point: stay. Ends at the goal, or at a place where standing is safe.
  std::vector<Vec2> points;
  std::vector<double> along;  ///< Metres of the way for each point, negative behind.
  /// Of the points, those where it may stand for good as far as the others are committed,
  /// ascending; the first one always counts.
  std::vector<std::uint32_t> stop;
  bool is_straight = false;  ///< The way itself is free; `points` are its first metres.
  bool reaches_goal = false;
  std::vector<Vec2> line;  ///< What follows after waits too, as far as it is thought ahead.
  std::vector<std::uint32_t> in_the_way;  ///< Obliging bodies that have to make room first.
};

/// Finds how to get along a way in the next seconds without coming near any other's trajectory: on
/// it where it is free; else to its right, around, waiting, or back, whatever takes least time (A*
/// over metres along the way, metres beside it and time). Keeps the body's circle clear of the
/// walls.
Passage find_passage(const path::FloorMap& map, const ReservationTable& reservations,
                     const PassageQuery& query);

}  // namespace docent::crowd
