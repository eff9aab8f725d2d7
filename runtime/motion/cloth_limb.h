#pragma once

#include <array>

#include <glm/geometric.hpp>

#include "runtime/motion/lanes.h"

/// Limbs as cloth feels them, and what it takes to be out of one. Metres, one frame for all.
namespace docent::motion {

inline constexpr int most_parts = 4;          // of a way out of a limb
inline constexpr float least_room = 0.0002F;  // metres: then it is out
inline constexpr float most_turn = 0.999F;    // cosine: below it a node turns with its cloth

/// A limb at one moment.
struct Limb {
  Vec3Lanes from, along;
  float from_radius, more_radius;
  float inverse_length;  ///< Of its square; 0: a ball.
};

/// Where places are beside a limb.
struct BesideLimb {
  Lanes share, radius;  ///< Of its length; of a ball's middle from its axis.
  Vec3Lanes across;     ///< From its axis.
  Lanes square;         ///< Of that.
  LaneMask inside;

  BesideLimb(const Limb& limb, const Vec3Lanes& point, Lanes around) noexcept {
    const Vec3Lanes off = point - limb.from;
    share =
        smaller(larger(dot(off, limb.along) * limb.inverse_length, Lanes{}), in_all_lanes(1.0F));
    radius = limb.from_radius + share * limb.more_radius + around;
    across = off - share * limb.along;
    square = dot(across, across);
    inside = square < radius * radius;
  }
};

/// How far along `outward` balls have to go to be out of a limb, as the part of the limb that is
/// nearest now has it: metres.
inline Lanes way_out_of_nearest(const Limb& limb, const BesideLimb& it,
                                const Vec3Lanes& outward) noexcept {
  // Beside the limb only what leads across its axis leads out of it; past its end all does.
  const LaneMask beside = (it.share > 0) & (it.share < 1);
  const Lanes led = beside ? dot(outward, limb.along) * limb.inverse_length : Lanes{};
  const Vec3Lanes way = outward - led * limb.along;
  const Lanes quick = larger(dot(way, way), in_all_lanes(0.04F));
  const Lanes toward = dot(it.across, way);
  const Lanes inside = it.radius * it.radius - it.square;
  const Lanes out = (root_of(larger(toward * toward + quick * inside, Lanes{})) - toward) / quick;
  return it.inside ? out : Lanes{};
}

/// The same, out of all of the limb.
inline Lanes way_out(const Limb& limb, const Vec3Lanes& point, Lanes around,
                     const Vec3Lanes& outward) noexcept {
  Lanes whole{};
  for (int part = 0; part < most_parts; ++part) {
    const BesideLimb it(limb, point + whole * outward, around);
    if (!any(it.inside)) break;
    const Lanes more = way_out_of_nearest(limb, it, outward);
    whole += more > 0 ? more + least_room : Lanes{};
  }
  return whole;
}

/// Places out of a limb by so much at least, by the shortest way. What is not a number, or lies on
/// the limb's own axis, stays where it is.
inline LaneMask is_moved_out_of(const Limb& limb, Vec3Lanes& point, Lanes around) noexcept {
  const BesideLimb it(limb, point, around);
  const LaneMask moves = it.inside & (it.square >= 1e-12F);
  if (!any(moves)) return moves;
  const Lanes square = moves ? it.square : in_all_lanes(1.0F);
  const Lanes more = moves ? it.radius / root_of(square) - 1 : Lanes{};
  point = point + more * it.across;
  return moves;
}

/// The turns that take some directions to others by the shortest way; none where they are opposite.
class ShortestTurn {
 public:
  ShortestTurn(const Vec3Lanes& from, const Vec3Lanes& to) noexcept {
    const Lanes square = dot(from, from) * dot(to, to);
    const LaneMask is_long = square > 1e-18F;
    const Lanes lengths = root_of(is_long ? square : in_all_lanes(1.0F));
    const Lanes cosine = dot(from, to) / lengths;
    const LaneMask turns = is_long & (cosine >= -most_turn);
    cosine_ = turns ? cosine : in_all_lanes(1.0F);
    const Lanes share = turns ? 1 / lengths : Lanes{};
    axis_ = share * cross(from, to);
    along_ = 1 / (1 + cosine_);
  }
  /// About an axis as long as the sine.
  ShortestTurn(const Vec3Lanes& axis, Lanes cosine) noexcept
      : axis_{axis}, cosine_{cosine}, along_{1 / (1 + cosine)} {}

  const Vec3Lanes& axis() const noexcept { return axis_; }
  Lanes cosine() const noexcept { return cosine_; }
  /// Rodrigues' formula.
  Vec3Lanes operator*(const Vec3Lanes& v) const noexcept {
    return cosine_ * v + cross(axis_, v) + (along_ * dot(axis_, v)) * axis_;
  }
  /// The images of x, y and z.
  std::array<Vec3Lanes, 3> axes() const noexcept {
    const auto column = [&](const Lanes& of, Vec3 unit, const Vec3Lanes& crossed) {
      return cosine_ * in_all_lanes(unit) + crossed + (along_ * of) * axis_;
    };
    const Lanes none{};
    return {column(axis_.x, {1, 0, 0}, {none, axis_.z, -axis_.y}),
            column(axis_.y, {0, 1, 0}, {-axis_.z, none, axis_.x}),
            column(axis_.z, {0, 0, 1}, {axis_.y, -axis_.x, none})};
  }

 private:
  Vec3Lanes axis_{};  ///< As long as the sine.
  Lanes cosine_, along_;
};

}  // namespace docent::motion
