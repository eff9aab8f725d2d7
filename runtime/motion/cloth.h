#pragma once

#include <span>
#include <vector>

#include "runtime/model/motion/cloth.h"

namespace docent::motion {

/// One body's cloth.
struct ClothView {
  std::span<const ClothNode> node;
  std::span<const ClothCollider> collider;
};

/// How the cloth of one body moves: for each node how far it is from where the joints carry it.
/// World frame, metres.
struct ClothMotion {
  std::vector<Vec3> lag, lag_before;    ///< Now, and one step of the clock earlier.
  std::vector<Vec3> velocity;           ///< Metres a second.
  std::vector<Vec3> carried;            ///< Where the joints carry it...
  std::vector<Vec3> carried_before;     ///< ... and where they did at the last call.
  std::vector<Vec3> root, root_before;  ///< Likewise, where bones begin...
  std::vector<Vec3> begin;              ///< ... and where they begin as those above them hang.
  std::vector<Vec3> outward;            ///< Unit.
  std::vector<Vec3> place;              ///< Where it hangs.
  std::vector<Vec3> end, end_before;    ///< Of colliders: from and to, at this call and the last.
  double ahead = 0;                     ///< Seconds of the last call that no step has covered.
  bool is_placed = false;               ///< It has hung somewhere before...
  bool is_at_rest = false;              ///< ... and moves with the joints.
};

/// Room for the cloth of any body with so many nodes.
ClothMotion make_cloth_motion(std::size_t nodes);

/// Hangs the cloth where the joints carry it, out of the limbs. `palette` begins with the joints'
/// matrices, model frame in the rest pose to world; those of the nodes follow and are written.
/// Does not allocate.
void hang(const ClothView& cloth, std::span<Mat4> palette, ClothMotion& motion) noexcept;

/// The same, and lets it swing for so many seconds: springs with damping (Verlet's integration in
/// the joints' frame, as VRM's springBone) in steps of 1/120 s, whatever the frames' length. The
/// cloth of a body that is placed anew, or was not seen for long, hangs still. Does not allocate.
void swing(const ClothView& cloth, double seconds, std::span<Mat4> palette,
           ClothMotion& motion) noexcept;

}  // namespace docent::motion
