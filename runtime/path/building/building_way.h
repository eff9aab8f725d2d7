#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "runtime/model/none.h"
#include "runtime/path/closure/building_closure.h"
#include "runtime/path/way.h"

namespace docent::path {

/// What is to be least.
enum class Metric : std::uint8_t { Time, Length };

/// Which connections may be taken.
struct Permissions {
  bool step_free = false;  ///< Those for wheels only.
  bool no_escalators = false;
  bool closed_too = false;  ///< As if nothing were closed.

  friend bool operator==(const Permissions&, const Permissions&) = default;
};

/// What is asked: a way for a disc from a point of one floor to a point of another, or the same.
struct BuildingQuery {
  RouteQuery way;  ///< Of each floor's part; its ends are the whole way's.
  std::uint32_t from_floor = 0, to_floor = 0;
  /// Without: time across floors, length on one.
  std::optional<Metric> metric{};
  Permissions permissions{};
  /// What is closed beside what the museum says is closed for good; null: what is closed just now
  /// (BuildingMap::close). Made by BuildingMap::closure. `permissions.closed_too` goes through that
  /// as well.
  std::shared_ptr<const BuildingClosure> closed{};
};

/// A door of a floor.
struct DoorOfFloor {
  std::uint32_t floor = 0, door = 0;
  friend bool operator==(const DoorOfFloor&, const DoorOfFloor&) = default;
};

enum class BuildingStatus : std::uint8_t {
  Ok,
  StartBlocked,  ///< As RouteStatus.
  GoalBlocked,
  NoRoute,
  Closed,      ///< There would be a way if nothing were closed.
  NoStepFree,  ///< There is one, but with steps.
};

/// A part of a way: along a floor, or by a connection from one floor to another.
struct Leg {
  std::uint32_t floor = 0;          ///< Where it begins.
  std::uint32_t connection = none;  ///< Else the part is along the floor.
  std::uint32_t to_floor = 0;       ///< Where it ends.
  double length = 0;                ///< Metres.
  double seconds = 0;               ///< With the wait.
  std::vector<Vec2> points{};       ///< Along the floor: both ends; arcs flattened to 1 mm.

  bool is_along_floor() const noexcept { return connection == none; }
};

/// What is answered.
struct BuildingWay {
  BuildingStatus status = BuildingStatus::NoRoute;
  double length = 0;         ///< Metres, over floors and stairs.
  double seconds = 0;        ///< At strolling_pace, with waits.
  double clearance_min = 0;  ///< Metres, the smallest distance to a wall along the floors.
  std::vector<Leg> legs{};   ///< Floors and connections in turn; the first and last are floors.
  /// Closed: the connections that are in the way, as the way goes that could be taken were they
  /// open.
  std::vector<std::uint32_t> closed{};
  std::vector<DoorOfFloor> closed_doors{};  ///< Closed: the doors that are, likewise.
};

/// What a way along one floor says, of a building.
BuildingStatus building_status(RouteStatus status) noexcept;

/// A way and another one that begins where it ends.
BuildingWay joined(BuildingWay first, BuildingWay second);

}  // namespace docent::path
