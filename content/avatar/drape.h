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
  std::size_t first = 0;  ///< Of its nodes among those of the body.

  std::size_t size() const noexcept { return place.size(); }
};

/// Hair that stands off the head in tufts: curls, or a beard. Each has a node.
struct Tufts {
  std::vector<Vec3> place{};    ///< Of the nodes. Model frame, metres.
  std::vector<Vec3> outward{};  ///< Unit.
  float reach = 0;              ///< How far from a node what belongs to it is, metres.
  float root = 0, tip = 0;  ///< Metres from the skin, where it begins to swing, and does wholly.
  float stiffness = 0, damping = 0;
  std::size_t first = 0;  ///< Of its nodes among those of the body.

  std::size_t size() const noexcept { return place.size(); }
};

/// What of a body swings. Its nodes come in this order.
struct Drapery {
  Sheet skirt{};   ///< What hangs from a garment's waist; none where it is too short.
  Sheet hair{};    ///< Of long hair, below the ears.
  Sheet behind{};  ///< Of a headscarf, on the back ...
  Sheet before{};  ///< ... and on the breast.
  Tufts beard{}, curls{};

  std::size_t size() const noexcept {
    return skirt.size() + hair.size() + behind.size() + before.size() + beard.size() + curls.size();
  }
};
Drapery drapery_of(const BodyShape& body);

/// What share of a point of the sheet's cloth swings with it: 0 at its top, 1 at the first nodes.
float swinging_share(const Sheet& sheet, Vec3 p);
/// How much of the swinging part belongs to each node; adds up to `share`.
void share_out(const Sheet& sheet, Vec3 p, float share, std::span<float> nodes);
/// Likewise of tufts, `off` metres from the skin.
float swinging_share(const Tufts& tufts, float off);
void share_out(const Tufts& tufts, Vec3 p, float share, std::span<float> nodes);

/// The limbs that keep a body's skirt out, by the joints of thighs and shins, and those that keep
/// its hair out, by the joints of chest, neck and head.
struct ClothJoints {
  std::array<std::size_t, 2> thigh, shin;
  std::size_t chest, neck, head;
};
std::vector<ClothCollider> colliders_of(const BodyShape& body, const ClothJoints& joints);
/// Who carries the nodes is left open.
std::vector<ClothNode> nodes_of(const BodyShape& body, const Drapery& drapery);

}  // namespace docent::avatar
