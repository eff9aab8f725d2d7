#include "content/avatar/body.h"

namespace docent::avatar {
namespace {

/// From hem to neck: metres on a person of 1.70 m, shaped for this avatar and scaled by `s`.
/// Heights and the shoulders' width follow the skeleton's own joints.
std::array<Girth, 8> girths_of(const BodyShape& body) {
  const float s = body.scale;
  const float hip = body.hip_height;
  const float shoulder = body.shoulder_height;
  const float waist = hip + 0.40F * (shoulder - hip);
  const float back = body.neck_base.z;
  const float half = body.shoulder_half;
  return {{{body.hem - 0.05F * s, 0.206F * s, 0.168F * s, 0.004F * s},
           {hip - 0.14F * s, 0.194F * s, 0.153F * s, 0.000F},
           {hip + 0.03F * s, 0.177F * s, 0.131F * s, -0.008F * s},
           {waist, 0.146F * s, 0.112F * s, 0.4F * back},
           {shoulder - 0.19F * s, half * 0.90F, 0.122F * s, 0.8F * back + 0.014F * s},
           {shoulder - 0.08F * s, half * 0.84F, 0.108F * s, back + 0.006F * s},
           {shoulder - 0.005F * s, half * 0.60F, 0.082F * s, back + 0.002F * s},
           {shoulder + 0.06F * s, 0.066F * s, 0.066F * s, back + 0.008F * s}}};
}

}  // namespace

BodyShape body_of(const Figure& figure, Stance stance) {
  BodyShape body;
  body.figure = figure;
  body.stance = std::move(stance);
  const LimbPoints& left = body.limb(Side::Left);
  const LimbPoints& right = body.limb(Side::Right);
  const float stature = body.stance.stature;
  const float s = stature / 1.7F;
  body.scale = s;
  body.hip_height = 0.5F * (left.hip.y + right.hip.y);
  body.shoulder_height = 0.5F * (left.shoulder.y + right.shoulder.y);
  body.shoulder_half = 0.5F * (left.shoulder.x - right.shoulder.x);
  body.hem = 0.5F * (left.knee.y + right.knee.y) + 0.095F * s;
  // A head is 1/7.5 of the stature; the skull's middle lies a little before the joint that carries
  // it.
  body.skull = {0, stature * (1 - 0.5F / 7.5F), body.stance.head.z + 0.018F * s};
  body.neck_base = {0, body.shoulder_height + 0.035F * s,
                    0.5F * (left.shoulder.z + right.shoulder.z) + 0.012F * s};
  body.girths = girths_of(body);
  return body;
}

}  // namespace docent::avatar
