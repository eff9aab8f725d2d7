#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "runtime/guide/crowd.h"
#include "runtime/guide/door_stop.h"
#include "runtime/guide/leaf_grip.h"
#include "runtime/model/geometry/hung_leaf.h"

namespace docent::guide {

/// A leaf of a door, as it is now.
struct Leaf {
  std::uint32_t floor = 0, door = 0;  ///< Indices: of the museum's floors, of the floor's doors.
  DoorOpens opens = DoorOpens::Push;
  HungLeaf hung;
  double angle = 0;     ///< Radians; positive to the left of the door's line from a to b.
  double slid = 0;      ///< Metres, of a sliding one, towards its hinges.
  double rate = 0;      ///< Radians a second, or metres, of a leaf that closes.
  double unused = 1e9;  ///< Seconds since somebody was near it.

  /// Who pushes it, if somebody does.
  struct Push {
    std::uint32_t who = 0;
    double sign = 1;               ///< Of the angle to which it is turned.
    std::optional<Grasp> grasp{};  ///< None where no hand reaches it all the while.
    double needed = 0;             ///< Radians that who pushes it has needed so far.
    double since = 0;              ///< Seconds.
    double rate = 0;               ///< Radians a second.
    bool waits = false;            ///< For the hand, or goes after it.
    double apart = 0;              ///< Seconds for which the hand has not reached it.
  };
  std::optional<Push> push{};

  /// For whom a place is looked for to stop before it, some places a frame.
  struct Search {
    std::uint32_t who = 0;
    double sign = 1;  ///< Of the side from which they come.
    double passed_at = 0;
    Vec2 comes_from{};
    double faces = 0;  ///< Heading.
    std::size_t looked_at = 0;
    std::optional<DoorStop> best{};
    std::optional<DoorStop> straight{};  ///< The best of those that are nearly straight ahead.
  };
  std::optional<Search> search{};

  /// Who stops before it to pull it open, or slide it.
  struct Drawing {
    std::uint32_t who = 0;
    double sign = 1;  ///< Of the side on which they stand.
    DoorStop stop;
    std::optional<DoorStop> other{};  ///< Where the way to the first takes too long.
    bool has_come = false;
    double since = 0;  ///< Seconds on their way; once they have come, since then.
    double moved = 0;  ///< Seconds for which it has moved, ...
    double pace = 0;   ///< ... this much slower at the moment, where somebody is in its way.
    double parts = 0;  ///< Seconds since the hand has begun to come away from it.
  };
  std::optional<Drawing> drawing{};
  bool swings_open = false;  ///< A hand has let go of it, and it goes on, ...
  double waits = 0;          ///< ... after so many seconds, when the arm is out of its way.
  std::optional<std::uint32_t> lets{};  ///< Before whom it opens by itself.
};

/// The next moments of somebody on their way.
struct Foresight {
  static constexpr double seconds = 3.4;
  static constexpr std::size_t looks = 69;
  static constexpr double apart = seconds / (looks - 1);
  std::array<Placement, looks> place;
};
/// `from`: seconds from now.
Foresight foresee(const Avatar& avatar, double from) noexcept;

/// Where and when somebody crosses a leaf's line.
struct LeafPassing {
  double along = 0;    ///< Metres from the hinge.
  double seconds = 0;  ///< From now on.
};
inline constexpr double walking_pace = 1.25;  ///< Metres a second, about.
/// Within so many seconds from now on.
std::optional<LeafPassing> passing_within(double seconds, const Leaf& leaf,
                                          const Avatar& avatar) noexcept;
/// Does somebody pass it, or graze it?
bool passes(const Leaf& leaf, const Foresight& ahead) noexcept;

/// Is somebody here, and so near to its middle?
bool is_near(const Leaf& leaf, const Agent& one, double metres) noexcept;
inline constexpr double near_a_leaf = 3;  ///< Metres from which on who comes is looked at, ...
inline constexpr double drawn_from = 4.2, drawn_ahead = 5;  ///< ... and seconds, where it is drawn.

/// On which side of the door: 1 to the left of its line from a to b, else -1.
double side_of(const Leaf& leaf, Vec2 place) noexcept;
/// Radians, or metres of one that slides.
double opening_of(const Leaf& leaf) noexcept;
void set_opening(double opening, Leaf& leaf) noexcept;
/// Of who comes from there: it slides, or it would have to be pulled.
bool is_drawn(const Leaf& leaf, Vec2 from) noexcept;
/// As far as it opens by itself.
double full_opening(const Leaf& leaf) noexcept;
/// It opens on, or by itself, gently; `speed`: radians or metres a second, at most.
void open_on(double seconds, double speed, Leaf& leaf) noexcept;

}  // namespace docent::guide
