#pragma once

#include "runtime/scene/camera.h"

namespace docent::scene {

/// The camera that goes along behind the guide: always on its way to where `behind` would have it.
class WalkingCamera {
 public:
  /// There at once: whatever is to be seen is.
  void cut(const Walker& walker, const Rect& free, float aspect) noexcept;
  /// One step of time: it turns and backs off no faster than is pleasant.
  void advance(const Walker& walker, const Rect& free, float aspect, float seconds) noexcept;

  CameraRig rig(const Walker& walker, const Rect& free) const noexcept;
  double yaw() const noexcept { return yaw_; }

 private:
  void keep(const CameraRig& rig, const Rect& free) noexcept;

  double yaw_ = 0, distance_ = 9;
  double right_ = 0.5, down_ = 0.7;  ///< Where the guide is in the free part.
};

}  // namespace docent::scene
