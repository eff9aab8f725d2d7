#include "runtime/directions/directions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <limits>
#include <span>

#include "runtime/model/exhibit/room_of.h"
#include "runtime/model/geometry/polyline.h"
#include "runtime/model/geometry/segment.h"

namespace docent::directions {
namespace {

constexpr double sample = 0.1;     // metres along a way
constexpr double passing = 0.7;    // metres: who walks no farther in a room has not been in it
constexpr double unnamed = 2.5;    // metres: who walks farther without a room's name is in no room
constexpr double near_door = 1.2;  // metres from where a way leaves an outline to its doorway
const double diagonal = std::sqrt(0.5);

Vec2 unit(double heading) noexcept {
  return {std::cos(heading), std::sin(heading)};
}

/// A room that a way passes.
struct Stay {
  std::uint32_t room = none;
  Vec2 in{}, out{};
  double length = 0;
  double outside = 0;  ///< Metres walked in no named room before it.
};

/// The rooms of a way, and how far it goes on in none after the last.
struct Stays {
  std::vector<Stay> rooms;
  double outside = 0;
};

Stays stays_of(const Museum& museum, std::uint32_t floor, std::span<const Vec2> way) {
  std::vector<Stay> stays;
  double outside = 0;
  Vec2 last = way.empty() ? Vec2{} : way.front();
  const auto note = [&](Vec2 at) {
    const double step = glm::distance(last, at);
    last = at;
    const std::uint32_t room = room_of(museum, floor, at);
    if (room == none) {
      outside += step;
      return;
    }
    if (stays.empty() || stays.back().room != room || outside > unnamed)
      stays.push_back({room, at, at, 0, outside});
    outside = 0;
    Stay& stay = stays.back();
    stay.length += glm::distance(stay.out, at);
    stay.out = at;
  };
  for (std::size_t i = 0; i < way.size(); ++i) {
    const Vec2 from = way[i == 0 ? 0 : i - 1];
    const double steps = std::max(1.0, std::ceil(glm::distance(from, way[i]) / sample));
    for (double k = 1; k <= steps; ++k) note(glm::mix(from, way[i], k / steps));
  }
  // Corners that are cut, but for where one stands at either end.
  std::vector<Stay> kept;
  for (std::size_t i = 0; i < stays.size(); ++i) {
    const bool is_end = i == 0 || i + 1 == stays.size();
    if (!is_end && stays[i].length < passing) {
      stays[i + 1].outside += stays[i].outside;
      continue;
    }
    if (!kept.empty() && kept.back().room == stays[i].room && stays[i].outside <= unnamed) {
      kept.back().out = stays[i].out;
      kept.back().length += stays[i].length;
    } else {
      kept.push_back(stays[i]);
    }
  }
  return {std::move(kept), outside};
}

/// The first so many metres of a line.
std::vector<Vec2> beginning_of(std::span<const Vec2> line, double metres) {
  std::vector<Vec2> beginning;
  double walked = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (i > 0) walked += glm::distance(line[i - 1], line[i]);
    if (walked > metres) break;
    beginning.push_back(line[i]);
  }
  beginning.push_back(point_along(line, metres));
  return beginning;
}

/// The doorway of a room by which a way comes in or goes out at a point; null where there is none.
const Doorway* doorway_at(const Doorways& doorways, std::uint32_t room, Vec2 at) {
  const Doorway* nearest = nullptr;
  double least = near_door;
  for (const Doorway& doorway : doorways.of(room)) {
    const Vec2 half = doorway.width / 2 * left_of(doorway.outward);
    const double far = distance_to_segment(at, doorway.middle - half, doorway.middle + half);
    if (far >= least) continue;
    least = far;
    nearest = &doorway;
  }
  return nearest;
}

/// Where a visitor is in a room, and how they look about.
struct Stance {
  Vec2 at{};
  Vec2 facing{1, 0};
  const Doorway* entry = nullptr;
};

Side side_of(const Stance& stance, const Doorway& door) noexcept {
  constexpr double beside = 1, behind = 0.5;  // metres
  const Vec2 to = door.middle - stance.at;
  const double along = dot(stance.facing, door.outward);
  if (along >= diagonal - 1e-6) return Side::Ahead;
  if (along <= -diagonal + 1e-6) {
    const double left = dot(to, left_of(stance.facing));
    return left > beside ? Side::BehindLeft : left < -beside ? Side::BehindRight : Side::Behind;
  }
  const bool is_left = cross(stance.facing, door.outward) > 0;
  if (dot(to, stance.facing) < -behind) return is_left ? Side::BehindLeft : Side::BehindRight;
  return is_left ? Side::Left : Side::Right;
}

/// What comes first is counted first.
double order_of(const Stance& stance, const Doorway& door, Side side) noexcept {
  const Vec2 to = door.middle - stance.at;
  switch (side) {
    case Side::Ahead:
      return -dot(to, left_of(stance.facing));
    case Side::Left:
    case Side::Right:
      return dot(to, stance.facing);
    case Side::Behind:
    case Side::BehindLeft:
    case Side::BehindRight:
      break;
  }
  return glm::length(to);
}

/// Which of the doors on its side a doorway is.
DoorStep step_through(const Doorways& doorways, std::uint32_t room, const Stance& stance,
                      const Doorway& exit) {
  DoorStep step{.from = room, .side = side_of(stance, exit)};
  if (!exit.is_door()) return step;
  const double place = order_of(stance, exit, step.side);
  for (const Doorway& door : doorways.of(room)) {
    if (!door.is_door() || &door == stance.entry || side_of(stance, door) != step.side) continue;
    ++step.of;
    if (&door == &exit || order_of(stance, door, step.side) < place) ++step.nth;
  }
  return step;
}

/// How one stands who has come into a room: past the doorway, looking straight in.
Stance stance_in(const Doorways& doorways, const Stay& stay, Vec2 coming) {
  Stance stance{.at = stay.in, .facing = coming};
  stance.entry = doorway_at(doorways, stay.room, stay.in);
  if (stance.entry != nullptr) {
    stance.at = stance.entry->middle;
    stance.facing = -stance.entry->outward;
  }
  return stance;
}

/// Turns of a line without rooms, as one who looks along `facing` at its beginning takes them.
std::vector<Turn> turns_of(std::span<const Vec2> line, Vec2 facing) {
  constexpr double step = 0.5, about = 1.5, apart = 3;  // metres
  constexpr double least = 0.8;                         // radians
  const auto angle_at = [&](double at) {
    const Vec2 here = point_along(line, at);
    const Vec2 before = at < about ? facing : here - point_along(line, at - about);
    const Vec2 after = point_along(line, at + about) - here;
    return std::atan2(cross(before, after), dot(before, after));
  };
  std::vector<Turn> turns;
  const double length = polyline_length(line);
  double last = 0;
  for (double at = 0; at + about <= length; at += step) {
    const double angle = angle_at(at), next = angle_at(at + step);
    if (std::abs(angle) < least || std::abs(next) > std::abs(angle)) continue;
    if (!turns.empty() && at - last < apart) continue;
    const Side side = std::abs(angle) > 3 * glm::quarter_pi<double>() ? Side::Behind
                      : angle > 0                                     ? Side::Left
                                                                      : Side::Right;
    turns.push_back({side, at - last});
    last = at;
  }
  return turns;
}

/// A part along a floor, and how one stands in its last room.
struct Walked {
  FloorPart part;
  Stance stance;
};
Walked walk(const Museum& museum, const Doorways& doorways, const path::Leg& leg,
            const Placement& start) {
  Walked walked{.part = {.floor = leg.floor, .doors = {}, .turns = {}},
                .stance = {.at = start.position, .facing = unit(start.heading)}};
  const auto [stays, outside] = stays_of(museum, leg.floor, leg.points);
  if (stays.empty()) {
    walked.part.turns = turns_of(leg.points, walked.stance.facing);
    return walked;
  }
  const auto leave = [&](const Stay& here, std::uint32_t to) {
    DoorStep step{.from = here.room};
    if (const Doorway* exit = doorway_at(doorways, here.room, here.out); exit != nullptr)
      step = step_through(doorways, here.room, walked.stance, *exit);
    step.to = to;
    walked.part.doors.push_back(step);
  };
  const auto come_into = [&](const Stay& next, Vec2 from) {
    const Vec2 across = next.in - from;
    const double far = glm::length(across);
    walked.stance = stance_in(doorways, next, far > 0 ? across / far : walked.stance.facing);
  };
  const Stay& first = stays.front();
  if (first.outside > unnamed) {
    const std::vector<Vec2> before = beginning_of(leg.points, first.outside);
    walked.part.turns = turns_of(before, walked.stance.facing);
    walked.part.doors.push_back({.to = first.room});
    come_into(first, point_along(leg.points, first.outside - sample));
  } else {
    walked.part.room = first.room;
  }
  for (std::size_t i = 1; i < stays.size(); ++i) {
    const bool by_a_passage = stays[i].outside > unnamed;
    leave(stays[i - 1], by_a_passage ? none : stays[i].room);
    if (by_a_passage) walked.part.doors.push_back({.to = stays[i].room});
    come_into(stays[i], stays[i - 1].out);
  }
  if (outside > unnamed) {
    leave(stays.back(), none);
    const double length = polyline_length(leg.points);
    const Vec2 end = leg.points.back(), before = point_along(leg.points, length - outside / 2);
    const double far = glm::distance(before, end);
    walked.stance = {.at = before, .facing = far > 0 ? (end - before) / far : walked.stance.facing};
  }
  return walked;
}

/// Places that everybody finds: beside them something is found.
constexpr std::array landmarks{PlaceKind::Exit,      PlaceKind::Entrance, PlaceKind::Information,
                               PlaceKind::Tickets,   PlaceKind::Cafe,     PlaceKind::Restaurant,
                               PlaceKind::Shop,      PlaceKind::Lift,     PlaceKind::Stairs,
                               PlaceKind::Cloakroom, PlaceKind::Seat,     PlaceKind::Toilets};

std::uint32_t landmark_of(const Museum& museum, const Goal& goal, std::uint32_t room) {
  constexpr double beside = 3;  // metres
  std::uint32_t nearest = none;
  double least = beside;
  for (std::uint32_t i = 0; i < museum.places.size(); ++i) {
    const Place& place = museum.places[i];
    const double far = glm::distance(place.position, goal.position);
    const bool is_other =
        !goal.place || (i != *goal.place && museum.places[*goal.place].kind != place.kind);
    if (place.floor != goal.floor || !is_other || far >= least) continue;
    if (std::ranges::find(landmarks, place.kind) == landmarks.end()) continue;
    if (room_of(museum, place.floor, place.standing) != room) continue;
    least = far;
    nearest = i;
  }
  return nearest;
}

bool is_in_middle(const Room& room, Vec2 at) noexcept {
  constexpr double share = 0.15;  // of the room, to each side
  Vec2 low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};
  for (const Vec2 corner : room.outline) {
    low = glm::min(low, corner);
    high = glm::max(high, corner);
  }
  const Vec2 size = high - low, off = glm::abs(at - (low + high) / 2.0);
  return off.x < share * size.x && off.y < share * size.y;
}

