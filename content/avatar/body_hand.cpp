#include <array>

#include "content/avatar/body.h"

namespace docent::avatar {
namespace {

/// The hand's own frame: `down` along the fingers, `thumb` forward across the palm, `palm` out of
/// its inner face, towards the body. Measures in it are metres on a person of 1.70 m, shaped for
/// this avatar; `s` scales them.
struct HandFrame {
  Vec3 wrist, down, thumb, palm;
  float s;

  Vec3 at(float along, float across, float inward) const {
    return wrist + (down * along + thumb * across + palm * inward) * s;
  }
};

HandFrame hand_frame(const BodyShape& body, Side side) {
  const LimbPoints& limb = body.limb(side);
  const Vec3 down = limb.hand_axis;
  // A hanging hand turns its palm inward and a little back.
  const Vec3 inward{-sign_of(side), 0, -0.35F};
  const Vec3 palm = glm::normalize(inward - down * glm::dot(inward, down));
  const Vec3 cross = glm::cross(down, palm);
  return {limb.wrist, down, cross.z > 0 ? cross : -cross, palm, body.scale};
}

/// A finger of three bones that bends towards the palm by `curl` radians at each knuckle and goes
/// `spread` to the side for each metre of its length. Forefinger first; metres, hand frame.
struct Finger {
  float across, knuckle, length, radius, curl, spread;
};
constexpr std::array<Finger, 4> fingers{{{0.028F, 0.092F, 0.073F, 0.0090F, 0.30F, 0.02F},
                                         {0.010F, 0.096F, 0.080F, 0.0092F, 0.36F, 0.00F},
                                         {-0.010F, 0.093F, 0.074F, 0.0088F, 0.42F, -0.01F},
                                         {-0.027F, 0.086F, 0.058F, 0.0078F, 0.48F, -0.03F}}};

float finger_distance(const HandFrame& frame, Vec3 p, const Finger& finger) {
  constexpr std::array<float, 3> bone{0.45F, 0.31F, 0.24F};
  float along = finger.knuckle;
  float inward = 0.002F;
  float across = finger.across;
  float bend = 0.14F;
  float radius = finger.radius;
  float d = 1;
  for (const float share : bone) {
    const Vec3 from = frame.at(along, across, inward);
    bend += finger.curl;
    const float length = share * finger.length;
    along += length * std::cos(bend);
    inward += length * std::sin(bend);
    across += length * finger.spread;
    const float tip = radius - 0.0008F;
    d = join(
        d,
        tapered_capsule(p, from, frame.at(along, across, inward), radius * frame.s, tip * frame.s),
        0.004F * frame.s);
    radius = tip;
  }
  return d;
}

}  // namespace

float hand(const BodyShape& body, Vec3 p, Side side) {
  const HandFrame frame = hand_frame(body, side);
  const float s = frame.s;
  const float wrist = tapered_capsule(p, frame.at(-0.05F, 0, 0), frame.at(0.015F, 0.001F, 0),
                                      0.027F * s, 0.0245F * s);
  const glm::mat3 axes(frame.thumb, frame.down, frame.palm);
  // The palm is a fan, narrow at the wrist, arched over the knuckles.
  const Vec3 off = (p - frame.wrist) / s;
  const float along = glm::dot(off, frame.down);
  const float narrow = 1 - 0.26F * smoothstep(0.085F, 0.015F, along);
  const Vec3 fanned = p + frame.thumb * (glm::dot(off, frame.thumb) * (1 / narrow - 1) * s);
  const float back = 0.8F * rounded_box(fanned, frame.at(0.053F, 0.001F, 0.001F), axes,
                                        Vec3{0.0375F, 0.047F, 0.0130F} * s, 0.0125F * s);
  const float ball = tapered_capsule(p, frame.at(0.022F, 0.020F, 0.008F),
                                     frame.at(0.055F, 0.034F, 0.013F), 0.017F * s, 0.0125F * s);
  float d = join(join(wrist, back, 0.03F * s), ball, 0.015F * s);
  for (const Finger& finger : fingers) d = join(d, finger_distance(frame, p, finger), 0.006F * s);
  const float thumb_root =
      tapered_capsule(p, frame.at(0.030F, 0.028F, 0.010F), frame.at(0.068F, 0.049F, 0.018F),
                      0.0135F * s, 0.0105F * s);
  const float thumb_tip =
      tapered_capsule(p, frame.at(0.068F, 0.049F, 0.018F), frame.at(0.096F, 0.052F, 0.024F),
                      0.0105F * s, 0.0085F * s);
  return join(d, join(thumb_root, thumb_tip, 0.006F * s), 0.01F * s);
}

}  // namespace docent::avatar
