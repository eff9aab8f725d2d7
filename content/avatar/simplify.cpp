#include "content/avatar/simplify.h"

#include <cmath>
#include <numbers>

#include <meshoptimizer.h>

namespace docent::avatar {
namespace {

void drop_unused(TriangleSurface& surface) {
  constexpr std::uint32_t unused = 0xFFFFFFFF;
  std::vector<std::uint32_t> moved_to(surface.position.size(), unused);
  std::vector<Vec3> position;
  for (std::uint32_t& v : surface.indices) {
    if (moved_to[v] == unused) {
      moved_to[v] = static_cast<std::uint32_t>(position.size());
      position.push_back(surface.position[v]);
    }
    v = moved_to[v];
  }
  surface.position = std::move(position);
}

}  // namespace

std::function<Vec3(Vec3)> wavy(float edge, float error) {
  // An arc of height 2 h over half a wave is cut off by h in the middle.
  return [edge, height = 1.2F * error](Vec3 p) {
    const float wave = height * std::sin(std::numbers::pi_v<float> * p.y / edge);
    return p + Vec3{wave, 0, wave};
  };
}

void simplify(TriangleSurface& surface, const SimplifyLimits& limits) {
  if (surface.indices.size() <= 3 * limits.triangles) return drop_unused(surface);
  std::vector<Vec3> place = surface.position;
  if (limits.lens)
    for (Vec3& p : place) p = limits.lens(p);
  const float scale = meshopt_simplifyScale(&place[0].x, place.size(), sizeof(Vec3));
  std::vector<std::uint32_t> left(surface.indices.size());
  left.resize(meshopt_simplify(left.data(), surface.indices.data(), surface.indices.size(),
                               &place[0].x, place.size(), sizeof(Vec3), 3 * limits.triangles,
                               limits.error / scale, 0, nullptr));
  surface.indices = std::move(left);
  drop_unused(surface);
}

}  // namespace docent::avatar