GoalPart goal_part(const Museum& museum, const Goal& goal, std::uint32_t room,
                   const Stance& stance) {
  GoalPart part{.room = room};
  if (goal.exhibit) {
    const ExhibitPlace place = museum.exhibits[*goal.exhibit].place;
    part.setting = hangs(place)                    ? Setting::OnWall
                   : place == ExhibitPlace::InCase ? Setting::InCase
                                                   : Setting::OnFloor;
  } else {
    part.setting = Setting::Place;
  }
  part.beside = landmark_of(museum, goal, room);
  if (room != none && is_in_middle(museum.rooms[room], goal.position)) {
    part.where = Where::Middle;
    return part;
  }
  constexpr double ahead = glm::pi<double>() / 6, behind = 0.75 * glm::pi<double>();
  const Vec2 to = goal.position - stance.at;
  const double angle = std::atan2(cross(stance.facing, to), dot(stance.facing, to));
  part.where = std::abs(angle) <= ahead    ? Where::Ahead
               : std::abs(angle) >= behind ? Where::Behind
               : angle > 0                 ? Where::Left
                                           : Where::Right;
  return part;
}

RideStep ride_of(const Museum& museum, const path::Leg& leg) {
  return {.kind = museum.connections[leg.connection].kind,
          .up = museum.floors[leg.to_floor].plan.ordinal > museum.floors[leg.floor].plan.ordinal,
          .floor = leg.to_floor};
}

