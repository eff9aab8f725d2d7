#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <ranges>
#include <span>
#include <vector>

#include "runtime/model/geometry/vec2.h"
#include "runtime/model/motion/cloth.h"

namespace docent {

/// What a vertex of the avatar is made of; the renderer gives each a colour and roughness.
enum class Material : std::uint8_t {
  Skin,
  Hair,
  Coat,
  Trousers,
  Shoes,
  Shirt,
  Eye,
  White,
  Lips,
  Second,
  Own,  ///< Has its own colour (SkinnedMesh::colour).
  Count
};

/// sRGB red, green, blue.
using VertexColour = std::array<std::uint8_t, 3>;

/// A vertex of the avatar in the rest pose of its skeleton (model frame, metres).
struct SkinnedVertex {
  Vec3 position{};
  Vec3 normal{};
  /// Of the skeleton; after its last come the nodes of the body's cloth.
  std::array<std::uint8_t, 4> joint{};
  std::array<std::uint8_t, 4> weight{};  ///< Of 255; they add up to 255.
  Material material = Material::Skin;
  std::uint8_t occlusion = 255;  ///< Share of open space about it, of 255; 0: wholly enclosed.
};

/// The avatars' bodies, bound to one skeleton of at most 64 joints, one after another: who walks in
/// which is a matter of looks (runtime/scene/look.h). Triangles are counter-clockwise seen from
/// outside, and none joins vertices of two bodies.
struct SkinnedMesh {
  std::vector<SkinnedVertex> vertices;
  std::vector<std::uint32_t> indices;
  std::vector<std::uint32_t> figure_end;  ///< Of each body: how many indices end with it.
  /// Model frame to joint frame in the rest pose, one per joint. Our bodies share their rest pose;
  /// where there is a museum's own, each body has its own: body after body.
  std::vector<Mat4> inverse_bind;
  /// Of the vertices of the last body, where that is a museum's own character: one each, so that
  /// the last vertex has the last colour. Empty where all bodies are ours.
  std::vector<VertexColour> colour{};
  Cloth cloth{};  ///< What swings.
};

inline bool has_own_body(const SkinnedMesh& mesh) noexcept {
  return !mesh.colour.empty();
}
/// How many joints each of the bodies is bound to.
inline std::size_t joints_of(const SkinnedMesh& mesh) noexcept {
  return has_own_body(mesh) ? mesh.inverse_bind.size() / mesh.figure_end.size()
                            : mesh.inverse_bind.size();
}

/// A body's part of what lies in one list, body after body.
template <typename Part>
std::span<const Part> of_figure(const std::vector<Part>& all, std::size_t figure) noexcept {
  const auto part = std::ranges::equal_range(all, figure, {},
                                             [](const Part& p) { return std::size_t{p.figure}; });
  return {part.begin(), part.end()};
}

/// The most nodes of cloth that one of the bodies has.
inline std::size_t nodes_of(const SkinnedMesh& mesh) noexcept {
  std::size_t most = 0, run = 0;
  for (std::size_t n = 0; n < mesh.cloth.node.size(); ++n) {
    run = n > 0 && mesh.cloth.node[n].figure == mesh.cloth.node[n - 1].figure ? run + 1 : 1;
    most = std::max(most, run);
  }
  return most;
}
/// How many matrices one of the bodies is drawn with: those of its joints, then of its cloth.
inline std::size_t matrices_of(const SkinnedMesh& mesh) noexcept {
  return joints_of(mesh) + nodes_of(mesh);
}

}  // namespace docent
