#include "runtime/scene/uncovered.h"

#include <algorithm>

namespace docent::scene {
namespace {

struct Edges {
  float left = 0, top = 0, right = 1, bottom = 1;
  bool operator==(const Edges&) const = default;
};

/// Cuts off what a rectangle covers of an edge from one end of it to the other.
void cut(Edges& seen, const Edges& by) noexcept {
  if (by.top <= seen.top && by.bottom >= seen.bottom) {
    if (by.left <= seen.left) seen.left = std::clamp(by.right, seen.left, seen.right);
    if (by.right >= seen.right) seen.right = std::clamp(by.left, seen.left, seen.right);
  }
  if (by.left <= seen.left && by.right >= seen.right) {
    if (by.top <= seen.top) seen.top = std::clamp(by.bottom, seen.top, seen.bottom);
    if (by.bottom >= seen.bottom) seen.bottom = std::clamp(by.top, seen.top, seen.bottom);
  }
}

}  // namespace

bool is_opaque(const Quad& quad) noexcept {
  return quad.fill == QuadFill::Solid && quad.colour.a >= 1 && quad.clip == Clip{};
}

/// `softness` is a share of the shorter side, which is at most a whole of either.
Rect reach_of(const Quad& quad) noexcept {
  constexpr float least = 1e-4F;  // even what has no size can be told from nothing
  const float beyond = std::max(quad.fill == QuadFill::Shadow ? quad.softness : 0, least);
  return {quad.rect.x - beyond, quad.rect.y - beyond, quad.rect.width + 2 * beyond,
          quad.rect.height + 2 * beyond};
}

Rect uncovered(std::span<const Quad> quads) noexcept {
  Edges seen, before;
  do {  // what is cut off may make an edge shorter, so that another is covered whole
    before = seen;
    for (const Quad& quad : quads)
      if (is_opaque(quad) && quad.corner <= 0)
        cut(seen, {quad.rect.x, quad.rect.y, quad.rect.x + quad.rect.width,
                   quad.rect.y + quad.rect.height});
  } while (seen != before);
  if (seen.left >= seen.right || seen.top >= seen.bottom) return {};
  return {seen.left, seen.top, seen.right - seen.left, seen.bottom - seen.top};
}

}  // namespace docent::scene
