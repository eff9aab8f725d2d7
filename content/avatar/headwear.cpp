#include "content/avatar/headwear.h"

#include "content/avatar/head.h"

namespace docent::avatar {
namespace {

// All places and sizes are metres on a head 22.7 cm high, shaped for these guides.

/// 0 in the crease between two folds, 1 on the back of one.
float fold(float c) {
  return std::abs(std::sin(3.14159265F * c));
}

/// Wound round the head; the windings cross above the forehead.
float turban(Vec3 p, Vec3 half) {
  const float winding = fold((p.y - 0.55F * half.x + 0.20F * p.z) / 0.026F);
  const float wound =
      ellipsoid(p, {0, 0.060F, -0.012F}, {0.102F, 0.076F, 0.116F}) - 0.007F * (winding - 0.5F);
  const float edge = p.y - 0.052F - 0.34F * (p.z - 0.05F) + 0.25F * half.x;
  return meet(0.8F * wound, -0.9F * edge, 0.012F);
}

/// A peaked cap: band, wider crown, visor.
float cap(Vec3 p) {
  const auto oval = [](Vec3 q, float x, float z) {
    const float k = std::sqrt((q.x / x) * (q.x / x) + (q.z / z) * (q.z / z));
    return (k - 1) * 0.5F * (x + z);
  };
  const Vec3 q = p - Vec3{0, 0.072F - 0.10F * p.z, -0.010F};
  const float band = std::max(oval(q, 0.084F, 0.104F), std::abs(q.y) - 0.019F);
  const float wide = 0.018F * smoothstep(0.015F, 0.036F, q.y);
  const float crown = meet(oval(q, 0.086F + wide, 0.106F + wide),
                           std::max(q.y - 0.052F - 0.10F * q.z, 0.012F - q.y), 0.012F);
  const Vec3 v = p - Vec3{0, 0.058F - 0.42F * (p.z - 0.08F), 0.050F};
  const float visor =
      std::max({oval(v, 0.074F, 0.088F), std::abs(v.y) - 0.0035F, -0.030F - v.z + 0.06F});
  return std::min(join(band, crown, 0.004F), visor);
}

/// Round face and neck, over the shoulders, in folds.
float scarf(Vec3 p, Vec3 half) {
  const float crease = fold((p.y + 0.30F * p.x + 0.35F * p.z) / 0.034F);
  float d = ellipsoid(p, {0, 0.018F, -0.014F}, {0.089F, 0.108F, 0.108F});
  const float neck =
      tapered_capsule(p, {0, -0.050F, -0.014F}, {0, -0.180F, -0.014F}, 0.078F, 0.098F);
  d = join(d, neck - 0.006F * (crease - 0.5F), 0.045F);
  const float drape =
      ellipsoid(p, {0, -0.210F, -0.006F}, {0.165F, 0.075F, 0.112F}) - 0.006F * (crease - 0.5F);
  d = join(d, drape, 0.05F);
  const Vec3 f = half - Vec3{0, -0.018F, 0};
  const float oval =
      (std::sqrt((f.x / 0.061F) * (f.x / 0.061F) + (f.y / 0.086F) * (f.y / 0.086F)) - 1) * 0.07F;
  return carve(0.85F * d, std::max(oval, 0.015F - p.z), 0.008F);
}

/// What hangs of it: a corner on the back and a shorter one on the breast, over the coat.
float scarf_ends(const BodyShape& body, const HeadFrame& head, Vec3 at) {
  constexpr float under = 0.001F, thick = 0.010F;
  const Vec3 p = head.p;
  const float on_coat = coat_solid(body, at) / head.s;
  const float pleat = fold(p.x / 0.036F + 0.5F + 0.8F * (p.y + 0.3F));
  const float cloth = std::max(on_coat - thick - 0.005F * (pleat - 0.4F), under - on_coat);
  const bool behind = at.z < body.neck_base.z;
  const float middle = behind ? 0.0F : 0.012F;
  const float end = (behind ? -0.455F : -0.385F) + (behind ? 1.0F : 0.9F) * std::abs(p.x - middle);
  const float edge = 0.72F * (end - p.y);
  const float wide = std::abs(p.x) - 0.080F - 0.14F * std::clamp(-0.20F - p.y, 0.0F, 0.10F);
  return meet(cloth, std::max(meet(edge, wide, 0.045F), p.y + 0.17F), 0.004F);
}

}  // namespace

float headwear(const BodyShape& body, Vec3 at) {
  const HeadFrame head(body, at);
  switch (body.figure.headwear) {
    case Headwear::Turban:
      return turban(head.p, head.half) * head.s;
    case Headwear::Cap:
      return cap(head.p) * head.s;
    case Headwear::Scarf:
      return join(scarf(head.p, head.half), 0.9F * scarf_ends(body, head, at), 0.022F) * head.s;
    case Headwear::None:
      break;
  }
  return 1;
}

}  // namespace docent::avatar
