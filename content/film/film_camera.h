#pragma once

#include <cstdint>

#include "runtime/guide/avatar.h"
#include "runtime/scene/draw_list.h"

namespace docent::film {

/// From where a guide is filmed. `Kiosk` is the camera that a visitor at the glass looks through.
enum class View : std::uint8_t { Front, Side, Back, Above, Kiosk };

/// Which way such a camera looks along with a body that faces `heading`, radians, floor frame.
double camera_yaw(View view, double heading) noexcept;

/// The camera of a view that looks the way `yaw`; the whole body is in its picture.
scene::CameraView camera_on(const guide::Avatar& avatar, View view, double yaw, float aspect);

}  // namespace docent::film
