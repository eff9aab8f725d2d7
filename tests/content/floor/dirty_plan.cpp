#include "tests/content/floor/dirty_plan.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace docent::test {
namespace {

/// Areas, each an outline with its holes.
using Areas = std::vector<std::vector<Points>>;

Points hall_of_shape(int shape) {
  switch (shape) {
    case 0:
      return rectangle({0, 0}, {12, 8});
    case 1:
      return {{0, 0}, {12, 0}, {12, 3}, {5, 3}, {5, 8}, {0, 8}};
    case 2:
      return regular_polygon({6, 4}, 6, 9, 11);
    default:  // A star.
      Points star;
      for (int i = 0; i < 14; ++i) {
        const double angle = i * std::numbers::pi / 7, radius = i % 2 == 0 ? 6.5 : 4;
        star.push_back(Vec2{6, 4} + radius * Vec2{std::cos(angle), std::sin(angle)});
      }
      return star;
  }
}

std::size_t pick(int from, std::size_t count) {
  return static_cast<std::size_t>(from) % count;
}

/// Does one soiling after another.
class Soiler {
 public:
  explicit Soiler(Areas& areas) : areas_(areas) {}

  void apply(const Soiling& soiling) {
    const auto [kind, ring, vertex, a, b] = soiling;
    amount_ = {a / 100.0, b / 100.0};
    vertex_ = vertex;
    std::vector<Points>& area = areas_[pick(ring, areas_.size())];
    Points& points = area[pick(ring / 3, area.size())];
    const std::vector<Points> more =
        soil(static_cast<Dirt>(kind), points, area[pick(vertex, area.size())]);
    area.insert(area.end(), more.begin(), more.end());
    if (static_cast<Dirt>(kind) == Dirt::Room) add_room();
  }

 private:
  /// Returns cases to add.
  std::vector<Points> soil(Dirt dirt, Points& points, const Points& other) {
    const std::size_t i = pick(vertex_, points.size()), next = (i + 1) % points.size();
    const auto at = points.begin() + static_cast<std::ptrdiff_t>(i);
    const Vec2 corner = points[i], along = points[next] - corner;
    switch (dirt) {
      case Dirt::Nudge:
        points[i] += 0.003 * amount_;
        break;
      case Dirt::Repeat:
        points.insert(at, corner + (vertex_ % 2 == 0 ? 0.0 : 0.0006) * amount_);
        break;
      case Dirt::Spike:
        points.insert(at, {corner, corner + 4.0 * amount_});
        if (vertex_ % 2 == 0) points[i] += 0.00004 * left_of(amount_);
        break;
      case Dirt::Cross:
        std::swap(points[i], points[(i + 2) % points.size()]);
        break;
      case Dirt::TouchWall:
      case Dirt::TouchCorner: {
        const std::size_t j = pick(vertex_ / 2, other.size());
        const double part = dirt == Dirt::TouchCorner ? 0 : 0.5 + 0.5 * amount_.x;
        const Vec2 target = other[j] + part * (other[(j + 1) % other.size()] - other[j]);
        for (Vec2& point : points) point += target - corner;
        break;
      }
      case Dirt::Sliver: {
        if (along == Vec2{}) break;
        const Vec2 across = 0.001 * left_of(along) / glm::length(along);
        const Vec2 from = corner + across, to = corner + (0.6 + 0.5 * amount_.x) * along + across;
        return {{from, to, to + across, from + across}};
      }
      case Dirt::Needle:
        return {{corner, corner + 12.0 * amount_, corner + 11.0 * amount_ + Vec2{0.0, 0.01}}};
      case Dirt::Backwards:
        std::ranges::reverse(points);
        break;
      case Dirt::Twin:
        return {points};
      case Dirt::Flat:
        return {{corner, corner + 3.0 * amount_, corner + 2.0 * amount_}};
      case Dirt::Room:
        break;
    }
    return {};
  }

  void add_room() {
    const Vec2 low = Vec2{6, 4} + 12.0 * amount_;
    areas_.push_back({rectangle(low, low + Vec2{3, 2})});
  }

  Areas& areas_;
  Vec2 amount_{};
  int vertex_ = 0;
};

Vec2 placed(Vec2 p, Where where) {
  switch (where) {
    case Where::AtOrigin:
      return p;
    case Where::InMapMetres:
      return p + Vec2{500123.25, -341.5};
    case Where::FarInMapMetres:
      return p + Vec2{654321.7, 5765432.1};
    case Where::InDegrees:
      return {-122.3877 + p.x / 88190.0, 37.6152 + p.y / 110990.0};
  }
  return p;
}

}  // namespace

std::string geojson(const DirtyPlan& plan) {
  Areas areas{{hall_of_shape(plan.shape)}};
  for (const Obstacle& obstacle : plan.obstacles) areas[0].push_back(corners_of(obstacle));
  Soiler soiler(areas);
  for (const Soiling& soiling : plan.soilings) soiler.apply(soiling);

  std::string text = R"({"type": "MultiPolygon", "coordinates": [)";
  for (std::size_t a = 0; a < areas.size(); ++a) {
    text += a == 0 ? "[" : ",\n[";
    for (std::size_t r = 0; r < areas[a].size(); ++r) {
      text += r == 0 ? "[" : ",\n [";
      Points closed = areas[a][r];
      closed.push_back(closed.front());
      for (std::size_t i = 0; i < closed.size(); ++i) {
        const Vec2 p = placed(closed[i], plan.where);
        text += fmt::format("{}[{}, {}]", i == 0 ? "" : ", ", p.x, p.y);
      }
      text += "]";
    }
    text += "]";
  }
  return text + "]}";
}

}  // namespace docent::test
