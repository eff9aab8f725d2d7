#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "runtime/model/museum.h"
#include "runtime/motion/arm.h"

namespace docent::motion {

/// What a hand may lie on. World frame, counter-clockwise from outside.
using Triangle = std::array<Vec3, 3>;

/// What is drawn of an exhibit: its object, or its picture and what that stands on.
std::vector<Triangle> touch_surface(const Museum& museum, std::uint32_t exhibit);

/// Metres from a point to the nearest of them; infinite where there is none.
float distance_to(std::span<const Triangle> surface, Vec3 point) noexcept;

/// A body that stands, and where the trunks of its arms are then (by Side). World frame.
struct Stance {
  Placement body;
  double height = 0;  ///< World y of the ground.
  std::array<JointPlace, 2> trunk{};
  Vec3 waist{};  ///< About which the trunk leans.
};
/// The same, standing somewhere else.
Stance moved_to(const Stance& stance, const Placement& body, double height) noexcept;

/// The same with the trunk leaning forwards by so many radians.
Stance leaned(const Stance& stance, float lean) noexcept;

/// Bends a pose forwards at the waist; legs stay as they are.
void lean_forwards(const Skeleton& skeleton, float lean, PoseView& pose) noexcept;

/// A hand laid on something from where the body stands. World frame.
struct Touch {
  Placement body;
  Side side = Side::Right;
  Grip grip;       ///< The palm on the surface.
  Vec3 normal{};   ///< Out of the surface there.
  Vec3 ready{};    ///< Before the body, from where the palm goes to the surface and to where it
                   ///< comes back.
  float lean = 0;  ///< Radians, of the trunk: 0 to 0.3.
};

/// Metres between the middle of a palm and what it lies on: half a hand's thickness.
inline constexpr float half_a_palm = 0.012F;
/// Metres by which a hand may miss at most what it touches.
inline constexpr float touches_within = 0.02F;

/// What a touch is looked for with.
struct TouchSearch {
  const Skeleton& skeleton;
  const Arms& arms;
  const Stance& stance;  ///< Anywhere.
  std::span<const Triangle> surface;
  double ground = 0;                   ///< World y of the floor.
  Placement view;                      ///< Where visitors stand to look at it.
  Vec2 middle{};                       ///< Of what is touched, floor frame.
  std::function<bool(Vec2)> has_room;  ///< May a body stand there? Floor frame.
};

/// Where on the one side of the line of sight somebody stands who touches it, and how: so that the
/// palm lies on it for bodies of all builds, though they sway, no joint is bent beyond what people
/// can, and the arm nowhere goes through it. None where there is no such place. Allocates.
std::optional<Touch> find_touch(const TouchSearch& search, Side beside);

/// The same for an exhibit of a museum. `stance`: of somebody with these arms, anywhere. `map`: of
/// its floor (path::FloorMap).
template <typename Map>
std::optional<Touch> find_touch(const Museum& museum, const Arms& arms, const Stance& stance,
                                std::uint32_t exhibit, const Map& map, Side beside) {
  constexpr double room = 0.02;  // metres more than the body's radius
  constexpr double narrow = 0.1;
  const Exhibit& it = museum.exhibits[exhibit];
  const std::vector<Triangle> surface = touch_surface(museum, exhibit);
  const Vec2 view = it.viewing_point.position;
  const auto has_room = [&](Vec2 at) {
    return map.has_room(at, museum.body_radius + room) &&
           map.walls().capsule_clear(view, at, narrow);
  };
  return find_touch({.skeleton = museum.motion.skeleton,
                     .arms = arms,
                     .stance = stance,
                     .surface = surface,
                     .ground = museum.floors[it.floor].plan.height,
                     .view = it.viewing_point,
                     .middle = it.object >= 0 ? it.stand.position : it.placement.position,
                     .has_room = has_room},
                    beside);
}

/// Seconds that a touch takes, from a hanging hand to `ready` again...
inline constexpr double touch_seconds = 6.2;
/// ... and from when to when the palm is on the surface.
inline constexpr double touch_begins = 2.1, touch_ends = 5.2;

/// Where the hand is to be so many seconds after it was first sent there: to `ready`, along an arc
/// onto the surface, where it rests, and back.
Grip grip_after(const Touch& touch, double seconds) noexcept;
/// How far the trunk leans forwards then.
float lean_after(const Touch& touch, double seconds) noexcept;

}  // namespace docent::motion
