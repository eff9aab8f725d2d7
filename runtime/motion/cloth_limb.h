#pragma once

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "runtime/model/geometry/vec2.h"

/// Limbs as cloth feels them, and what it takes to be out of one. Metres, one frame for all.
namespace docent::motion {

inline constexpr int most_parts = 4;          // of a way out of a limb
inline constexpr float least_room = 0.0002F;  // metres: then it is out
inline constexpr float most_turn = 0.999F;    // cosine: below it a node turns with its cloth

/// A limb at one moment.
struct Limb {
  Vec3 from, along;
  float from_radius, more_radius;
  float inverse_length;  ///< Of its square; 0: a ball.
};

/// How far along `outward` a ball has to go to be out of a limb, as the part of the limb that is
/// nearest now has it: metres.
inline float way_out_of_nearest(const Limb& limb, Vec3 point, float around, Vec3 outward) noexcept {
  const Vec3 off = point - limb.from;
  const float share = std::clamp(glm::dot(off, limb.along) * limb.inverse_length, 0.0F, 1.0F);
  const float radius = limb.from_radius + share * limb.more_radius + around;
  const Vec3 across = off - share * limb.along;
  const float inside = radius * radius - glm::dot(across, across);
  if (inside <= 0) return 0;
  // Beside the limb only what leads across its axis leads out of it; past its end all does.
  const bool beside = share > 0 && share < 1;
  const Vec3 way =
      beside ? outward - (glm::dot(outward, limb.along) * limb.inverse_length) * limb.along
             : outward;
  const float quick = std::max(glm::dot(way, way), 0.04F);
  const float toward = glm::dot(across, way);
  return (std::sqrt(toward * toward + quick * inside) - toward) / quick;
}

/// The same, out of all of the limb.
inline float way_out(const Limb& limb, Vec3 point, float around, Vec3 outward) noexcept {
  float whole = 0;
  for (int part = 0; part < most_parts; ++part) {
    const float more = way_out_of_nearest(limb, point + whole * outward, around, outward);
    if (more <= 0) break;
    whole += more + least_room;
  }
  return whole;
}

/// The turn that takes one direction to another by the shortest way; none where they are opposite.
class ShortestTurn {
 public:
  ShortestTurn(Vec3 from, Vec3 to) noexcept {
    const float lengths = std::sqrt(glm::dot(from, from) * glm::dot(to, to));
    if (!(lengths > 1e-9F)) return;
    const float cosine = glm::dot(from, to) / lengths;
    if (cosine < -most_turn) return;
    cosine_ = cosine;
    axis_ = glm::cross(from, to) / lengths;
    along_ = 1 / (1 + cosine);
  }
  /// Rodrigues' formula.
  Vec3 operator*(Vec3 v) const noexcept {
    return cosine_ * v + glm::cross(axis_, v) + along_ * glm::dot(axis_, v) * axis_;
  }
  glm::mat3 operator*(const glm::mat3& m) const noexcept {
    return {*this * m[0], *this * m[1], *this * m[2]};
  }

 private:
  Vec3 axis_{0};  ///< As long as the sine.
  float cosine_ = 1, along_ = 0.5F;
};

/// A place out of a limb by so much at least, by the shortest way. What is not a number, or lies
/// on the limb's own axis, stays where it is.
inline Vec3 out_of(const Limb& limb, Vec3 point, float around) noexcept {
  const Vec3 off = point - limb.from;
  const float share = std::clamp(glm::dot(off, limb.along) * limb.inverse_length, 0.0F, 1.0F);
  const float radius = limb.from_radius + share * limb.more_radius + around;
  const Vec3 across = off - share * limb.along;
  const float square = glm::dot(across, across);
  if (!(square < radius * radius) || square < 1e-12F) return point;
  return point + (radius / std::sqrt(square) - 1) * across;
}

}  // namespace docent::motion
