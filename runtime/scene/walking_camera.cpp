#include "runtime/scene/walking_camera.h"

#include <cmath>

namespace docent::scene {
namespace {

constexpr double turn_time_constant = 0.7;  ///< The camera turns slower than the guide...
constexpr double most_turn = 1.2;           ///< ... and never faster than 69 degrees a second.
constexpr double move_time_constant = 0.3;

}  // namespace

void WalkingCamera::cut(const Walker& walker, const Rect& free, float aspect) noexcept {
  yaw_ = yaw_towards(walker, walker.body.heading);
  keep(behind(walker, yaw_, free, aspect), free);
}

void WalkingCamera::advance(const Walker& walker, const Rect& free, float aspect,
                            float seconds) noexcept {
  yaw_ = turn_smoothly(yaw_, yaw_towards(walker, walker.body.heading), seconds, turn_time_constant,
                       most_turn);
  const CameraRig wanted = behind(walker, yaw_, free, aspect);
  const double share = 1 - std::exp(-seconds / move_time_constant);
  CameraRig now = rig(walker, free);
  now.distance += (wanted.distance - now.distance) * share;
  now.centre_x += (wanted.centre_x - now.centre_x) * static_cast<float>(share);
  now.centre_y += (wanted.centre_y - now.centre_y) * static_cast<float>(share);
  keep(with_all_in_view(now, walker, free, aspect), free);
}

void WalkingCamera::keep(const CameraRig& rig, const Rect& free) noexcept {
  distance_ = rig.distance;
  right_ = (rig.centre_x - free.x) / free.width;
  down_ = (rig.centre_y - free.y) / free.height;
}

CameraRig WalkingCamera::rig(const Walker& walker, const Rect& free) const noexcept {
  CameraRig rig = close_behind(walker, yaw_, free);
  rig.distance = distance_;
  rig.centre_x = free.x + static_cast<float>(right_) * free.width;
  rig.centre_y = free.y + static_cast<float>(down_) * free.height;
  return rig;
}

}  // namespace docent::scene
