#include "content/character/surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <span>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "content/character/find_bones.h"
#include "content/content_error.h"
#include "content/import/gltf/placing.h"

namespace docent::character {
namespace {

/// From the hips, in heights of the body: wings, trains and halberds stay within it.
constexpr float farthest_part = 10;

using import::gltf::entry;
using import::gltf::Model;
using import::gltf::Node;
using import::gltf::Placing;
using import::gltf::Primitive;

/// Which bone each node goes with.
class BoneOfNode {
 public:
  BoneOfNode(const Model& model, const Standing& standing, const Springs& springs)
      : bone_(model.nodes.size(), -1) {
    for (std::size_t n = 0; n < bone_.size(); ++n)
      if (springs.bone_of_node[n] >= 0)
        bone_[n] = static_cast<std::int32_t>(bone_count) + springs.bone_of_node[n];
    for (std::size_t b = 0; b < bone_count; ++b)
      if (standing.bones.node[b] >= 0)
        bone_[entry(standing.bones.node[b])] = static_cast<std::int32_t>(b);
    for (const std::int32_t n : model.order) {
      std::int32_t& bone = bone_[entry(n)];
      const std::int32_t parent = model.nodes[entry(n)].parent;
      if (bone < 0 && parent >= 0) bone = bone_[entry(parent)];
    }
    for (std::size_t n = 0; n < bone_.size(); ++n)
      if (bone_[n] < 0) bone_[n] = nearest(standing, Vec3(standing.bind[n][3]));
  }
  std::uint8_t operator[](std::int32_t node) const {
    return static_cast<std::uint8_t>(bone_[entry(node)]);
  }

 private:
  static std::int32_t nearest(const Standing& standing, Vec3 place) {
    std::int32_t best = 0;
    float least = std::numeric_limits<float>::max();
    for (std::size_t b = 0; b < bone_count; ++b) {
      if (standing.bones.node[b] < 0) continue;
      const float distance = glm::distance(standing.at_bind(static_cast<HumanBone>(b)), place);
      if (distance < least) {
        least = distance;
        best = static_cast<std::int32_t>(b);
      }
    }
    return best;
  }

  std::vector<std::int32_t> bone_;
};

BoneShares merged(const std::array<std::pair<std::uint8_t, float>, 4>& parts) {
  BoneShares shares;
  std::size_t count = 0;
  for (const auto& [bone, share] : parts) {
    if (!(share > 0)) continue;
    const auto end = shares.bone.begin() + static_cast<std::ptrdiff_t>(count);
    const auto at =
        static_cast<std::size_t>(std::find(shares.bone.begin(), end, bone) - shares.bone.begin());
    if (at == count) shares.bone[count++] = bone;
    shares.share[at] += share;
  }
  return shares;
}

/// Nodes whose meshes are held several at once in one hand.
std::vector<bool> held_at_once(const Model& model, const BoneOfNode& bone_of,
                               std::vector<std::string>& notes) {
  std::map<std::int32_t, std::vector<std::int32_t>> held;
  for (const std::int32_t n : model.order) {
    const Node& node = model.nodes[entry(n)];
    if (!node.in_scene || node.mesh < 0 || node.skin >= 0 || node.parent < 0) continue;
    const auto bone = static_cast<HumanBone>(bone_of[n]);
    if (bone == HumanBone::LeftHand || bone == HumanBone::RightHand) held[node.parent].push_back(n);
  }
  std::vector<bool> is_held(model.nodes.size());
  for (const auto& [hand, nodes] : held) {
    if (nodes.size() < 2) continue;
    std::string names;
    for (const std::int32_t n : nodes) {
      is_held[entry(n)] = true;
      names += fmt::format("{}{}", names.empty() ? "" : ", ", model.nodes[entry(n)].name);
    }
    notes.push_back(fmt::format("{} things hang in one hand at once and are left out: {}",
                                nodes.size(), names));
  }
  return is_held;
}

/// Appends a primitive; normals that it lacks are those of its triangles.
void add_primitive(const Placing& placing, const Primitive& primitive,
                   const std::vector<BoneShares>& shares, Surface& surface) {
  std::vector<SurfaceVertex> vertices(primitive.position.size());
  std::size_t mirrored = 0;
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const Mat4 to_world = placing.at(v);
    SurfaceVertex& it = vertices[v];
    it.position = Vec3(to_world * Vec4(primitive.position[v], 1));
    const glm::mat3 linear(to_world);
    const float determinant = glm::determinant(linear);
    if (determinant < 0) ++mirrored;
    if (!primitive.normal.empty()) {
      // The cofactors are the inverse transpose but for a factor, and defined for flat ones too.
      const glm::mat3 cofactor(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                               glm::cross(linear[0], linear[1]));
      const Vec3 normal = cofactor * primitive.normal[v] * (determinant < 0 ? -1.0F : 1.0F);
      const float length = glm::length(normal);
      it.normal = length > 1e-12F && std::isfinite(length) ? normal / length : Vec3{0};
    }
    if (!primitive.uv.empty()) it.uv = primitive.uv[v];
    if (!primitive.colour.empty()) it.tint = primitive.colour[v];
    it.material = primitive.material;
    it.shares = shares[v];
  }
  std::vector<std::uint32_t> indices = primitive.indices;
  if (2 * mirrored > vertices.size())
    for (std::size_t k = 0; k + 2 < indices.size(); k += 3)
      std::swap(indices[k + 1], indices[k + 2]);