/// How one comes out of a connection.
Placement out_of(const Connection& connection, std::uint32_t floor) {
  for (const ConnectionStop& stop : connection.stops)
    if (stop.floor == floor)
      return {stop.placement.position, stop.placement.heading + glm::pi<double>()};
  return {};
}

}  // namespace

std::optional<Directions> direct(const Museum& museum, const Doorways& doorways,
                                 const Placement& start, const path::BuildingWay& way,
                                 const Goal& goal) {
  if (way.status != path::BuildingStatus::Ok || way.legs.empty()) return {};
  Directions directions;
  directions.metres = way.length;
  directions.seconds = way.seconds;
  Placement from = start;
  Stance stance;
  for (const path::Leg& leg : way.legs) {
    if (leg.is_along_floor()) {
      Walked walked = walk(museum, doorways, leg, from);
      stance = walked.stance;
      directions.parts.push_back(std::move(walked.part));
      continue;
    }
    if (directions.parts.empty()) return {};
    const Connection& connection = museum.connections[leg.connection];
    directions.parts.back().then = ride_of(museum, leg);
    directions.step_free = directions.step_free && connection.step_free;
    from = out_of(connection, leg.to_floor);
  }
  directions.goal = goal_part(museum, goal, directions.parts.back().last_room(), stance);
  return directions;
}

}  // namespace docent::directions
