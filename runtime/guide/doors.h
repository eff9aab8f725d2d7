#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "runtime/guide/crowd.h"
#include "runtime/model/geometry/hung_leaf.h"
#include "runtime/model/museum.h"
#include "runtime/scene/draw_list.h"

namespace docent::guide {

/// Where on a leaf's bar a hand is.
struct Grasp {
  Side side = Side::Right;  ///< The hand.
  double along = 0.5;       ///< Metres from the hinge.
};

/// A leaf of a door, as it is now.
struct Leaf {
  std::uint32_t floor = 0, door = 0;  ///< Indices: of the museum's floors, of the floor's doors.
  DoorOpens opens = DoorOpens::Push;
  HungLeaf hung;
  double angle = 0;     ///< Radians; positive to the left of the door's line from a to b.
  double slid = 0;      ///< Metres, of a sliding one, towards its hinges.
  double rate = 0;      ///< Radians a second, of a leaf that closes.
  double unused = 1e9;  ///< Seconds since somebody was near it.

  /// Who pushes it, if somebody does.
  struct Push {
    std::uint32_t who = 0;
    double sign = 1;               ///< Of the angle to which it is turned.
    std::optional<Grasp> grasp{};  ///< None where no hand reaches it all the while.
    double needed = 0;             ///< Radians that who pushes it has needed so far.
    double since = 0;              ///< Seconds.
  };
  std::optional<Push> push{};
};

/// The leaves of all doors that staff have marked. Whoever goes through one that is closed turns it
/// with a hand on its bar and walks on; it is always turned far enough for who walks there. Whoever
/// comes next finds it open; when nobody has been near it for a while it closes by itself. One that
/// slides, or would have to be pulled, opens by itself before whoever comes.
///
/// Called by the frame thread. Only the constructor allocates.
class Doors {
 public:
  explicit Doors(const Museum& museum);

  /// Before the crowd's step of the same time: turns the leaves to where they are at its end, and
  /// sends hands there.
  void step(double seconds, Crowd& crowd) noexcept;

  const std::vector<Leaf>& leaves() const noexcept { return leaves_; }
  /// Appends the leaves of a floor.
  void draw(std::uint32_t floor, scene::DrawList& list) const noexcept;

 private:
  void begin_push(double seconds, Leaf& leaf, const Crowd& crowd) noexcept;
  void turn(double seconds, Leaf& leaf, Crowd& crowd) noexcept;
  bool is_awaited(double seconds, const Leaf& leaf, const Crowd& crowd) const noexcept;
  void close(double seconds, Leaf& leaf, const Crowd& crowd) noexcept;

  const Museum& museum_;
  std::vector<Leaf> leaves_;
};

/// Where on its bar a leaf is held, and what a hand there does: the palm lies on the bar.
motion::Grip grip_of(const Leaf& leaf, const Leaf::Push& push, double floor_height) noexcept;

}  // namespace docent::guide
