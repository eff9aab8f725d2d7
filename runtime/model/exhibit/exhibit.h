#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "runtime/model/exhibit/object.h"
#include "runtime/model/exhibit/touch.h"
#include "runtime/model/geometry/vec2.h"
#include "runtime/model/local_text.h"

namespace docent {

/// What an exhibit stands on, found by the compiler from its position.
enum class ExhibitPlace : std::uint8_t {
  OnFloor,  ///< Or on a plinth or a pedestal, without glass.
  OnWall,
  InCase,         ///< Under glass.
  ToTouch,        ///< On the floor, a plinth or a pedestal, and may be touched.
  OnWallToTouch,  ///< The same, on a wall.
};

inline bool hangs(ExhibitPlace place) noexcept {
  return place == ExhibitPlace::OnWall || place == ExhibitPlace::OnWallToTouch;
}
inline bool may_be_touched(ExhibitPlace place) noexcept {
  return place == ExhibitPlace::ToTouch || place == ExhibitPlace::OnWallToTouch;
}

/// Something to look at.
struct Exhibit {
  std::string id;           ///< Stable, lower case with hyphens: names it in visits and routes.
  std::uint32_t floor = 0;  ///< Index into Museum::floors.
  std::uint32_t room = 0;   ///< Index into Museum::rooms.
  Placement placement;      ///< Where the object is, and the way that it faces.
  Placement viewing_point;  ///< Where a visitor stands to look at it, facing it.
  ExhibitPlace place = ExhibitPlace::OnFloor;
  LocalText title;
  LocalText text;
  LocalText description{};  ///< What its picture shows, for who does not see it; may be empty.
  LocalText more{};         ///< For who wants to know more; lines are paragraphs; may be empty.
  /// By which it is found, besides its title: staff's tags. Any may be empty.
  LocalText artist{}, subject{}, period{};
  std::uint32_t image = 0;  ///< Index into Museum::images.
  bool closed = false;      ///< For good, or until staff say otherwise.
  std::string hours{};      ///< When it can be seen (opening_hours.h); empty: always.
  /// How much it is worth seeing, where not all can be seen; not negative, and how long one looks.
  double weight = 1, looking_seconds = ordinary_look;

  std::int32_t object = -1;  ///< Index into Museum::objects: its own shape; -1: it has none.
  ObjectStand stand{};       ///< Of the object, where it has one.

  /// How a guide lays a hand on it: from either side at most once, the left one first. None where
  /// it may not be touched, nobody gets to it, or there are no clips.
  std::vector<Touch> touches{};

  static constexpr double ordinary_look = 60;
};

/// A further picture of an exhibit, besides its own: one leafs to it.
struct FurtherPicture {
  /// Of an exhibit, its own one included.
  static constexpr std::size_t most = 20;

  std::uint32_t exhibit = 0;  ///< Index into Museum::exhibits.
  std::uint32_t image = 0;    ///< Index into Museum::images.
  LocalText caption{};        ///< Read below it; may be empty.
  LocalText description{};    ///< What it shows, for who does not see it; may be empty.
};

/// A gallery: a name for a part of a floor.
struct Room {
  std::string id;
  std::uint32_t floor = 0;
  LocalText title;
  Vec2 label{};               ///< Floor frame: where its name stands.
  std::vector<Vec2> outline;  ///< Floor frame, counter-clockwise polygon; may be empty.
  bool closed = false;        ///< For good, or until staff say otherwise.
  std::string hours{};        ///< When it is open (opening_hours.h); empty: always.
};

}  // namespace docent
