#pragma once

#include <cstdint>

#include "runtime/guide/avatar.h"
#include "runtime/model/geometry/floor_plan.h"
#include "runtime/scene/draw_list.h"

namespace docent::film {

/// From where a guide is filmed. `Kiosk` is the camera that a visitor at the glass looks through.
enum class View : std::uint8_t { Front, Side, Back, Above, Kiosk };

/// Which way such a camera looks along with a body that faces `heading`, radians, floor frame.
double camera_yaw(View view, double heading) noexcept;

/// How steeply it looks down, radians, from `yaw`: level with the body, or so steeply that no wall
/// of the plan, cut as the model's are, hides the feet; but at most 63 degrees.
double camera_pitch(View view, const FloorPlan& plan, Vec2 body, double yaw) noexcept;

/// The camera of a view; the whole body is in its picture. A visitor's has a pitch of its own.
scene::CameraView camera_on(const guide::Avatar& avatar, View view, double yaw, double pitch,
                            float aspect);

}  // namespace docent::film
