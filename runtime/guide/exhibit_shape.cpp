#include "runtime/guide/exhibit_shape.h"

#include <cmath>
#include <limits>

namespace docent::guide {
namespace {

constexpr double breast_height = 1.25;  ///< Metres.

ExhibitShape shape_of(const Museum& museum, std::uint32_t exhibit) {
  const Exhibit& it = museum.exhibits[exhibit];
  constexpr float far = std::numeric_limits<float>::max();
  Vec3 low(far), high(-far);
  const auto take_in = [&](const Scenery& scenery, const SceneryPart& part) {
    for (std::uint32_t i = 0; i < part.index_count; ++i) {
      const Vec3 p = scenery.vertices[scenery.indices[part.first_index + i]].position;
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
  };
  if (it.floor < museum.scenery.size())
    for (const SceneryPart& part : museum.scenery[it.floor].parts)
      if (part.exhibit == static_cast<std::int32_t>(exhibit))
        take_in(museum.scenery[it.floor], part);
  if (it.object >= 0 && it.floor < museum.floors.size()) {
    const ObjectStand& stand = it.stand;
    const Vec3 size =
        static_cast<float>(stand.scale) * museum.objects[static_cast<std::size_t>(it.object)].size;
    // Whichever way it is turned.
    const float half = std::hypot(size.x, size.z) / 2;
    const Vec3 foot = to_world(stand.position, museum.floors[it.floor].plan.height + stand.base);
    low = foot - Vec3{half, 0, half};
    high = foot + Vec3{half, size.y, half};
  }
  const double height = it.floor < museum.floors.size() ? museum.floors[it.floor].plan.height : 0;
  if (low.x > high.x) low = high = to_world(it.placement.position, height + breast_height);
  const Vec2 a = to_floor(low), b = to_floor(high);
  return {(low + high) / 2.0F, glm::min(a, b), glm::max(a, b), (high.y - low.y) / 2};
}

}  // namespace

std::vector<ExhibitShape> exhibit_shapes(const Museum& museum) {
  std::vector<ExhibitShape> shapes;
  for (std::uint32_t i = 0; i < museum.exhibits.size(); ++i) shapes.push_back(shape_of(museum, i));
  return shapes;
}

double distance_to(const ExhibitShape& shape, Vec2 point) noexcept {
  return glm::distance(point, glm::clamp(point, shape.low, shape.high));
}

}  // namespace docent::guide
