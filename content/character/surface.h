#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "content/character/human_bone.h"
#include "content/character/springs.h"
#include "content/character/standing.h"
#include "content/import/gltf/model.h"

namespace docent::character {

/// At most four bones that a vertex follows; their shares add up to 1. Those with no share are
/// hips.
struct BoneShares {
  std::array<std::uint8_t, 4> bone{};  ///< HumanBone; from bone_count on, SpringBone.
  std::array<float, 4> share{};
};

/// A vertex of a character as it was modelled: the frame of Standing.
struct SurfaceVertex {
  Vec3 position{};
  Vec3 normal{};
  glm::vec2 uv{0};
  Vec4 tint{1};  ///< The vertex's own colour, linear, with opacity.
  std::int32_t material = import::gltf::none;
  BoneShares shares{};
};

struct Surface {
  std::vector<SurfaceVertex> vertices;
  std::vector<std::uint32_t> indices;  ///< Triangles, counter-clockwise seen from outside.
};

/// What the whole of a character measures at rest.
struct Extent {
  std::size_t triangles = 0;  ///< In the file's scene.
  Vec3 low{0}, high{0};       ///< Of everything drawn, in the frame of Standing.
};
Extent extent_of(const import::gltf::Model& model, const Standing& standing);

static_assert(bone_count + most_spring_bones <= 255);

/// The bone of the body that one of BoneShares is or hangs on.
inline HumanBone body_bone(const Springs& springs, std::uint8_t bone) noexcept {
  return bone < bone_count ? static_cast<HumanBone>(bone) : springs.bone[bone - bone_count].body;
}

/// All triangles of the scene, bound to human bones and to those that swing: each joint to the
/// nearest bone above it in the tree, or else the nearest in space. What hangs in one hand several
/// at a time (an armoury's swords and shields) is left out, and told in `notes`. ContentError
/// (`not-humanoid`) about `file` for a mesh that reaches further from the body than ten times its
/// height.
Surface surface_of(const import::gltf::Model& model, const Standing& standing,
                   const Springs& springs, const std::string& file,
                   std::vector<std::string>& notes);

}  // namespace docent::character
