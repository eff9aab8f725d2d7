#include <array>

#include "content/avatar/body.h"

// Measures with `s` are metres on a person of 1.70 m, shaped for this avatar; `s` scales them.

namespace docent::avatar {
namespace {

/// Catmull-Rom through the girths: smooth along the height, constant beyond its ends.
Girth girth_at(const std::array<Girth, 8>& girths, float height) {
  std::size_t k = 0;
  while (k + 2 < girths.size() && height > girths[k + 1].height) ++k;
  const Girth& a = girths[k == 0 ? 0 : k - 1];
  const Girth& b = girths[k];
  const Girth& c = girths[k + 1];
  const Girth& d = girths[std::min(k + 2, girths.size() - 1)];
  const float t = std::clamp((height - b.height) / (c.height - b.height), 0.0F, 1.0F);
  const auto through = [t](float p0, float p1, float p2, float p3) {
    return p1 + 0.5F * t *
                    (p2 - p0 + t * (2 * p0 - 5 * p1 + 4 * p2 - p3 + t * (3 * (p1 - p2) + p3 - p0)));
  };
  return {height, through(a.half_width, b.half_width, c.half_width, d.half_width),
          through(a.half_depth, b.half_depth, c.half_depth, d.half_depth),
          through(a.middle, b.middle, c.middle, d.middle)};
}

/// An upright column whose cross-section is a slightly squared ellipse.
float column(const std::array<Girth, 8>& girths, Vec3 p, float ease) {
  const Girth g = girth_at(girths, p.y);
  const float a = g.half_width + ease;
  const float b = g.half_depth + ease;
  const float x = p.x / a;
  const float z = (p.z - g.middle) / b;
  const float k0 = std::sqrt(x * x + z * z);
  const float k1 = std::sqrt(x * x / (a * a) + z * z / (b * b));
  return k1 < 1e-5F ? -std::min(a, b) : k0 * (k0 - 1) / k1;
}

}  // namespace

float coat_trunk(const BodyShape& body, Vec3 p, float ease) {
  const float s = body.scale;
  // Folds fall from the waist and deepen towards the hem.
  const float waist = body.hip_height + 0.10F * s;
  const float fall = smoothstep(waist, body.hem, p.y);
  const float turn = std::atan2(p.x, p.z);
  const float depth = body.cut.folds * s * fall;
  const float folds = depth * (std::cos(11 * turn) + 0.4F * std::cos(17 * turn + 1));
  const float walls = column(body.girths, p, ease) - folds;
  const float top = p.y - (body.shoulder_height + 0.05F * s + ease);
  const float bottom = body.hem - ease - p.y;
  return meet(meet(walls, top, 0.02F * s), bottom, 0.016F * s);
}

float coat_sleeve(const BodyShape& body, Vec3 p, Side side) {
  const float s = body.scale;
  const LimbPoints& limb = body.limb(side);
  const Vec3 cuff = glm::mix(limb.elbow, limb.wrist, body.cut.sleeve);
  // The sleeve's head sits inside and below the joint, so that shoulders slope rather than jut; the
  // more, the wider the skeleton's are.
  const float inside = 0.020F * s + 0.6F * std::max(body.shoulder_half - 0.172F * s, 0.0F);
  const Vec3 head = limb.shoulder + Vec3{-sign_of(side) * inside, -0.044F * s, 0};
  const float upper = tapered_capsule(p, head, limb.elbow, 0.051F * s, 0.044F * s);
  const float lower = tapered_capsule(p, limb.elbow, cuff, 0.044F * s, body.cut.cuff * s);
  const Vec3 along = glm::normalize(limb.wrist - limb.elbow);
  // Cloth gathers at the elbow, and a cuff is turned up at the end.
  const float down = glm::dot(p - limb.elbow, along) / s;
  const float gathered =
      0.0028F * s * std::sin(down / 0.0085F + 18 * p.z) * std::exp(-down * down / 0.0030F);
  const float to_end = glm::dot(cuff - p, along);
  const float turned_up = 0.0035F * s * (1 - smoothstep(0.050F * s, 0.056F * s, to_end));
  return meet(join(upper, lower, 0.02F * s) - gathered - turned_up, half_space(p, cuff, along),
              0.006F * s);
}

float coat_solid(const BodyShape& body, Vec3 p) {
  const float s = body.scale;
  const float sleeves =
      std::min(coat_sleeve(body, p, Side::Left), coat_sleeve(body, p, Side::Right));
  const float x = std::abs(p.x);
  // The slope from neck to shoulder.
  const LimbPoints& left = body.limb(Side::Left);
  const float slope =
      tapered_capsule({x, p.y, p.z}, body.neck_base + Vec3{0.030F, -0.012F, -0.012F} * s,
                      left.shoulder + Vec3{-0.036F, -0.040F, 0} * s, 0.042F * s, 0.042F * s);
  // Near the armpit the fill is small, or arm and flank would grow together.
  const float rise = p.y - body.shoulder_height;
  const float fill = 0.012F * s + 0.035F * s * smoothstep(-0.12F * s, -0.04F * s, rise) +
                     0.055F * s * smoothstep(-0.05F * s, 0.02F * s, rise);
  return join(join(coat_trunk(body, p, 0), slope, 0.05F * s), sleeves, fill);
}

float trouser_leg(const BodyShape& body, Vec3 p, Side side) {
  const float s = body.scale;
  const float w = s * body.cut.legs;
  const LimbPoints& limb = body.limb(side);
  const Vec3 hem = limb.ankle + Vec3{0, -0.030F, -0.004F} * s;
  const float thigh =
      tapered_capsule(p, limb.hip + Vec3{0, -0.02F, 0} * s, limb.knee, 0.080F * s, 0.062F * w);
  const float shin = tapered_capsule(p, limb.knee, hem, 0.062F * w, 0.055F * w * w / s);
  // It breaks over the shoe, and is creased in front.
  const float rise = (p.y - limb.ankle.y) / s;
  const float broken = 0.0045F * s * std::sin((rise + 0.5F * (p.z - limb.ankle.z) / s) / 0.0125F) *
                       smoothstep(0.16F, 0.02F, rise);
  const float off = (p.x - glm::mix(hem.x, limb.knee.x, std::clamp(rise / 0.4F, 0.0F, 1.0F))) / s;
  const float crease = p.z > limb.ankle.z ? 0.005F * s * std::exp(-off * off / 0.0002F) : 0.0F;
  float leg = join(thigh, shin, 0.02F * s);
  if (!body.cut.bare_legs) leg -= broken + crease;
  return meet(leg, hem.y - 0.008F * s - p.y, 0.01F * s);
}

float shoe(const BodyShape& body, Vec3 p, Side side) {
  const float s = body.scale;
  const LimbPoints& limb = body.limb(side);
  const Vec3 f = limb.foot_forward;
  const Vec3 across = Vec3{f.z, 0, -f.x} * sign_of(side);
  const auto at = [&](float forward, float out, float height) {
    const Vec3 base = Vec3{limb.ankle.x, 0, limb.ankle.z};
    return base + f * (forward * s) + across * (out * s) + Vec3{0, height * s, 0};
  };
  // The ball joint tells how long this foot is; the rest follows it.
  const float ball = glm::dot(limb.toe - limb.ankle, f) / s;
  const float heel = tapered_capsule(p, at(-0.038F, -0.002F, 0.034F), at(0.02F, 0, 0.036F),
                                     0.035F * s, 0.038F * s);
  const float instep = tapered_capsule(p, at(0.0F, 0, 0.070F), at(ball - 0.005F, -0.004F, 0.030F),
                                       0.042F * s, 0.034F * s);
  const float tread = tapered_capsule(p, at(ball, 0.008F, 0.022F),
                                      at(ball + 0.052F, -0.004F, 0.018F), 0.043F * s, 0.036F * s);
  const float upper = join(join(heel, instep, 0.05F * s), tread, 0.04F * s);
  const float sole = meet(upper - 0.0045F * s, p.y - 0.016F * s, 0.003F * s);
  const float heel_block = std::max(glm::dot(p - at(0.0F, 0, 0), f) - 0.012F * s, p.y - 0.026F * s);
  const float lifted =
      join(std::min(sole, meet(upper - 0.003F * s, heel_block, 0.003F * s)), upper, 0.002F * s);
  const float sole_to_top = meet(lifted, -p.y, 0.004F * s);
  return meet(sole_to_top, p.y - 0.105F * s, 0.012F * s);
}

}  // namespace docent::avatar
