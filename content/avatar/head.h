#pragma once

#include "content/avatar/body.h"

namespace docent::avatar {

/// A place on the head: metres on a head 22.7 cm high, from the middle between chin and crown; x to
/// the person's left, y up, z to the front.
struct HeadFrame {
  Vec3 p;     ///< Of the head.
  Vec3 half;  ///< The same with both sides folded together: x is the distance from the middle.
  float s;    ///< Metres of the model in one of this frame.

  HeadFrame(const BodyShape& body, Vec3 at);
};

/// The bare skull in the head's frame.
float cranium(Vec3 p);

// Solids in the model frame, metres.

/// The face and skull alone, without ears and neck.
float face(const BodyShape& body, Vec3 p);
float head_and_neck(const BodyShape& body, Vec3 p);
/// The neck with collar bones and the upper part of the breast.
float neck(const BodyShape& body, Vec3 p);
float lips(const BodyShape& body, Vec3 p);
float brows(const BodyShape& body, Vec3 p);
float eye_whites(const BodyShape& body, Vec3 p);
float irises(const BodyShape& body, Vec3 p);

/// A place as simplification shall see it: eyes, nose and ears larger than they are.
Vec3 magnified_face(const BodyShape& body, Vec3 p);

}  // namespace docent::avatar
