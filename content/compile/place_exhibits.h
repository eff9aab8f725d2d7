#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "content/floor/footprint.h"
#include "runtime/model/exhibit/exhibit.h"
#include "runtime/path/route.h"

namespace docent::compile {

/// A floor as placing needs it.
struct PlacingFloor {
  const path::FloorMap& map;
  std::string name;
  /// Where visitors come from; empty where the kiosk stands on another floor.
  std::optional<Vec2> entrance;
  double body_radius = 0.25;
};

/// What somebody wants to stand somewhere.
struct WantedPlace {
  Vec2 position{};
  double heading = 0;  ///< Radians, counter-clockwise from east: where the object looks.
  std::optional<ExhibitPlace> place;      ///< What it stands on (standing.h).
  std::optional<floor::Footprint> takes;  ///< Of the floor, where it stands free.
  std::optional<Vec2> view;               ///< Where a visitor should stand, if staff said so.
};

/// Why a place cannot be used, in words for a diagnostic.
struct PlaceProblem {
  enum class Kind : std::uint8_t { Outside, NoView, ViewBlocked, Unreachable };
  Kind kind = Kind::Outside;
  std::string label, hint;
};

/// An exhibit's place and viewing point, or why there is none.
struct PlacedExhibit {
  ExhibitPlace place = ExhibitPlace::OnFloor;
  Placement view;
  std::optional<PlaceProblem> problem;
};

/// Finds out where a visitor stands to look at an exhibit: in front of it, 0.8 to 2 m away, clear
/// of walls and of what stands on the floor by the body radius and 5 cm, with nothing between, and
/// where the way from the entrance is wide enough for the body.
PlacedExhibit place_exhibit(const PlacingFloor& floor, const WantedPlace& wanted);

/// Why nobody whose body has this radius can stand at a point, as `ViewBlocked`; empty where one
/// can.
std::optional<PlaceProblem> why_nobody_stands(const path::FloorMap& map, Vec2 point,
                                              double body_radius);

/// Is there a way for a body of this radius (metres)?
bool can_walk(const path::FloorMap& map, Vec2 from, Vec2 to, double body_radius);

/// The nearest point that is clear of walls by `clearance` metres, in whole centimetres; empty
/// where there is none within 20 m.
std::optional<Vec2> nearest_free_point(const path::FloorMap& map, Vec2 point, double clearance);

/// "[12.40, 3.45]"
std::string point_text(Vec2 point);

}  // namespace docent::compile
