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
  const Build& build = body.figure.build;
  const float flare = body.cut.flare, hips = build.hips, belly = build.belly * s;
  return {{{std::min(body.hem - 0.05F * s, hip - 0.20F * s), 0.206F * hips * flare * s,
            0.168F * hips * flare * s, 0.004F * s},
           {hip - 0.14F * s, 0.188F * hips * s, 0.150F * hips * s, 0.000F},
           {hip + 0.03F * s, 0.172F * hips * s, 0.126F * hips * s + 0.5F * belly,
            -0.008F * s + 0.5F * belly},
           {waist, 0.142F * build.waist * s, 0.108F * build.waist * s + 0.5F * belly,
            0.4F * back + 0.5F * belly},
           {shoulder - 0.19F * s, half * 0.90F * build.chest, 0.118F * s + 0.5F * build.bust * s,
            0.8F * back + 0.012F * s + 0.5F * build.bust * s},
           {shoulder - 0.08F * s, half * 0.82F * build.chest, 0.104F * s, back + 0.006F * s},
           {shoulder - 0.005F * s, half * 0.60F, 0.082F * s, back + 0.002F * s},
           {shoulder + 0.06F * s, 0.066F * s, 0.066F * s, back + 0.008F * s}}};
}

}  // namespace

Cut cut_of(Garment garment) {
  switch (garment) {
    case Garment::Coat:
      return {.hem = 0.04F, .flare = 1.02F, .folds = 0.005F};
    case Garment::Dress:
      return {.hem = -0.10F,
              .flare = 1.16F,
              .folds = 0.016F,
              .cuff = 0.040F,
              .neckline = 0.12F,
              .lapels = false,
              .pockets = false,
              .buttons = false,
              .bare_legs = true,
              .legs = 0.78F};
    case Garment::Kurta:
      return {.hem = 0.02F,
              .flare = 0.98F,
              .folds = 0.006F,
              .cuff = 0.044F,
              .neckline = 0.10F,
              .lapels = false,
              .pockets = false};
    case Garment::Abaya:
      return {.hem = -0.33F,
              .flare = 1.18F,
              .folds = 0.014F,
              .cuff = 0.066F,
              .neckline = 0.05F,
              .lapels = false,
              .pockets = false,
              .buttons = false};
    case Garment::Jacket:
      return {.hem = 0.34F, .flare = 0.97F};
    case Garment::Cardigan:
      return {.hem = 0.20F, .flare = 1.0F, .folds = 0.004F, .cuff = 0.043F, .neckline = 0.28F};
    case Garment::Uniform:
      return {.hem = 0.28F, .flare = 1.03F, .cuff = 0.042F, .neckline = 0.06F, .lapels = false};
    case Garment::Tunic:
      return {.hem = 0.22F,
              .flare = 1.16F,
              .folds = 0.010F,
              .cuff = 0.047F,
              .neckline = 0.10F,
              .lapels = false,
              .pockets = false,
              .buttons = false,
              .legs = 0.84F};
  }
  return {};
}

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
  body.cut = cut_of(figure.garment);
  body.hem =
      std::min(0.5F * (left.knee.y + right.knee.y) + body.cut.hem * s, body.hip_height - 0.12F * s);
  // A head is 1/7.5 of the stature; the skull's middle lies a little before the joint that carries
  // it.
  body.skull = {0, stature * (1 - 0.5F / 7.5F), body.stance.head.z + 0.018F * s};
  body.neck_base = {0, body.shoulder_height + 0.035F * s,
                    0.5F * (left.shoulder.z + right.shoulder.z) + 0.012F * s};
  body.girths = girths_of(body);
  return body;
}

}  // namespace docent::avatar
