#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/model/motion/cloth.h"
#include "runtime/motion/lanes.h"

namespace docent::motion {

/// One body's cloth.
struct ClothView {
  std::span<const ClothNode> node;
  std::span<const ClothCollider> collider;
};

/// Up to four nodes of a cloth that are moved together: none hangs from another of them, and those
/// from which they hang come before them. A lane that is left over does as the first.
struct ClothBatch {
  std::array<std::uint8_t, lane_count> node{};
  std::array<std::uint8_t, lane_count> above{}, below{}, beside{}, left{}, right{};  ///< Or itself.
  std::uint8_t count = 0;
  ClothKind kind = ClothKind::Cloth;
  std::uint32_t keeps_out = 0;  ///< Of what any of them does.
  LaneMask is_kept_out{}, hangs{};
  Lanes radius{}, stiffness{}, damping{}, drag{}, tension{}, most_inward{};
  Vec3Lanes gravity{};
  // World frame, metres: now, and at the last call.
  Vec3Lanes carried{}, carried_before{};    ///< Where the joints carry it.
  Vec3Lanes above_it{}, above_it_before{};  ///< From where what it hangs from is carried, to it...
  Vec3Lanes length{}, length_before{};      ///< ... and from where a bone begins, to its end.
  Vec3Lanes begin{};                        ///< Where bones begin as those above them hang.
  Vec3Lanes outward{};                      ///< Unit.
  Vec3Lanes lag{}, lag_before{};            ///< From there, now, and one step of the clock earlier.
  Vec3Lanes velocity{};                     ///< Metres a second.
};

/// A node at one moment, x, y and z in the first lanes.
struct ClothNodeNow {
  Lanes carried, outward, lag, lag_before, place;
  Lanes turn;  ///< Of a bone: its axis, as long as the sine of how far; the cosine.
};

/// How the cloth of one body moves. World frame, metres.
struct ClothMotion {
  std::vector<Vec3> carried;           ///< Where the joints carry each node...
  std::vector<Vec3> place;             ///< ... and where it hangs.
  std::vector<ClothBatch> batch;       ///< All nodes, as many as there are now...
  std::size_t batches = 0, nodes = 0;  ///< ... of the body that it hung on last.
  std::vector<ClothNodeNow> now;       ///< The nodes, as others of the batches look them up.
  std::vector<Vec3> end, end_before;   ///< Of colliders: from and to, at this call and the last.
  double ahead = 0;                    ///< Seconds of the last call that no step has covered.
  bool is_placed = false;              ///< It has hung somewhere before...
  bool is_at_rest = false;             ///< ... and moves with the joints.
};

/// Room for the cloth of any body with so many nodes.
ClothMotion make_cloth_motion(std::size_t nodes);

/// Hangs the cloth where the joints carry it, out of the limbs. `palette` begins with the joints'
/// matrices, model frame in the rest pose to world; those of the nodes follow and are written.
/// Does not allocate.
void hang(const ClothView& cloth, std::span<Mat4> palette, ClothMotion& motion) noexcept;

/// The same, and lets it swing for so many seconds: springs with damping (Verlet's integration in
/// the joints' frame, as VRM's springBone) in steps of 1/120 s, whatever the frames' length. The
/// cloth of a body that is placed anew, or was not seen for long, hangs still. It is the cloth that
/// hung last, or one of another number of nodes. Does not allocate.
void swing(const ClothView& cloth, double seconds, std::span<Mat4> palette,
           ClothMotion& motion) noexcept;

}  // namespace docent::motion
