#pragma once

#include <cstdint>
#include <vector>

#include "runtime/guide/doors.h"

namespace docent::guide::test {

/// One of the sample museum's doors, hung and opened in some way, and places on either side of it.
struct Doorway {
  Museum museum;
  std::uint32_t floor = 0, door = 0;
  [[nodiscard]] const Door& it() const { return museum.floors[floor].plan.doors[door]; }
  /// `metres` from the door (to the left of its line: positive) and `along` it from its middle.
  [[nodiscard]] Placement place(double metres, double along, double towards) const;
};
Doorway doorway(DoorOpens opens, DoorHinge hinge = DoorHinge::Both, double width = 2);

/// Two rooms with a wall between them, the door of its whole width in it; nothing else is there.
/// How far it is from either side of the doorway to the rooms' walls beside it.
struct Beside {
  double a = 2, b = 2;
};
Doorway walled_doorway(DoorOpens opens, DoorHinge hinge, double width, const Beside& beside = {});

/// How far a leaf is open: radians or metres.
double amount_of(const Leaf& leaf);

/// What was seen of somebody who walked through.
struct Passage {
  double farthest_hand = 0;     ///< Metres from the bar of a leaf that a hand moved, ...
  double by_hand = 0;           ///< ... radians or metres that one did, of one leaf, ...
  double before_hand = 0;       ///< ... that it opened before there was a hand on it, ...
  double turned_by_itself = 0;  ///< ... and that leaves opened without one.
  double ahead_of_hand = 0;  ///< Radians that a leaf went ahead of the hand of who pushes it, ...
  double nearest = 1e9;      ///< Metres between bones and leaves, less their thickness.
  double most_open = 0;      ///< Radians or metres.
  double held_seconds = 0;
  double hardest = 0;              ///< The largest change of a leaf's rate between two frames.
  bool hand_went_through = false;  ///< Of a leaf: an elbow, a wrist or a finger.
  double fastest_hand = 0;         ///< Metres a second, of any part of an arm from the elbow down.
  double feet_slid = 0;  ///< Metres that a foot moved while its owner stood with a hand on it.
  double seconds = 0;
  bool arrived = false;
};

class Walker {
 public:
  explicit Walker(const Doorway& doorway, std::size_t agents = 1);

  std::uint32_t enters(const Placement& at) { return crowd.add(doorway_.floor, at, 100, 1); }
  /// Steps until it has arrived.
  Passage walk(std::uint32_t who, const Placement& to, double frame = 1.0 / 60,
               double patience = 30);
  void step(std::uint32_t who, double frame, Passage& seen);

 private:
  double palm_to_bar(const Avatar& avatar, Side side, const Leaf& leaf) const;
  bool is_pushed_by_hand(const Leaf& leaf) const;
  void look_at_feet(const Avatar& avatar, Passage& seen);
  void look_at_arms(const Avatar& avatar, const std::vector<bool>& is_arm, double frame,
                    Passage& seen);

  const Doorway& doorway_;
  plan::Planner planner_;
  std::vector<double> rates_;
  std::vector<double> arm_side_;  ///< By leaf and joint: where the leaf is beside it, metres; or 0.
  std::vector<Vec3> hands_;
  std::vector<Vec3> feet_;  ///< Where they were when it came to stand.

 public:
  Doors doors;
  Crowd crowd;
};

}  // namespace docent::guide::test
