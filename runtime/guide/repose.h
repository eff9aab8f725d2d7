#pragma once

#include "runtime/guide/avatar.h"

namespace docent::guide {

/// How much of their time passes for those on the model, where a machine has no time to draw them
/// beside a video: the guide ends what it is doing, slows down within a second and stands as still
/// as a model does; afterwards it breathes on from that very breath. So nobody sees it jerk.
class Repose {
 public:
  /// One step of time: the share of it that is theirs, 0 to 1. `is_asked`: they are to keep still.
  float step(bool is_asked, const Avatar& guide, float seconds) noexcept;
  /// That share in the last step.
  float share() const noexcept;

 private:
  float awake_ = 1;
};

}  // namespace docent::guide
