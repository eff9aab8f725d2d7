#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "runtime/model/geometry/vec2.h"

namespace docent {

/// How a node swings: as a point of cloth that is pushed outwards, or as the end of a bone (VRM's
/// spring bones) that keeps its length, hangs after the bone above it, and leaves limbs by the
/// shortest way.
enum class ClothKind : std::uint8_t { Cloth, Bone, Count };

/// A point of cloth or hair that joints carry and that may swing about where they carry it. Model
/// frame, metres, in the rest pose of its body.
struct ClothNode {
  static constexpr std::uint8_t none = 255;

  ClothKind kind = ClothKind::Cloth;
  std::uint8_t figure = 0;  ///< Which of the bodies wears it.
  std::array<std::uint8_t, 4> joint{};
  std::array<std::uint8_t, 4> weight{};  ///< Of 255; they add up to 255.
  Vec3 place{};
  Vec3 outward{};             ///< Unit: away from the limbs that are below it.
  std::uint8_t above = none;  ///< The node that it hangs from, of the same body; comes before it.
  std::uint8_t left = none, right = none;  ///< Its neighbours in the cloth.
  float radius = 0;                        ///< It keeps so far out of colliders: metres.
  std::uint32_t keeps_out = 0;             ///< Of which colliders of its body: bit i of the i-th.
  float stiffness = 0;  ///< 1/s2: how strongly it goes back to where it is carried.
  float damping = 0;    ///< 1/s: of its motion about that.
  float drag = 0;       ///< 1/s: of its motion through the air.
  float tension = 0;    ///< 1/s2: how strongly it goes with its neighbours.
  Vec3 root{};          ///< Of a bone: where it begins.
  Vec3 gravity{};  ///< Of a bone: m/s2, world frame; what it hangs by beyond how it was modelled.
};

/// A limb as cloth feels it: a capsule between two spheres. Model frame, in the rest pose.
struct ClothCollider {
  std::uint8_t figure = 0;
  std::uint8_t joint = 0;  ///< That it moves with.
  Vec3 from{}, to{};
  float from_radius = 0, to_radius = 0;
};

/// A body has at most so many colliders.
inline constexpr std::size_t most_cloth_colliders = 32;
/// No collider is thicker: metres. (A museum's own character may have a ball over its head that
/// keeps hair down.)
inline constexpr float most_cloth_radius = 3;

/// No spring is stiffer, and none damps more: what a step of 1/120 s follows.
inline constexpr float most_cloth_pull = 2000, most_cloth_damping = 100;
/// No bone is pulled down more strongly: m/s2.
inline constexpr float most_cloth_gravity = 500;

/// All cloth of some bodies, body after body.
struct Cloth {
  std::vector<ClothNode> node;
  std::vector<ClothCollider> collider;
};

}  // namespace docent