  const auto first = static_cast<std::uint32_t>(surface.vertices.size());
  if (!primitive.normal.empty()) {
    surface.vertices.insert(surface.vertices.end(), vertices.begin(), vertices.end());
    for (const std::uint32_t i : indices) surface.indices.push_back(first + i);
    return;
  }
  for (std::size_t k = 0; k + 2 < indices.size(); k += 3) {
    const Vec3 a = vertices[indices[k]].position;
    const Vec3 across =
        glm::cross(vertices[indices[k + 1]].position - a, vertices[indices[k + 2]].position - a);
    const float length = glm::length(across);
    for (std::size_t c = 0; c < 3; ++c) {
      SurfaceVertex corner = vertices[indices[k + c]];
      corner.normal = length > 1e-20F ? across / length : Vec3{0, 1, 0};
      surface.indices.push_back(static_cast<std::uint32_t>(surface.vertices.size()));
      surface.vertices.push_back(corner);
    }
  }
}

/// Refuses a mesh that has a vertex far from the body, or nowhere: such a body has no size.
void refuse_far_parts(const Model& model, const Standing& standing, std::int32_t node,
                      std::span<const SurfaceVertex> vertices, const std::string& file) {
  const Vec3 hips = standing.at_bind(HumanBone::Hips);
  const float height =
      glm::distance(standing.at_bind(HumanBone::Head), standing.at_bind(HumanBone::LeftFoot));
  for (const SurfaceVertex& v : vertices)
    if (!(glm::distance(v.position, hips) <= farthest_part * height)) {
      const std::string& name = model.meshes[entry(model.nodes[entry(node)].mesh)].name;
      throw content::ContentError(
          file, 0, 0, "not-humanoid",
          fmt::format("its mesh \"{}\" reaches more than {} times the body's height away from the "
                      "hips, as no part of a person does",
                      name.empty() ? fmt::format("#{}", model.nodes[entry(node)].mesh) : name,
                      farthest_part),
          "export the character without its surroundings, and its skin in the skeleton's own size");
    }
}

}  // namespace

Extent extent_of(const Model& model, const Standing& standing) {
  Extent extent;
  bool is_first = true;
  import::gltf::for_each_primitive(model, [&](std::int32_t node, const Primitive& primitive) {
    extent.triangles += primitive.indices.size() / 3;
    const Placing placing(model, standing.rest, node, primitive);
    for (std::size_t v = 0; v < primitive.position.size(); ++v) {
      const Vec3 place(placing.at(v) * Vec4(primitive.position[v], 1));
      extent.low = is_first ? place : glm::min(extent.low, place);
      extent.high = is_first ? place : glm::max(extent.high, place);
      is_first = false;
    }
  });
  return extent;
}

Surface surface_of(const Model& model, const Standing& standing, const Springs& springs,
                   const std::string& file, std::vector<std::string>& notes) {
  const BoneOfNode bone_of(model, standing, springs);
  const std::vector<bool> is_held = held_at_once(model, bone_of, notes);
  Surface surface;
  import::gltf::for_each_primitive(model, [&](std::int32_t n, const Primitive& primitive) {
    if (is_held[entry(n)]) return;
    const std::int32_t skin = model.nodes[entry(n)].skin;
    const bool is_skinned = skin >= 0 && !primitive.joint.empty();
    std::vector<BoneShares> shares(primitive.position.size(), {.bone = {bone_of[n]}, .share = {1}});
    for (std::size_t v = 0; is_skinned && v < shares.size(); ++v) {
      const import::gltf::Skin& it = model.skins[entry(skin)];
      std::array<std::pair<std::uint8_t, float>, 4> parts{};
      for (std::size_t k = 0; k < 4; ++k)
        parts[k] = {
            bone_of[it.joints[std::min<std::size_t>(primitive.joint[v][k], it.joints.size() - 1)]],
            primitive.weight[v][static_cast<int>(k)]};
      shares[v] = merged(parts);
    }
    const std::size_t first = surface.vertices.size();
    add_primitive(Placing(model, standing.bind, n, primitive), primitive, shares, surface);
    refuse_far_parts(model, standing, n, std::span(surface.vertices).subspan(first), file);
  });
  return surface;
}

}  // namespace docent::character
