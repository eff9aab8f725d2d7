#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "content/compile/place_exhibits.h"
#include "content/compile/standing.h"
#include "runtime/model/exhibit/exhibit.h"
#include "runtime/path/floor_map.h"

namespace docent::compile {

/// A way between two parts of a floor that what stands on it leaves no room for.
struct ClosedPassage {
  std::vector<const Standing*> by;  ///< The nearest to its middle first; never empty.
  Vec2 at{};                        ///< Its middle. Floor frame.
  Vec2 from{}, to{};                ///< On its two sides, with room for the body.
  std::optional<double> way_round;  ///< Metres; empty where there is none.
};

/// The passages that things close for a body of this radius (metres): where the middle of the floor
/// without them (`walls`) has room and the floor with them (`map`) has none, so that one cannot get
/// from one side to the other, or only by a way that is longer by 15 m and more. A thing that one
/// walks round closes none.
std::vector<ClosedPassage> closed_passages(const FloorPlan& walls, const path::FloorMap& map,
                                           std::span<const Standing> things, double radius);

/// How staff know a passage: by the name of its door, the rooms on its sides, or its place.
std::string passage_name(const ClosedPassage& passage, std::span<const Door> doors,
                         std::span<const Room> rooms, const std::string& language);

/// The thing that takes the floor at a point, or leaves no room there for a body of this radius;
/// null where none does.
const Standing* in_the_way(std::span<const Standing> things, Vec2 point, double radius);

/// Why nobody of this radius can stand at a point, as why_nobody_stands (place_exhibits.h) says it;
/// what stands there is called by its name.
std::optional<PlaceProblem> why_not_there(const path::FloorMap& map,
                                          std::span<const Standing> things, Vec2 point,
                                          double radius);

}  // namespace docent::compile
