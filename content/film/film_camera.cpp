#include "content/film/film_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "content/scenery/furniture.h"
#include "runtime/scene/camera.h"

namespace docent::film {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double body_middle = 0.9;                                // metres
constexpr double distance = 4.4;                                   // metres
constexpr double level = 0.15, steepest = 1.1, from_above = 1.35;  // radians
constexpr double ahead_step = 0.5;  // metres between the points of the way that have to be seen

/// The visitor's camera keeps the next metres of the way in its picture.
scene::CameraRig kiosk_rig(const guide::Avatar& avatar, double yaw, float aspect) {
  std::vector<Vec2> ahead;
  for (double on = ahead_step; on <= scene::view_ahead; on += ahead_step)
    ahead.push_back(point_along(*avatar.plan, avatar.along + on));
  return scene::behind({avatar.body, avatar.height, ahead}, yaw, {0, 0, 1, 1}, aspect);
}

/// How far along the segment p q it meets the segment a b: below 1; else 1.
double crossing(Vec2 p, Vec2 q, Vec2 a, Vec2 b) noexcept {
  const Vec2 way = q - p, side = b - a;
  const double turn = cross(way, side);
  if (turn == 0) return 1;
  const double share = cross(a - p, side) / turn, at = cross(a - p, way) / turn;
  return share > 0 && share < 1 && at >= 0 && at <= 1 ? share : 1;
}

}  // namespace

double camera_yaw(View view, double heading) noexcept {
  if (view == View::Front) return heading + pi;
  return view == View::Side ? heading + pi / 2 : heading;
}

double camera_pitch(View view, const FloorPlan& plan, Vec2 body, double yaw) noexcept {
  if (view == View::Above) return from_above;
  const Vec2 eye = body - distance * Vec2{std::cos(yaw), std::sin(yaw)};
  double pitch = level;
  for (std::uint32_t wall = 0; wall < plan.next.size(); ++wall) {
    const double share = crossing(body, eye, wall_start(plan, wall), wall_end(plan, wall));
    if (share < 1) pitch = std::max(pitch, std::atan2(cut_height, share * distance));
  }
  return std::min(pitch, steepest);
}

scene::CameraView camera_on(const guide::Avatar& avatar, View view, double yaw, double pitch,
                            float aspect) {
  if (view == View::Kiosk) return scene::view_of(kiosk_rig(avatar, yaw, aspect), aspect);
  scene::CameraRig rig;
  rig.target = to_world(avatar.body.position, avatar.height + body_middle);
  rig.yaw = yaw;
  rig.pitch = pitch;
  rig.distance = distance;
  return scene::view_of(rig, aspect);
}

}  // namespace docent::film
