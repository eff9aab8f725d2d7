#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/model/geometry/vec2.h"

namespace docent {

/// By what one gets from floor to floor.
enum class ConnectionKind : std::uint8_t { Stairs, Escalator, Lift, Ramp };
inline constexpr std::size_t connection_kind_count = 4;

/// Which way one may go.
enum class ConnectionDirection : std::uint8_t { Both, Up, Down };

/// Where a connection meets a floor: a body that leaves the floor stands here and looks into it;
/// one that comes out stands here and looks the other way.
struct ConnectionStop {
  std::uint32_t floor = 0;  ///< Index into Museum::floors.
  Placement placement;
};

/// Stairs, an escalator, a lift or a ramp. Invariants: two stops or more, each on another floor,
/// from the lowest up by their floors' ordinals; times and lengths are finite and not negative.
struct Connection {
  std::string id;
  ConnectionKind kind = ConnectionKind::Stairs;
  ConnectionDirection direction = ConnectionDirection::Both;
  bool step_free = false;        ///< For wheels too.
  bool closed = false;           ///< For good, or until staff say otherwise.
  std::string hours{};           ///< When it is open (opening_hours.h); empty: always.
  double wait_seconds = 0;       ///< Before it moves, on the average.
  double seconds_per_floor = 0;  ///< Where two floors have the same ordinal, of one.
  double metres_per_floor = 0;   ///< As walked; a lift's are nothing.
  std::vector<ConnectionStop> stops;
};

/// A visitor's ordinary walk through a museum, metres a second.
inline constexpr double strolling_pace = 1.0;

}  // namespace docent
