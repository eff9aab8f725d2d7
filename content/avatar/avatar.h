#pragma once

#include "content/avatar/figure.h"
#include "runtime/model/motion/skeleton.h"
#include "runtime/model/motion/skinned_mesh.h"

namespace docent::avatar {

/// The guide's body, made to measure for a skeleton: a person in a knee-length coat, modelled as
/// distance fields round the bones, polygonised, shaded with ambient occlusion and bound to the
/// joints.
///
/// The skeleton names its hips, knees, ankles, toes, shoulders, elbows, wrists, neck and head
/// (BodyPart) and has at most 64 joints; ContentError where it does not. Vertices are in the stance
/// pose (stance.h: standing, arms a little away from the sides, soles at y = 0, facing +z), because
/// skin that is bound near the poses it is seen in deforms best. `inverse_bind` therefore takes the
/// model frame to the joint frames *of that pose*, not of the skeleton's identity pose; palettes
/// are made as ever, world[j] * inverse_bind[j].
///
/// The same skeleton gives the same mesh. Takes about a third of a second.
SkinnedMesh make_avatar(const Skeleton& skeleton, const Figure& figure);

/// All `figures` in one mesh, in their order, made on up to `jobs` threads.
SkinnedMesh make_avatars(const Skeleton& skeleton, unsigned jobs);

}  // namespace docent::avatar
