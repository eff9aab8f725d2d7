#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "runtime/model/geometry/vec2.h"
#include "runtime/model/pixels.h"

/// glTF 2.0 as plain values. Names are those of its specification; indices have been checked, and
/// numbers are finite.
namespace docent::import::gltf {

constexpr std::int32_t none = -1;
/// An index that is not none, for lists.
constexpr std::size_t entry(std::int32_t index) noexcept {
  return static_cast<std::size_t>(index);
}

struct Node {
  std::string name;
  std::int32_t parent = none;  ///< Comes before the node in `Model::order`.
  std::vector<std::int32_t> children;
  Mat4 local{1};
  std::int32_t mesh = none, skin = none;
  bool in_scene = false;
};

/// Triangles. The lists are empty or have an entry a vertex.
struct Primitive {
  std::vector<Vec3> position, normal;
  std::vector<glm::vec2> uv;  ///< Of the material's base texture, laid out as the texture wants it.
  std::vector<Vec4> colour;   ///< Linear, with opacity.
  std::vector<std::array<std::uint16_t, 4>> joint;  ///< Of the skin's joints.
  std::vector<Vec4> weight;                         ///< Add up to 1.
  std::vector<std::uint32_t> indices;
  std::int32_t material = none;
};
struct Mesh {
  std::string name;
  std::vector<Primitive> primitives;
};

struct Skin {
  std::vector<std::int32_t> joints;  ///< Nodes.
  std::vector<Mat4> inverse_bind;    ///< One a joint.
};

enum class AlphaMode : std::uint8_t { Opaque, Mask, Blend };
enum class Wrap : std::uint8_t { Repeat, Clamp, Mirror };

struct Material {
  std::string name;
  Vec4 base{1};  ///< Linear, with opacity.
  Vec3 emissive{0};
  std::int32_t image = none;  ///< Of the base colour.
  std::uint32_t uv_set = 0;
  glm::vec2 uv_offset{0}, uv_scale{1};
  float uv_turn = 0;  ///< Radians.
  std::array<Wrap, 2> wrap{};
  AlphaMode alpha = AlphaMode::Opaque;
  float alpha_cutoff = 0.5F;
  bool double_sided = false;
};

/// A joint that swings, as VRM 1.0 has it (VRMC_springBone): in metres of the world, and such that
/// forces act 60 times a second.
struct SpringJoint {
  std::int32_t node = none;
  float stiffness = 1;   ///< 0 or more.
  Vec3 gravity{0};       ///< Direction times power.
  float drag = 0.5F;     ///< 0 to 1.
  float hit_radius = 0;  ///< 0 or more.
};
/// A chain of them, from the top down. The last is only the end of the one before.
struct Spring {
  std::string part;  ///< Of the file: "extensions.VRMC_springBone.springs[0]".
  std::vector<SpringJoint> joints;
  bool takes_all_below = false;  ///< As VRM 0.x has it: one joint, and all that hangs on it.
  std::vector<std::uint32_t> colliders;  ///< Of `Vrm::colliders`.
};
/// A ball, or a capsule, that springs keep out of; in the frame of its node.
struct SpringCollider {
  std::int32_t node = none;
  Vec3 from{0}, to{0};
  float radius = 0;  ///< 0 or more.
};

/// What VRM 0.x and 1.0 say of a character beyond its shape.
struct Vrm {
  struct Bone {
    std::string bone;  ///< As VRM 1.0 names it: "leftUpperArm".
    std::int32_t node = none;
  };
  std::string version;  ///< "0.x" or "1.0"; empty where the file is no VRM.
  std::vector<Bone> bones;
  std::vector<std::string> expressions;  ///< As the file names them.
  std::size_t spring_count = 0;          ///< Chains of joints that the file says swing.
  std::vector<Spring> springs{};         ///< Those of them that can be used.
  std::vector<SpringCollider> colliders{};
};

struct Model {
  std::vector<Node> nodes;
  std::vector<std::int32_t> order;  ///< All nodes, parents before children.
  std::vector<Mesh> meshes;         ///< Those that the scene does not show are empty.
  std::vector<Skin> skins;
  std::vector<Material> materials;
  std::vector<Pixels> images;  ///< Empty where none needs it, or it could not be read.
  Vrm vrm;
  std::vector<std::string> warnings;  ///< Sentences without a full stop.
};

}  // namespace docent::import::gltf
