#include "content/compile/check_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>

#include "runtime/model/geometry/polygon.h"
#include "runtime/model/geometry/segment.h"
#include "runtime/model/none.h"

namespace docent::compile {

namespace {

using import::ImportedPolygon;
using import::ImportedRing;

constexpr double touching = 1e-6;  // metres

struct Box {
  Vec2 low{infinity, infinity}, high{-infinity, -infinity};
};

Box box_of(std::span<const Vec2> points) {
  Box box;
  for (const Vec2 p : points) box = {glm::min(box.low, p), glm::max(box.high, p)};
  return box;
}

bool are_near(const Box& a, const Box& b, double reach) {
  return a.low.x <= b.high.x + reach && b.low.x <= a.high.x + reach &&
         a.low.y <= b.high.y + reach && b.low.y <= a.high.y + reach;
}

/// How far two areas are apart, and where.
struct Separation {
  double distance = infinity;
  Vec2 at{};
  import::SourcePlace place;
};

void consider_edges(const ImportedRing& a, const ImportedRing& b, const Box& box_of_b,
                    Separation& nearest) {
  for (std::size_t i = 0; i < a.vertex.size(); ++i) {
    const Vec2 p = a.vertex[i], q = a.vertex[(i + 1) % a.vertex.size()];
    if (!are_near(box_of(std::array{p, q}), box_of_b, widest_gap)) continue;
    for (std::size_t j = 0; j < b.vertex.size(); ++j) {
      const Vec2 r = b.vertex[j], s = b.vertex[(j + 1) % b.vertex.size()];
      const double distance = std::sqrt(segment_distance_squared(p, q, r, s));
      if (distance < nearest.distance) {
        const bool at_p = distance_to_segment(p, r, s) <= distance_to_segment(q, r, s);
        nearest = {distance, at_p ? p : q, a.place[at_p ? i : (i + 1) % a.vertex.size()]};
      }
    }
  }
}

bool holds(const ImportedPolygon& polygon, Vec2 p) {
  return contains(polygon.outer.vertex, p) &&
         std::ranges::none_of(polygon.holes,
                              [&](const ImportedRing& hole) { return contains(hole.vertex, p); });
}

/// The polygons of a plan, and which of them touch.
class DrawnParts {
 public:
  explicit DrawnParts(const import::ImportedPlan& plan)
      : polygons_(plan.polygons), parent_(plan.polygons.size()), touched_(plan.polygons.size()) {
    std::iota(parent_.begin(), parent_.end(), 0U);
    for (const ImportedPolygon& polygon : polygons_) boxes_.push_back(box_of(polygon.outer.vertex));
    for (std::uint32_t a = 0; a < polygons_.size(); ++a)
      for (std::uint32_t b = a + 1; b < polygons_.size(); ++b)
        if (are_near(boxes_[a], boxes_[b], widest_gap)) compare(a, b);
  }

  std::vector<PlanGap> gaps() {
    std::map<std::pair<std::uint32_t, std::uint32_t>, Separation> between;
    for (const auto& [pair, separation] : near_) {
      const std::uint32_t a = part_of(pair.first), b = part_of(pair.second);
      const std::pair<std::uint32_t, std::uint32_t> parts{std::min(a, b), std::max(a, b)};
      if (parts.first == parts.second) continue;
      Separation& nearest = between[parts];
      if (separation.distance < nearest.distance) nearest = separation;
    }
    std::vector<PlanGap> found;
    for (const auto& [parts, separation] : between)
      found.push_back({separation.distance, separation.at, separation.place});
    std::ranges::sort(found, {}, [](const PlanGap& gap) {
      return std::tuple(gap.place.file, gap.place.line, gap.place.column);
    });
    return found;
  }

  [[nodiscard]] std::uint32_t touched(std::size_t polygon) const { return touched_[polygon]; }

 private:
  void compare(std::uint32_t a, std::uint32_t b) {
    const ImportedPolygon &first = polygons_[a], &second = polygons_[b];
    Separation separation;
    consider_edges(first.outer, second.outer, boxes_[b], separation);
    const bool nested =
        holds(first, second.outer.vertex.front()) || holds(second, first.outer.vertex.front());
    if (nested || separation.distance <= touching) {
      parent_[part_of(a)] = part_of(b);
      ++touched_[a];
      ++touched_[b];
    } else if (separation.distance <= widest_gap) {
      near_.push_back({{a, b}, separation});
    }
  }

  std::uint32_t part_of(std::uint32_t polygon) {
    while (parent_[polygon] != polygon) polygon = parent_[polygon] = parent_[parent_[polygon]];
    return polygon;
  }

  const std::vector<ImportedPolygon>& polygons_;
  std::vector<Box> boxes_;
  std::vector<std::uint32_t> parent_, touched_;
  std::vector<std::pair<std::pair<std::uint32_t, std::uint32_t>, Separation>> near_;
};

/// As small and thin as the floor of a doorway.
bool is_doorway(const ImportedPolygon& polygon) {
  constexpr double largest = 3, deepest = 0.7;  // square metres, metres
  const double area = std::abs(signed_area(polygon.outer.vertex));
  const Box box = box_of(polygon.outer.vertex);
  const Vec2 size = box.high - box.low;
  return area > 0 && area <= largest && area / std::max(size.x, size.y) <= deepest &&
         polygon.holes.empty();
}

}  // namespace

std::vector<PlanGap> plan_gaps(const import::ImportedPlan& plan) {
  return DrawnParts(plan).gaps();
}

std::vector<Diagnostic> dangling_doorways(const import::ImportedPlan& plan) {
  std::vector<Diagnostic> found;
  const DrawnParts parts(plan);
  for (std::size_t i = 0; i < plan.polygons.size(); ++i) {
    const ImportedPolygon& polygon = plan.polygons[i];
    if (parts.touched(i) != 1 || !is_doorway(polygon)) continue;
    const import::SourcePlace place = polygon.outer.place.front();
    const Box box = box_of(polygon.outer.vertex);
    const Vec2 middle = (box.low + box.high) * 0.5;
    found.push_back(
        {.file = plan.files[place.file],
         .line = place.line,
         .column = place.column,
         .severity = Severity::Warning,
         .code = "dangling-doorway",
         .message = fmt::format("the doorway about [{:.2f}, {:.2f}] leads nowhere: it touches one "
                                "area only",
                                middle.x, middle.y),
         .hint = "draw it as far as the next room, or leave it out"});
  }
  return found;
}

}  // namespace docent::compile
