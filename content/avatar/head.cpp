#include "content/avatar/head.h"

namespace docent::avatar {
namespace {

// All places and sizes are metres on a head 22.7 cm high, shaped for these guides.

constexpr Vec3 eye_middle{0.0315F, -0.0005F, 0.0668F};
constexpr float eye_radius = 0.0122F;
constexpr float lid = 0.0021F;

float cranium_of(Vec3 p) {
  return ellipsoid(p, {0, 0.0235F, -0.010F}, {0.0745F, 0.0900F, 0.0940F});
}

/// Cheeks, muzzle, jaw and chin, without what is carved or set on them.
float face_mass(const Face& face, Vec3 p) {
  const float w = face.width, j = face.jaw;
  float d = cranium_of(p);
  const float middle = ellipsoid(p, {0, -0.016F, 0.036F}, {0.0555F * w, 0.048F, 0.0445F});
  d = join(d, middle, 0.020F);
  const float floor =
      tapered_capsule(p, {0, -0.045F, 0.004F}, {0, -0.082F, 0.046F}, 0.043F, 0.023F);
  d = join(d, floor, 0.024F);
  const float ramus = tapered_capsule(p, {0.0575F * w, -0.018F, -0.004F},
                                      {0.0455F * w * j, -0.062F, 0.004F}, 0.010F, 0.0095F);
  const float body = tapered_capsule(p, {0.0455F * w * j, -0.062F, 0.004F},
                                     {0.0150F * j, -0.0990F, 0.064F}, 0.0095F, 0.0120F);
  d = join(d, join(ramus, body, 0.016F), 0.030F);
  const float cheekbone = tapered_capsule(p, {0.039F * w, -0.022F, 0.0615F},
                                          {0.0570F * w, -0.0125F, 0.022F}, 0.0135F, 0.0105F);
  d = join(d, cheekbone, 0.022F);
  const float cheek = sphere(p, {0.0330F * w, -0.050F, 0.0430F}, 0.022F - 0.004F * face.age);
  d = join(d, cheek, 0.034F);
  const float muzzle = ellipsoid(p, {0, -0.0575F, 0.0470F}, {0.0335F, 0.0330F, 0.0395F});
  d = join(d, muzzle, 0.018F);
  const float chin = ellipsoid(p, {0, -0.0985F, 0.0665F}, Vec3{0.0195F * j, 0.0148F, 0.0178F});
  return join(d, chin, 0.014F);
}

float brow_and_sockets(const Face& face, Vec3 p, float d) {
  const float ridge =
      tapered_capsule(p, {0.007F, 0.0205F, 0.0785F}, {0.0440F, 0.0225F, 0.0585F}, 0.0080F, 0.0085F);
  d = join(d, ridge - 0.0012F * (face.brow - 1), 0.018F);
  const float socket = ellipsoid(p, {0.0315F, 0.0010F, 0.0910F}, {0.0190F, 0.0118F, 0.0135F});
  d = carve(d, socket, 0.014F);
  // Between the inner corner of the eye and the root of the nose it is deepest.
  return carve(d, sphere(p, {0.0155F, 0.0055F, 0.0875F}, 0.0065F), 0.010F);
}

float nose(const Face& face, Vec3 p, float d) {
  const float n = face.nose;
  const auto down = [n](float y) { return 0.010F + (y - 0.010F) * (0.6F + 0.4F * n); };
  const float tip_z = 0.0775F + 0.0215F * n;
  const float bridge = tapered_capsule(p, {0, 0.0120F, 0.0770F},
                                       {0, down(-0.0255F), tip_z - 0.002F}, 0.0058F, 0.0070F);
  const float body =
      tapered_capsule(p, {0, 0.0060F, 0.0690F}, {0, down(-0.0330F), 0.0820F}, 0.0080F, 0.0125F * n);
  d = join(join(d, body, 0.014F), bridge, 0.012F);
  d = join(d, sphere(p, {0, down(-0.0315F), tip_z}, 0.0088F), 0.007F);
  const float wing =
      ellipsoid(p, {0.0108F * n, down(-0.0355F), 0.0880F}, Vec3{0.0066F, 0.0064F, 0.0090F} * n);
  d = join(d, wing, 0.0055F);
  const float columella = tapered_capsule(p, {0, down(-0.0365F), tip_z - 0.001F},
                                          {0, down(-0.0420F), 0.0850F}, 0.0042F, 0.0050F);
  d = join(d, columella, 0.004F);
  const float nostril =
      ellipsoid(p, {0.0066F * n, down(-0.0425F), 0.0925F}, Vec3{0.0030F, 0.0036F, 0.0056F} * n);
  d = carve(d, nostril, 0.0022F);
  // The crease that sets the wing off the cheek.
  const float crease = tapered_capsule(p, {0.0178F * n, down(-0.0300F), 0.0845F},
                                       {0.0188F * n, down(-0.0400F), 0.0815F}, 0.0012F, 0.0014F);
  return carve(d, crease, 0.006F);
}

float around_the_mouth(const Face& face, Vec3 p, float d) {
  const float philtrum =
      tapered_capsule(p, {0, -0.0470F, 0.0905F}, {0, -0.0530F, 0.0920F}, 0.0022F, 0.0026F);
  d = carve(d, philtrum, 0.004F);
  const float corner = sphere(p, {0.0270F, -0.0640F, 0.0800F}, 0.0040F);
  d = carve(d, corner, 0.008F);
  const float below =
      tapered_capsule(p, {0, -0.0820F, 0.0915F}, {0.0140F, -0.0820F, 0.0860F}, 0.0055F, 0.0040F);
  d = carve(d, below, 0.009F);
  if (face.age > 0) {
    const float fold = tapered_capsule(p, {0.0195F, -0.0370F, 0.0840F},
                                       {0.0315F, -0.0640F, 0.0760F}, 0.0016F, 0.0012F);
    d = carve(d, fold - 0.0012F * face.age, 0.008F);
    const float bag = tapered_capsule(p, {0.0220F, -0.0140F, 0.0810F}, {0.0400F, -0.0150F, 0.0760F},
                                      0.0012F, 0.0012F);
    d = carve(d, bag - 0.0010F * face.age, 0.006F);
  }
  return d;
}

/// The gap between the lids, seen from the front: negative inside it.
float lid_gap(Vec3 p) {
  const float u = p.x - eye_middle.x;
  const float v = p.y - eye_middle.y - 0.09F * u;
  const float reach = 0.0150F;
  // The upper lid is highest towards the nose, the lower lowest towards the temple.
  const float t = u / reach;
  const float arc = 1 - t * t;
  const float upper = 0.0047F * arc * (1 - 0.18F * t);
  const float lower = -0.0037F * arc * (1 + 0.22F * t);
  return 0.9F * std::max(v - upper, lower - v);
}

float lids(Vec3 p, float d) {
  if (glm::length(p - eye_middle) > 0.05F) return d;
  const float ball = sphere(p, eye_middle, eye_radius + lid);
  d = join(d, ball, 0.0038F);
  const float behind = sphere(p, eye_middle, eye_radius - 0.0012F);
  const float gap = std::max({lid_gap(p), -behind, eye_middle.z - p.z});
  return carve(d, gap, 0.0012F);
}

/// The outer ear in a frame of its own: u towards the back of the head, v up, w away from the head.
float ear(Vec3 p) {
  const Vec3 middle{0.0735F, -0.0060F, -0.0130F};
  const Vec3 q = p - middle;
  if (glm::dot(q, q) > 0.0036F) return glm::length(q) - 0.045F;
  const Vec3 up = glm::normalize(Vec3{0.06F, 0.97F, -0.20F});
  const Vec3 out = glm::normalize(glm::cross(glm::cross(up, Vec3{0.92F, 0, 0.40F}), up));
  const Vec3 back = glm::cross(up, out);
  const float u = glm::dot(q, back), v = glm::dot(q, up), w = glm::dot(q, out);
  // An egg, wide above.
  const float narrow = 0.0165F * (1 + 9.0F * v);
  const float k = std::sqrt((u / narrow) * (u / narrow) + (v / 0.0300F) * (v / 0.0300F));
  const float outline = (k - 1) * 0.0175F;
  const float plate = std::max(outline, std::abs(w - 0.10F * u) - 0.0032F);
  const auto rim_at = [&](float inset, float lift, float radius) {
    const float a = outline + inset, b = w - 0.10F * u - lift;
    return std::sqrt(a * a + b * b) - radius;
  };
  const float open_front = 0.7F * (-0.0075F - u);  // no helix where the ear meets the cheek
  const float helix = std::max(rim_at(0.0026F, 0.0030F, 0.0034F), v < 0.004F ? open_front : -1.0F);
  const float antihelix = std::max(rim_at(0.0090F, 0.0024F, 0.0026F), -0.004F - u);
  float d = join(plate, helix, 0.003F);
  d = join(d, antihelix, 0.003F);
  const float bowl =
      ellipsoid({u, v, w}, {-0.0025F, -0.0040F, 0.0040F}, {0.0072F, 0.0105F, 0.0048F});
  d = carve(d, bowl, 0.003F);
  const float tragus =
      ellipsoid({u, v, w}, {-0.0118F, -0.0040F, 0.0018F}, {0.0040F, 0.0066F, 0.0040F});
  d = join(d, tragus, 0.004F);
  return join(d, ellipsoid({u, v, w}, {-0.0040F, -0.0255F, 0.0010F}, {0.0072F, 0.0075F, 0.0036F}),
              0.004F);
}

float face_of(const Face& face, Vec3 p) {
  float d = face_mass(face, p);
  d = brow_and_sockets(face, p, d);
  d = nose(face, p, d);
  d = around_the_mouth(face, p, d);
  return lids(p, d);
}

}  // namespace

HeadFrame::HeadFrame(const BodyShape& body, Vec3 at)
    : p{at.x, at.y - body.skull.y, at.z - body.skull.z}, s{body.scale} {
  p /= s;
  half = {std::abs(p.x), p.y, p.z};
}

float cranium(Vec3 p) {
  return cranium_of(p);
}

float face(const BodyShape& body, Vec3 at) {
  const HeadFrame head(body, at);
  return face_of(body.figure.face, head.half) * head.s;
}

float head_and_neck(const BodyShape& body, Vec3 at) {
  const HeadFrame head(body, at);
  float d = face_of(body.figure.face, head.half);
  if (body.figure.headwear != Headwear::Scarf) d = join(d, ear(head.half), 0.004F);
  const float s = head.s;
  return join(d * s, neck(body, at), 0.022F * s);
}

float neck(const BodyShape& body, Vec3 at) {
  const float s = body.scale;
  const float girth = body.figure.build.neck;
  const Vec3 q{std::abs(at.x), at.y, at.z};
  const auto on_skull = [&](float x, float y, float z) { return body.skull + Vec3{x, y, z} * s; };
  const auto on_base = [&](float x, float y, float z) {
    return body.neck_base + Vec3{x, y, z} * s;
  };
  float d = tapered_capsule(q, on_base(0, -0.050F, -0.004F), on_skull(0, -0.050F, -0.022F),
                            0.054F * girth * s, 0.0465F * girth * s);
  // From behind the ear to the pit of the neck, and the slope of the trapezius.
  const float cord = tapered_capsule(q, on_skull(0.050F, -0.045F, -0.034F),
                                     on_base(0.012F, -0.032F, 0.050F), 0.012F * s, 0.0085F * s);
  d = join(d, cord, 0.022F * s);
  const float slope = tapered_capsule(q, on_skull(0.018F, -0.060F, -0.060F),
                                      on_base(0.085F, -0.042F, -0.022F), 0.018F * s, 0.020F * s);
  d = join(d, slope, 0.040F * s);
  if (girth >= 1) d = join(d, sphere(q, on_base(0, 0.036F, 0.045F), 0.009F * s), 0.022F * s);
  const float pit = sphere(q, on_base(0, -0.026F, 0.071F), 0.009F * s);
  d = carve(d, pit, 0.012F * s);
  const float chest = ellipsoid(q, on_base(0, -0.100F, 0.004F), Vec3{0.130F, 0.085F, 0.066F} * s);
  const float collarbone =
      tapered_capsule(q, on_base(0.016F, -0.036F, 0.056F), on_base(0.105F, -0.020F, 0.010F),
                      0.0075F * s, 0.0070F * s);
  return join(join(d, chest, 0.03F * s), collarbone, 0.012F * s);
}

float lips(const BodyShape& body, Vec3 at) {
  const HeadFrame head(body, at);
  const float full = body.figure.face.lips;
  const Vec3 p = head.half;
  const Vec3 corner{0.0245F, -0.0632F, 0.0770F};
  const float upper =
      join(tapered_capsule(p, {0.0045F, -0.0585F, 0.0880F}, corner, 0.0036F * full, 0.0012F),
           sphere(p, {0, -0.0597F, 0.0885F}, 0.0034F * full), 0.003F);
  const float lower =
      join(tapered_capsule(p, {0.0050F, -0.0695F, 0.0862F}, corner + Vec3{-0.002F, -0.0005F, 0},
                           0.0047F * full, 0.0012F),
           sphere(p, {0, -0.0697F, 0.0868F}, 0.0046F * full), 0.004F);
  return std::min(upper, lower) * head.s;
}

float brows(const BodyShape& body, Vec3 at) {
  const HeadFrame head(body, at);
  const Vec3 p = head.half;
  // Nearest place along an arc in the front view; it lies on the skin, however that is shaped.
  const float t = std::clamp((p.x - 0.0140F) / 0.0350F, 0.0F, 1.0F);
  const float rise = 0.0240F + 0.0085F * t - 0.0090F * t * t * t;
  const float width = 0.0031F * (1 - 0.70F * t * t) * (0.55F + 0.45F * smoothstep(0.0F, 0.2F, t));
  const float across = std::abs(p.y - rise) - width;
  const float along = std::max(0.0130F - p.x, p.x - 0.0490F);
  const float raised = face_of(body.figure.face, p) - 0.0016F * (1 - 0.5F * t);
  return meet(std::max({across, along, 0.03F - p.z}), raised, 0.0016F) * head.s;
}

Vec3 magnified_face(const BodyShape& body, Vec3 at) {
  const HeadFrame head(body, at);
  const float side = at.x < 0 ? -1.0F : 1.0F;
  Vec3 p = head.half;
  const auto magnify = [&](Vec3 middle, float reach, float by) {
    const Vec3 off = head.half - middle;
    p += off * by * std::exp(-glm::dot(off, off) / (reach * reach));
  };
  magnify(eye_middle + Vec3{0, 0, 0.01F}, 0.018F, 1.6F);
  magnify({0.008F, -0.036F, 0.090F}, 0.014F, 0.7F);
  magnify({0.074F, -0.006F, -0.013F}, 0.030F, 0.3F);
  return Vec3{side * p.x, p.y, p.z} * head.s;
}

float eye_whites(const BodyShape& body, Vec3 at) {
  const HeadFrame head(body, at);
  return sphere(head.half, eye_middle, eye_radius) * head.s;
}

float irises(const BodyShape& body, Vec3 at) {
  const HeadFrame head(body, at);
  // A lens: what of a flatter ball stands out of the eye.
  const Vec3 gaze = eye_middle + Vec3{-0.0006F, -0.0004F, 0.0052F};
  return meet(sphere(head.half, gaze, 0.0079F),
              std::sqrt((head.half.x - gaze.x) * (head.half.x - gaze.x) +
                        (head.half.y - gaze.y) * (head.half.y - gaze.y)) -
                  0.0057F,
              0.001F) *
         head.s;
}

}  // namespace docent::avatar
