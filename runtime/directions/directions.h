#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "runtime/directions/doorways.h"
#include "runtime/model/museum.h"
#include "runtime/path/building/building_way.h"

namespace docent::directions {

/// Where something is for somebody who looks a certain way.
enum class Side : std::uint8_t { Ahead, Left, Right, Behind, BehindLeft, BehindRight };
inline constexpr std::size_t side_count = 6;

/// From a room to the next one on the way.
struct DoorStep {
  /// Indices into Museum::rooms; none: a passage that has no name.
  std::uint32_t from = none, to = none;
  Side side = Side::Ahead;  ///< For who has come in by the door before.
  /// The door is the `nth` of so many on that side; 0 of 0 where there is no door but a wide
  /// opening.
  std::uint32_t nth = 0, of = 0;

  bool operator==(const DoorStep&) const = default;
};

/// A turn of the way where no rooms are known.
struct Turn {
  Side side = Side::Left;
  double after = 0;  ///< Metres since the turn before.
};

/// By what one changes floors.
struct RideStep {
  ConnectionKind kind = ConnectionKind::Stairs;
  bool up = true;
  std::uint32_t floor = 0;  ///< To which one.
};

/// The part of a way along one floor.
struct FloorPart {
  std::uint32_t floor = 0;
  std::uint32_t room = none;    ///< Where it begins; none: in no named room.
  std::vector<DoorStep> doors;  ///< From room to room.
  std::vector<Turn> turns;      ///< Before the first room that is known.
  std::optional<RideStep> then{};

  /// The last room of it.
  std::uint32_t last_room() const noexcept { return doors.empty() ? room : doors.back().to; }
};

/// What a visitor is looking for.
struct Goal {
  std::uint32_t floor = 0;
  Vec2 position{};                                  ///< Of the thing itself.
  std::optional<std::uint32_t> exhibit{}, place{};  ///< Which one it is.
};

enum class Setting : std::uint8_t { OnFloor, OnWall, InCase, Place };
enum class Where : std::uint8_t { Ahead, Left, Right, Behind, Middle };

/// How the goal is found once one is in its room.
struct GoalPart {
  std::uint32_t room = none;
  Setting setting = Setting::OnFloor;
  Where where = Where::Ahead;   ///< For who has just come in.
  std::uint32_t beside = none;  ///< Index into Museum::places: what everybody finds, close to it.
};

/// A way in facts: what one says to a visitor. Pure values; words are the interface's.
struct Directions {
  std::vector<FloorPart> parts;  ///< At least one; each but the last ends with a ride.
  GoalPart goal;
  double metres = 0, seconds = 0;
  bool step_free = true;
};

/// The facts of a way that was found, for a visitor who stands at `start` and looks along its
/// heading; none where there is no way.
std::optional<Directions> direct(const Museum& museum, const Doorways& doorways,
                                 const Placement& start, const path::BuildingWay& way,
                                 const Goal& goal);

}  // namespace docent::directions
