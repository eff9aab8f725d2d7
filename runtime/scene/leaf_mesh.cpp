#include "runtime/scene/leaf_mesh.h"

#include <algorithm>
#include <array>

namespace docent::scene {
namespace {

constexpr float thickness = 0.04F;  ///< Metres, of the board.
constexpr float gap = 0.008F;       ///< Between a board and what is about it.
constexpr auto bar = static_cast<float>(bar_thickness);
constexpr float margin = 0.07F;     ///< From the board's edges to the bar's ends.
constexpr float below_cut = 0.02F;  ///< A leaf is as high as the walls about it, but for that.

/// A box in the leaf's own frame: along, up, across.
struct Box {
  Vec3 low, high;
};

/// How a leaf stands in the world.
struct Frame {
  Vec3 origin, along, across;
  Vec3 place(Vec3 p) const noexcept {
    return origin + p.x * along + Vec3(0, p.y, 0) + p.z * across;
  }
  Vec3 direction(Vec3 d) const noexcept { return d.x * along + Vec3(0, d.y, 0) + d.z * across; }
};

void append_box(const Frame& frame, const Box& box, std::vector<SceneryVertex>& mesh) noexcept {
  for (int axis = 0; axis < 3; ++axis)
    for (const bool far : {false, true}) {
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      Vec3 normal{0};
      normal[axis] = far ? 1.0F : -1.0F;
      const auto corner = [&](bool at_u, bool at_v) {
        Vec3 p{0};
        p[axis] = far ? box.high[axis] : box.low[axis];
        p[u] = at_u ? box.high[u] : box.low[u];
        p[v] = at_v ? box.high[v] : box.low[v];
        return SceneryVertex{
            .position = frame.place(p), .normal = frame.direction(normal), .sky = 235, .sun = 150};
      };
      // Along, up and across are right-handed as x, y and z are.
      const std::array ring{corner(false, false), corner(far, !far), corner(true, true),
                            corner(!far, far)};
      for (const std::size_t i : {0, 1, 2, 0, 2, 3}) mesh.push_back(ring[i]);
    }
}

Frame frame_of(const LeafDraw& leaf) noexcept {
  const Vec3 along = to_world(leaf.along);
  return {to_world(leaf.hinge, leaf.floor_height), along, glm::cross(along, Vec3(0, 1, 0))};
}

void append_board(const LeafDraw& leaf, std::vector<SceneryVertex>& mesh) noexcept {
  const auto top = static_cast<float>(cut_height) - below_cut;
  append_box(frame_of(leaf), {{gap, gap, -thickness / 2}, {leaf.width - gap, top, thickness / 2}},
             mesh);
}

void append_bars(const LeafDraw& leaf, std::vector<SceneryVertex>& mesh) noexcept {
  constexpr auto height = static_cast<float>(bar_height);
  constexpr auto surface = static_cast<float>(bar_surface);
  const Frame frame = frame_of(leaf);
  const float end = leaf.width - margin;
  for (const float side : {-1.0F, 1.0F}) {
    const auto between = [&](float from, float to, float inner, float outer) {
      const float a = side * inner, b = side * outer;
      append_box(frame,
                 {{from, height - bar / 2, std::min(a, b)}, {to, height + bar / 2, std::max(a, b)}},
                 mesh);
    };
    between(margin, end, surface - bar, surface);
    between(margin, margin + bar, thickness / 2, surface - bar);
    between(end - bar, end, thickness / 2, surface - bar);
  }
}

}  // namespace

std::size_t make_leaves(std::span<const LeafDraw> leaves,
                        std::vector<SceneryVertex>& mesh) noexcept {
  mesh.clear();
  leaves = leaves.first(
      std::min(leaves.size(), mesh.capacity() / (vertices_of_a_leaf + vertices_of_its_bars)));
  for (const LeafDraw& leaf : leaves) append_board(leaf, mesh);
  const std::size_t bars = mesh.size();
  for (const LeafDraw& leaf : leaves) append_bars(leaf, mesh);
  return bars;
}

}  // namespace docent::scene
