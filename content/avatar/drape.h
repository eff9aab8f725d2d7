#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "content/avatar/body.h"
#include "runtime/model/motion/cloth.h"

namespace docent::avatar {

/// Cloth or hair as chains that hang side by side, each with the same number of nodes.
struct Sheet {
  bool round = false;  ///< All round the body; else across it.
  std::vector<float>
      across{};     ///< Of each chain, ascending: radians from the front; else x, metres.
  float top = 0;    ///< y from which on it begins to swing...
  float whole = 0;  ///< ... and where it does wholly, if that is above its first nodes.
  std::vector<float> height{};  ///< Of its nodes, from the top down.
  std::vector<Vec3> place{};    ///< Of its nodes, chain by chain. Model frame, metres.
  std::vector<Vec3> outward{};  ///< Unit.
  float stiffness = 0, tension = 0;

  std::size_t size() const noexcept { return place.size(); }
};

/// What hangs from a garment's waist; none where it is too short to swing.
Sheet skirt_of(const BodyShape& body);
/// Long hair, below the ears; none else.
Sheet long_hair_of(const BodyShape& body);

/// What share of a point of the sheet's cloth swings with it: 0 at its top, 1 at the first nodes.
float swinging_share(const Sheet& sheet, Vec3 p);
/// How much of the swinging part belongs to each node; adds up to `share`.
void share_out(const Sheet& sheet, Vec3 p, float share, std::span<float> nodes);

/// The limbs that keep a body's skirt out, by the joints of thighs and shins, and those that keep
/// its hair out, by the joints of chest and neck.
struct ClothJoints {
  std::array<std::size_t, 2> thigh, shin;
  std::size_t chest, neck;
};
std::vector<ClothCollider> colliders_of(const BodyShape& body, const ClothJoints& joints);
/// Nodes of both sheets, the skirt's first. Who carries them is left open.
std::vector<ClothNode> nodes_of(const BodyShape& body, const Sheet& skirt, const Sheet& hair);

}  // namespace docent::avatar
