#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "tests/runtime/guide/situation.h"
#include "tests/support/halls.h"

namespace docent::test {

/// The situations that people on narrow floors have to get out of (body radius 0.25 m).

inline Placement at(double x, double y, double degrees = 0) {
  return {{x, y}, degrees * std::numbers::pi / 180};
}

inline Situation head_on_in_a_corridor() {
  HallMaker hall;
  hall.room({0, 0}, {14, 1.4});
  return {hall.plan, {{at(1, 0.7), at(13, 0.7)}, {at(13, 0.7, 180), at(1, 0.7, 180)}}, 60};
}

/// Two rooms of 5 by 5 m with a door in the wall between them.
inline FloorPlan two_rooms_with_a_door(double width, bool second_door = false) {
  HallMaker hall;
  const double low = 2.5 - width / 2, high = 2.5 + width / 2;
  hall.room({0, 0}, {10.2, 5});
  if (second_door) {
    hall.block({5, 1}, {5.2, low}).block({5, high}, {5.2, 5});
    hall.plan.vertex.clear();
    hall.plan.ring.clear();
    hall.plan.next.clear();
    const Vec2 outline[] = {{0, 0},      {10.2, 0}, {10.2, 5}, {5.2, 5},
                            {5.2, high}, {5, high}, {5, 5},    {0, 5}};
    hall.ring(outline).block({5, 1.2}, {5.2, low});
    return hall.plan;
  }
  const Vec2 outline[] = {{0, 0},    {5, 0},   {5, low},    {5.2, low}, {5.2, 0}, {10.2, 0},
                          {10.2, 5}, {5.2, 5}, {5.2, high}, {5, high},  {5, 5},   {0, 5}};
  HallMaker rooms;
  rooms.ring(outline);
  return rooms.plan;
}

inline Situation head_on_in_a_doorway() {
  return {two_rooms_with_a_door(0.9),
          {{at(2, 2.5), at(8, 2.5)}, {at(8.2, 2.5, 180), at(2.2, 2.5, 180)}},
          60};
}

inline Situation four_ways() {
  HallMaker hall;
  hall.room({0, 0}, {10, 10});
  return {hall.plan,
          {{at(1, 5), at(9, 5)},
           {at(9, 5, 180), at(1, 5, 180)},
           {at(5, 1, 90), at(5, 9, 90)},
           {at(5, 9, -90), at(5, 1, -90)}},
          60};
}

/// Six on either side want to the other.
inline Situation twelve_through_a_doorway() {
  Situation it{two_rooms_with_a_door(0.9), {}, 180};
  for (int i = 0; i < 6; ++i) {
    const double x = 1 + 1.2 * (i % 3), y = i < 3 ? 1.2 : 3.8;
    it.parts.push_back({at(x, y), at(10.2 - x, 5 - y)});
    it.parts.push_back({at(10.2 - x, y, 180), at(x, 5 - y, 180)});
  }
  return it;
}

inline Situation overtaking() {
  HallMaker hall;
  hall.room({0, 0}, {24, 2.4});
  return {hall.plan,
          {{at(3, 1.2), at(22, 1.2), RouteKind::Shortest, 0.45}, {at(1, 1.2), at(23, 1.2)}},
          90};
}

/// Somebody stands in the nearer door for good; there is another.
inline Situation one_in_the_way() {
  Situation it{two_rooms_with_a_door(0.9, true), {{at(3, 2.5), at(7.5, 2.5)}}, 90};
  Part stander{at(5.1, 2.5), at(5.1, 2.5)};
  stander.stays = true;
  it.parts.push_back(stander);
  return it;
}

inline Situation ring_of_sixteen() {
  HallMaker hall;
  hall.room({0, 0}, {14, 14});
  Situation it{hall.plan, {}, 120};
  for (int i = 0; i < 16; ++i) {
    const double degrees = 22.5 * i, a = degrees * std::numbers::pi / 180;
    const Vec2 from = Vec2(7, 7) + 5.5 * Vec2(std::cos(a), std::sin(a)), to = Vec2(14, 14) - from;
    it.parts.push_back({{from, a + std::numbers::pi}, {to, a + std::numbers::pi}});
  }
  return it;
}

}  // namespace docent::test
