#pragma once

#include <span>

#include "runtime/scene/camera.h"

namespace docent::scene {

/// Something that is looked at: an upright box, world frame.
struct Thing {
  Vec3 low{}, high{};
};

/// How far a thing stays from what could cover it, and from the edges: a share of the screen's
/// height.
inline constexpr float clear_margin = 0.012F;

/// The box on the screen that a thing is seen in; empty where some of it is behind the eye.
Rect seen_box(const CameraView& view, const Thing& thing) noexcept;

/// A rig moves its picture as little as brings all things into the free part and out from under the
/// boards that lie on it (both in the screen frame). Where there is no room for that, it backs off
/// first; where there is none from afar either, it stays as it is. Does not allocate.
CameraRig clear_of_boards(const CameraRig& rig, std::span<const Thing> things,
                          std::span<const Rect> boards, const Rect& free, float aspect) noexcept;

}  // namespace docent::scene
