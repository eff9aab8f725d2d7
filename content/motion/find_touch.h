#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "runtime/model/museum.h"
#include "runtime/motion/touch.h"

namespace docent::motion::offline {

/// What a hand may lie on, or not go through. World frame, wound either way.
using Triangle = std::array<Vec3, 3>;

/// What is drawn of an exhibit: its object, or its picture and what that stands on.
std::vector<Triangle> touch_surface(const Museum& museum, std::uint32_t exhibit);

/// What else is drawn of the building and of other exhibits, within an arm's length of that.
std::vector<Triangle> things_around(const Museum& museum, std::uint32_t exhibit);

/// Metres from a point to the nearest of them; infinite where there is none.
float distance_to(std::span<const Triangle> surface, Vec3 point) noexcept;

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
  std::span<const Triangle> around;    ///< What else is there.
  double ground = 0;                   ///< World y of the floor.
  Placement view;                      ///< Where visitors stand to look at it.
  Vec2 middle{};                       ///< Of what is touched, floor frame.
  std::function<bool(Vec2)> has_room;  ///< May a body stand there? Floor frame.
};

/// Where on the one side of the line of sight somebody stands who touches it, and how: so that the
/// palm lies on it for bodies of all builds, though they sway, no joint is bent beyond what people
/// can, and neither arm nor head and trunk go through anything on the way there. None where there
/// is no such place. Allocates, and takes up to a second.
std::optional<Touch> find_touch(const TouchSearch& search, Side beside);

}  // namespace docent::motion::offline
