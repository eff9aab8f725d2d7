#include "content/avatar/body.h"

namespace docent {
namespace {

/// Place on the head for measures taken from the middle of the skull on a head of 22.7 cm: x out
/// from the plane of symmetry, y up, z to the front.
struct HeadFrame {
  Vec3 p;
  float s;

  HeadFrame(const Body& body, Vec3 at)
      : p{std::abs(at.x), at.y - body.skull.y, at.z - body.skull.z}, s{body.scale} {
    p /= s;
  }
};

float cranium(Vec3 p, float ease) {
  return ellipsoid(p, {0, 0.022F, -0.008F}, Vec3{0.074F, 0.0905F, 0.0935F} + ease);
}

}  // namespace

float head_and_neck(const Body& body, Vec3 at) {
  const HeadFrame head(body, at);
  const Vec3 p = head.p;
  float d = cranium(p, 0);
  const float jaw = tapered_capsule(p, {0, -0.035F, 0.022F}, {0, -0.082F, 0.050F}, 0.060F, 0.030F);
  d = join(d, jaw, 0.045F);
  const float cheek = sphere(p, {0.036F, -0.026F, 0.048F}, 0.030F);
  d = join(d, cheek, 0.03F);
  const float brow =
      tapered_capsule(p, {0, 0.019F, 0.078F}, {0.040F, 0.020F, 0.062F}, 0.012F, 0.010F);
  d = join(d, brow, 0.022F);
  d = carve(d, ellipsoid(p, {0.031F, 0.001F, 0.092F}, {0.020F, 0.012F, 0.014F}), 0.018F);
  const float nose =
      tapered_capsule(p, {0, 0.004F, 0.083F}, {0, -0.031F, 0.100F}, 0.0075F, 0.0105F);
  const float nostril = sphere(p, {0.010F, -0.035F, 0.090F}, 0.0080F);
  d = join(d, join(nose, nostril, 0.008F), 0.014F);
  const float lips = ellipsoid(p, {0, -0.062F, 0.0755F}, {0.024F, 0.009F, 0.010F});
  d = join(d, lips, 0.010F);
  const float ear = ellipsoid(p, {0.076F, -0.008F, -0.008F}, {0.010F, 0.030F, 0.018F});
  d = join(d, ear, 0.008F);

  const float s = body.scale;
  const Vec3 top{0, body.skull.y - 0.055F * s, body.skull.z - 0.018F * s};
  const Vec3 mirrored{std::abs(at.x), at.y, at.z};
  const float neck = tapered_capsule(mirrored, body.neck_base + Vec3{0, -0.03F, 0} * s, top,
                                     0.060F * s, 0.051F * s);
  return join(d * s, neck, 0.025F * s);
}

float hair(const Body& body, Vec3 at) {
  const HeadFrame head(body, at);
  const Vec3 p = head.p;
  float d = cranium(p, 0.013F);
  // Fullness above and behind, down to the nape.
  d = join(d, ellipsoid(p, {0, 0.055F, -0.004F}, {0.078F, 0.075F, 0.092F}), 0.04F);
  d = join(d, ellipsoid(p, {0, -0.040F, -0.058F}, {0.060F, 0.055F, 0.042F}), 0.05F);
  // The hairline: free of the face, and behind the ears free of the neck.
  const float face = half_space(p, {0, 0.064F, 0.070F}, glm::normalize(Vec3{0.10F, -0.78F, 0.62F}));
  const float cheeks = half_space(p, {0, 0.0F, 0.022F}, glm::normalize(Vec3{0, -0.10F, 1}));
  d = meet(d, std::min(face, std::max(cheeks, face - 0.02F)), 0.016F);
  d = meet(d, half_space(p, {0, -0.068F, -0.05F}, glm::normalize(Vec3{0, -1, 0.35F})), 0.02F);
  d = carve(d, ellipsoid(p, {0.086F, -0.022F, 0.0F}, {0.022F, 0.036F, 0.026F}), 0.012F);
  return d * head.s;
}

float brows(const Body& body, Vec3 at) {
  const HeadFrame head(body, at);
  const float inner = tapered_capsule(head.p, {0.016F, 0.0195F, 0.0895F},
                                      {0.034F, 0.0235F, 0.0805F}, 0.0040F, 0.0042F);
  const float outer = tapered_capsule(head.p, {0.034F, 0.0255F, 0.0805F}, {0.049F, 0.0225F, 0.066F},
                                      0.0042F, 0.0028F);
  return std::min(inner, outer) * head.s;
}

float eyes(const Body& body, Vec3 at) {
  const HeadFrame head(body, at);
  return ellipsoid(head.p, {0.0315F, 0.0005F, 0.0715F}, {0.0125F, 0.0062F, 0.0090F}) * head.s;
}

}  // namespace docent
