#include "content/avatar/body.h"

namespace docent::avatar {
namespace {

/// A place on the head of a person of 1.70 m, 22.7 cm high, that was shaped for this avatar: metres
/// from the middle of the skull, x out from the plane of symmetry, y up, z to the front.
struct HeadFrame {
  Vec3 p;
  float s;

  HeadFrame(const BodyShape& body, Vec3 at)
      : p{std::abs(at.x), at.y - body.skull.y, at.z - body.skull.z}, s{body.scale} {
    p /= s;
  }
};

float cranium(Vec3 p, float ease) {
  return ellipsoid(p, {0, 0.022F, -0.008F}, Vec3{0.074F, 0.0905F, 0.0935F} + ease);
}

}  // namespace

float head_and_neck(const BodyShape& body, Vec3 at) {
  const HeadFrame head(body, at);
  const Vec3 p = head.p;
  float d = cranium(p, 0);
  const float jaw = tapered_capsule(p, {0, -0.032F, 0.020F}, {0, -0.085F, 0.054F}, 0.057F, 0.027F);
  d = join(d, jaw, 0.045F);
  const float cheek = sphere(p, {0.035F, -0.024F, 0.048F}, 0.029F);
  d = join(d, cheek, 0.03F);
  const float brow =
      tapered_capsule(p, {0, 0.019F, 0.078F}, {0.040F, 0.020F, 0.062F}, 0.012F, 0.010F);
  d = join(d, brow, 0.022F);
  d = carve(d, ellipsoid(p, {0.031F, 0.001F, 0.092F}, {0.020F, 0.012F, 0.012F}), 0.018F);
  const float nose =
      tapered_capsule(p, {0, 0.004F, 0.083F}, {0, -0.031F, 0.100F}, 0.0075F, 0.0095F);
  const float nostril = sphere(p, {0.009F, -0.034F, 0.090F}, 0.0066F);
  d = join(d, join(nose, nostril, 0.008F), 0.014F);
  const float lips = ellipsoid(p, {0, -0.060F, 0.0715F}, {0.022F, 0.011F, 0.010F});
  d = join(d, lips, 0.014F);
  const float ear = ellipsoid(p, {0.076F, -0.008F, -0.008F}, {0.010F, 0.030F, 0.018F});
  d = join(d, ear, 0.008F);

  const float s = body.scale;
  const Vec3 top{0, body.skull.y - 0.055F * s, body.skull.z - 0.018F * s};
  const Vec3 mirrored{std::abs(at.x), at.y, at.z};
  const float neck = tapered_capsule(mirrored, body.neck_base + Vec3{0, -0.03F, 0} * s, top,
                                     0.060F * s, 0.051F * s);
  return join(d * s, neck, 0.025F * s);
}

float hair(const BodyShape& body, Vec3 at) {
  const HeadFrame head(body, at);
  const Vec3 p = head.p;
  // Free of the face, and before the ears of the cheeks; thin at the hairline, fuller behind it.
  const float face = half_space(p, {0, 0.071F, 0.072F}, glm::normalize(Vec3{0.16F, -0.74F, 0.66F}));
  const float temples = half_space(p, {0, 0.0F, 0.018F}, glm::normalize(Vec3{0, -0.12F, 1}));
  const float hairline = std::min(face, std::max(temples, face - 0.022F));
  const float fullness = smoothstep(0.0F, 0.055F, -hairline);
  float d = cranium(p, 0.0050F + 0.0095F * fullness);
  // Down to the nape.
  const float nape = ellipsoid(p, {0, -0.038F, -0.056F}, {0.058F, 0.052F, 0.040F});
  d = join(d, nape, 0.05F * (0.1F + fullness));
  d = meet(d, hairline, 0.006F);
  d = meet(d, half_space(p, {0, -0.068F, -0.05F}, glm::normalize(Vec3{0, -1, 0.35F})), 0.02F);
  d = carve(d, ellipsoid(p, {0.086F, -0.022F, 0.0F}, {0.022F, 0.036F, 0.026F}), 0.012F);
  return d * head.s;
}

float brows(const BodyShape& body, Vec3 at) {
  const HeadFrame head(body, at);
  const Vec3 inner{0.0165F, 0.0285F, 0.0860F};
  const Vec3 arch{0.0335F, 0.0300F, 0.0780F};
  const Vec3 outer{0.0475F, 0.0245F, 0.0655F};
  return join(tapered_capsule(head.p, inner, arch, 0.0034F, 0.0036F),
              tapered_capsule(head.p, arch, outer, 0.0036F, 0.0022F), 0.002F) *
         head.s;
}

float eyes(const BodyShape& body, Vec3 at) {
  const HeadFrame head(body, at);
  return ellipsoid(head.p, {0.0312F, 0.0012F, 0.0720F}, {0.0112F, 0.0076F, 0.0088F}) * head.s;
}

}  // namespace docent::avatar
