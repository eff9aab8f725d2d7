#pragma once

#include <optional>
#include <span>

#include "runtime/model/geometry/vec2.h"
#include "runtime/scene/draw_list.h"

namespace docent::scene {

/// How the camera stands: what it looks at, from where, and where on the screen that appears.
/// Blending two of these component by component is a smooth flight above the walls.
struct CameraRig {
  Vec3 target{};         ///< World frame.
  double yaw = 0;        ///< Radians, floor frame: the direction that is up on the screen.
  double pitch = 0.87;   ///< Radians below the horizon.
  double distance = 10;  ///< Metres from the target.
  float centre_x = 0.5F, centre_y = 0.5F;  ///< Screen frame: where the target appears.
  float vertical_fov = 0.5236F;            ///< Radians, of the whole screen's height.
};

/// The vertical field of view of the whole screen, radians, such that `free`, the part left to the
/// model, sees 30 degrees of height, as through a long lens.
float field_of_view(const Rect& free) noexcept;

/// Nothing that the camera looks over is higher than this, metres: walls are cut at shoulder
/// height, and an eye above it can be in no wall.
inline constexpr double tallest_thing = 2.4;

CameraView view_of(const CameraRig& rig, float aspect) noexcept;

/// The rig `share` of the way from one to the other, turning by the shorter way.
CameraRig blend(const CameraRig& from, const CameraRig& to, double share) noexcept;

/// Where a world point appears, screen frame; none for a point behind the eye.
struct ScreenPoint {
  float x = 0, y = 0;
};
std::optional<ScreenPoint> project(const CameraView& view, Vec3 point) noexcept;

/// The point at a height (world y) that a point of the screen shows; none where that is behind the
/// eye, or above the horizon.
std::optional<Vec3> point_at_height(const CameraView& view, ScreenPoint at, float height) noexcept;

/// The whole floor, with the direction `yaw` up, as large as fits into `free` (screen frame).
CameraRig overview_of(std::span<const Vec2> outline, double height, double yaw, const Rect& free,
                      float aspect) noexcept;

/// What the walking camera follows.
struct Walker {
  Placement body;
  double height = 0;             ///< Of the floor, metres.
  std::span<const Vec2> ahead;   ///< The next metres of the way, nearest first; may be empty.
  std::span<const Vec3> goal{};  ///< World frame: what else has to be in the picture.
};

/// The distance along the way that is always in view, metres.
inline constexpr double view_ahead = 6;

/// Behind and above the guide, from nearby, whatever else there is to be seen.
CameraRig close_behind(const Walker& walker, double yaw, const Rect& free) noexcept;

/// Behind and above the guide, looking the way it is going: where the camera would be at rest. The
/// guide from head to foot, the way ahead and the goal are in the free part of the picture.
CameraRig behind(const Walker& walker, double yaw, const Rect& free, float aspect) noexcept;

/// The yaw that shows where the walker goes next.
double yaw_towards(const Walker& walker, double otherwise) noexcept;

/// How far the camera looks aside, on arrival, from the way in which one looks at an exhibit:
/// radians.
inline constexpr double arrival_turn = 0.42;

/// A rig of that camera backs off and moves its picture as little as puts all of that into the free
/// part.
CameraRig with_all_in_view(CameraRig rig, const Walker& walker, const Rect& free,
                           float aspect) noexcept;

/// Looks the way `yaw` over who stands there, with the exhibit in the upper third of `free`.
CameraRig beside(Vec2 standing, Vec2 exhibit, double yaw, double height, const Rect& free,
                 float aspect) noexcept;

/// Looks the way `yaw` at an object from so near that it takes half of `free`, whichever way it is
/// turned: small ones through a longer lens and not from nearer than a person would. `foot` is in
/// the world frame, `size` metres.
CameraRig close_up(Vec3 foot, Vec3 size, double yaw, const Rect& free, float aspect) noexcept;

/// The angle `current` moved towards `wanted`, exponentially with `time_constant` (seconds), by at
/// most `max_rate` radians a second.
double turn_smoothly(double current, double wanted, double seconds, double time_constant,
                     double max_rate) noexcept;

/// `angle` brought to (-pi, pi].
double wrapped(double angle) noexcept;
/// 0 to 1, slow at both ends.
double smooth_step(double share) noexcept;
/// 0 to 1, quick at the beginning and slow at the end.
double ease_out(double share) noexcept;

}  // namespace docent::scene
