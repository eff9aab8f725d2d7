#pragma once

#include <cstdint>
#include <vector>

#include "runtime/model/geometry/vec2.h"
#include "runtime/model/route_kind.h"

namespace docent::path {

class ClosedDoors;

enum class RouteStatus : std::uint8_t {
  Ok,
  StartBlocked,  ///< The start is closer to a wall than the radius, or outside.
  GoalBlocked,
  NoRoute,
};

/// Which hand the wall is on when walking along it. Shorter: whichever makes the shorter way.
enum class Hand : std::uint8_t { Shorter, Left, Right };

/// What is asked: a way for a disc from one point of a floor to another. Frame: floor, metres.
struct RouteQuery {
  RouteKind kind = RouteKind::Shortest;
  Vec2 from{}, to{};
  double radius = 0;          ///< Of the disc.
  double offset = 1;          ///< Offset only: distance kept from the wall.
  Hand hand = Hand::Shorter;  ///< Offset only.
  bool widest =
      false;  ///< Skeleton only: maximise the smallest clearance, then minimise the length.
  bool smooth = false;  ///< Skeleton and offset only: round the corners (see round_corners.h).
  /// Shortest only: find the `clearance_min` of a straight way, which takes longer than the way
  /// itself. Without, it is the radius, as on a way with bends.
  bool tell_clearance = true;
  /// Of the floor that is asked; null: what is closed there just now (FloorMap::close).
  const ClosedDoors* closed = nullptr;
};

/// What is answered. `points` holds both ends; arcs are flattened to 1 mm, inside the walkable
/// floor.
struct Way {
  RouteStatus status = RouteStatus::NoRoute;
  double length = 0;         ///< Metres, of the true way (arcs as arcs).
  double clearance_min = 0;  ///< Metres, the smallest distance to a wall along it.
  std::vector<Vec2> points{};
};

}  // namespace docent::path
