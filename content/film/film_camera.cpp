#include "content/film/film_camera.h"

#include <numbers>
#include <vector>

#include "runtime/scene/camera.h"

namespace docent::film {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double body_middle = 0.9;  // metres
constexpr double ahead_step = 0.5;   // metres between the points of the way that have to be seen

/// The visitor's camera keeps the next metres of the way in its picture.
scene::CameraRig kiosk_rig(const guide::Avatar& avatar, double yaw, float aspect) {
  std::vector<Vec2> ahead;
  for (double on = ahead_step; on <= scene::view_ahead; on += ahead_step)
    ahead.push_back(point_along(*avatar.plan, avatar.along + on));
  return scene::behind({avatar.body, avatar.height, ahead}, yaw, {0, 0, 1, 1}, aspect);
}

}  // namespace

double camera_yaw(View view, double heading) noexcept {
  if (view == View::Front) return heading + pi;
  return view == View::Side ? heading + pi / 2 : heading;
}

scene::CameraView camera_on(const guide::Avatar& avatar, View view, double yaw, float aspect) {
  if (view == View::Kiosk) return scene::view_of(kiosk_rig(avatar, yaw, aspect), aspect);
  scene::CameraRig rig;
  rig.target = to_world(avatar.body.position, avatar.height + body_middle);
  rig.yaw = yaw;
  rig.pitch = view == View::Above ? 1.35 : 0.15;
  rig.distance = 4.4;
  return scene::view_of(rig, aspect);
}

}  // namespace docent::film
