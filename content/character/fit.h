#pragma once

#include <array>

#include "content/character/character.h"
#include "runtime/model/motion/skeleton.h"
#include "runtime/model/motion/skinned_mesh.h"

namespace docent::character {

/// A character's measures as a guide: metres, mean of both sides, the middle of the hip joints at
/// x = z = 0 and the soles at y = 0.
struct Measures {
  float scale = 1;              ///< Metres of the guide in one unit of the file.
  Vec3 origin{0};               ///< Of the file, where the guide's origin is; before `scale`.
  float height = 0;             ///< Of what is drawn.
  float hip = 0, hip_half = 0;  ///< Height of the hip joints; half of the way between them.
  float thigh = 0, shin = 0, ankle = 0;  ///< Lengths; the ankle's height.
  float foot = 0;                        ///< From the ankle forward to the ball.
  Vec3 shoulder{0}, neck{0}, head{0};    ///< Places; the shoulder's is the left one.
  float upper_arm = 0, forearm = 0, hand = 0;
  float crown = 0;  ///< Height of the head's top.

  Vec3 place(Vec3 in_file) const { return scale * (in_file - origin); }
};

/// A character is taken as large as it is; one that no door would let through, or smaller than a
/// child of one, is made 1.75 m high.
Measures measure(const Character& character);

/// The skeleton of a recording with a character's measures: the same joints, and limbs that point
/// where they pointed in the rest pose, so that the recording's rotations turn them as they turned
/// the recorded body. `toe_rest` is the height, metres, at which the recorded body's toe joint
/// rests on the ground.
struct Fit {
  Skeleton skeleton;
  float legs = 1;                       ///< Share of the recorded leg's length.
  float recorded_ankle = 0, ankle = 0;  ///< Heights of an ankle over a flat sole.
  float toe_rest = 0;                   ///< Where the character's toe joint rests, metres.
  /// What of the recorded pelvis' roll and twist is kept: wide hips on short legs would lift the
  /// feet with them.
  float pelvis = 1;
  float thigh = 1, shin = 1;  ///< Lengths beside the character's own.
};
/// ContentError (`incomplete-skeleton`) where the recording's skeleton lacks a part of the body.
Fit fit_skeleton(const Skeleton& recorded, const Measures& measures, float toe_rest);

/// The character's body, one figure, bound to the fitted skeleton. What swings is its cloth, as
/// much of it as there is room for among the matrices that a body is drawn with.
SkinnedMesh bind_body(const Character& character, const Measures& measures, const Fit& fit);

}  // namespace docent::character
