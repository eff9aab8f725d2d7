#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "content/avatar/body.h"
#include "content/avatar/drape.h"
#include "runtime/model/motion/skinned_mesh.h"

namespace docent::avatar {

/// What a vertex follows: a region of the body with its own rule.
enum class BodyRegion : std::uint8_t {
  Head,
  Hair,
  Beard,
  Scarf,
  Coat,
  LeftHand,
  RightHand,
  LeftLeg,
  RightLeg,
};

/// At most four joints and their shares, which add up to 255.
struct JointShares {
  std::array<std::uint8_t, 4> joint{};
  std::array<std::uint8_t, 4> weight{};
};

/// Gives skin and cloth to the joints.
///
/// Along a limb, a joint takes over from its parent across a plane that halves the angle between
/// their bones, softly over a few centimetres. The coat's skirt goes to the thighs the more the
/// lower it is, to the left and right one by the side it is on. That is how its cloth is carried;
/// its vertices go to the cloth's nodes, which swing about that, where a skeleton leaves room for
/// them among `most_joints`.
class SkinWeights {
 public:
  SkinWeights(const Skeleton& skeleton, const BodyShape& body);

  JointShares at(Vec3 p, BodyRegion region) const;
  /// What swings; nothing where there is no room for it.
  const Cloth& cloth() const noexcept { return cloth_; }

 private:
  /// A joint takes what lies beyond `point` in the direction of `normal`, softly over `softness`.
  struct Boundary {
    std::size_t joint;
    Vec3 point, normal;
    float softness;
  };
  using Chain = std::vector<Boundary>;
  using Shares = std::vector<float>;

  void add_chain(const Chain& chain, Vec3 p, float share, Shares& shares) const;
  void add_coat(Vec3 p, Shares& shares) const;
  void add_head(Vec3 p, Shares& shares) const;
  void add_hair(Vec3 p, Shares& shares) const;
  void add_beard(Vec3 p, Shares& shares) const;
  void add_scarf(Vec3 p, Shares& shares) const;
  void hang_cloth(const Skeleton& skeleton);
  bool swings() const noexcept { return !cloth_.node.empty(); }
  /// Gives a share of what a point has so far to a part of the drapery.
  template <typename Part>
  void let_swing(const Part& part, Vec3 p, float share, Shares& shares) const;
  template <typename Part>
  std::span<float> nodes(const Part& part, Shares& shares) const {
    return std::span(shares).subspan(joint_count_ + part.first, part.size());
  }

  const BodyShape& body_;
  std::size_t joint_count_;
  std::size_t chest_, head_;
  std::array<std::size_t, 2> thigh_, clavicle_;
  Chain spine_;  ///< Root to chest.
  Chain neck_;   ///< Chest to the last joint before the head.
  std::array<Chain, 2> arm_, leg_;
  Drapery drapery_;
  Cloth cloth_;
};

}  // namespace docent::avatar
