#include "content/import/building/wall_line.h"

#include <algorithm>

namespace docent::import {
namespace {

/// Walls whose distances differ by less are equally near. Metres.
constexpr double as_near = 0.02;

class NearestWall {
 public:
  NearestWall(Vec2 point, double farthest) : point_(point), farthest_(farthest) {}

  void look_at(const BuildingRing& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) look_at(ring[i], ring[(i + 1) % ring.size()]);
  }
  [[nodiscard]] std::optional<WallLine> found() const { return found_; }

 private:
  void look_at(Vec2 a, Vec2 b) {
    const double length = glm::distance(a, b);
    if (length < 1e-6) return;
    const Vec2 along = (b - a) / length;
    const Vec2 at = a + along * std::clamp(dot(point_ - a, along), 0.0, length);
    const double away = glm::distance(at, point_);
    if (away > farthest_) return;
    const bool nearer = !found_ || away < found_->distance - as_near;
    const bool longer = found_ && away < found_->distance + as_near && length > length_;
    if (!nearer && !longer) return;
    found_ = WallLine{at, along, away};
    length_ = length;
  }

  Vec2 point_;
  double farthest_;
  double length_ = 0;
  std::optional<WallLine> found_;
};

}  // namespace

std::optional<WallLine> wall_at(const ImportedLevel& level, Vec2 point, double farthest) {
  NearestWall nearest(point, farthest);
  for (const ImportedRoom& room : level.rooms)
    for (const BuildingRing& ring : room.rings) nearest.look_at(ring);
  for (const BuildingRing& ring : level.obstacles) nearest.look_at(ring);
  return nearest.found();
}

}  // namespace docent::import
