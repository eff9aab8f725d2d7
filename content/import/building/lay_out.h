#pragma once

#include <vector>

#include "content/import/building/imported_building.h"
#include "content/import/building/shape.h"

namespace docent::import {

/// A door as it came to be: where its leaf stands between two rooms.
struct LaidDoor {
  std::size_t door = 0;  ///< Index into ImportedLevel::doors.
  Vec2 a{}, b{};         ///< On the walls to its sides.
};

/// A level on which walls have a thickness: rooms are joined where a door is, and where neither of
/// two has a wall.
struct LaidLevel {
  Shape floor;                  ///< Where one can walk.
  std::vector<LaidDoor> doors;  ///< Those that join two rooms or two parts of an open one.
};

/// How thick a wall is between rooms that touch, metres.
inline constexpr double partition = 0.1;

/// Lays out a level, and says in `doubts` what is doubtful: rooms that overlap, rooms without a
/// door, doors that lead nowhere.
LaidLevel lay_out(const ImportedLevel& level, std::vector<Doubt>& doubts);

/// Moves a point into a shape (where a body can stand) that is no more than `farthest` metres away;
/// otherwise leaves it and returns false.
bool settle(const Shape& standing, Vec2& point, double farthest);

}  // namespace docent::import
