#pragma once

#include "runtime/interface/measures.h"
#include "runtime/scene/camera.h"
#include "runtime/scene/draw_list.h"

namespace docent::guide {

/// Millimetres of a shared glass that everybody on its model is tall, at least: from an arm's
/// length away a figure is found by its colours.
inline constexpr float least_stature_mm = 25;

/// How much larger than life somebody is drawn who stands at `ground` (world frame); 1 where they
/// are tall enough.
float stature_scale(const scene::CameraView& camera, const interface::ScreenShape& shape,
                    Vec3 ground) noexcept;

/// How far a place on the glass is from the figure of somebody who stands at `ground`: millimetres;
/// 0 or less on it.
float millimetres_to_figure(const scene::CameraView& camera, const interface::ScreenShape& shape,
                            Vec3 ground, scene::ScreenPoint at) noexcept;
/// So near, a finger means it.
inline constexpr float nearly_on_figure = 4;

/// Makes the last avatar of the list so much larger, from the ground on which it stands. Does not
/// allocate.
void enlarge_last(Vec3 ground, float scale, scene::DrawList& list) noexcept;

}  // namespace docent::guide
