#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "content/object/shape.h"

namespace docent::object {

using Corners = std::array<Vec3, 3>;

/// Of a place from a triangle. One without an area is the line or place that it covers.
float squared_distance(Vec3 place, const Corners& triangle) noexcept;

/// Triangles in a tree of boxes, which says how far a place is from the nearest.
class Surface {
 public:
  /// Of one triangle at least.
  explicit Surface(std::vector<Corners> triangles);

  /// Squared. Whatever is not above `enough` is as good as the least; `most` where none is nearer.
  float squared_distance_from(Vec3 place, float enough, float most) noexcept;

 private:
  struct Node {
    Vec3 low{0}, high{0};
    std::uint32_t first = 0,
                  count = 0;  ///< Triangles, or where `count` is 0, the first of two nodes.
  };

  void split(std::uint32_t node, std::uint32_t begin, std::uint32_t end);

  std::vector<Corners> triangles_;
  std::vector<Node> nodes_;
  std::uint32_t last_ = 0;  ///< The nearest of the last place: of the next one it is seldom far.
};

}  // namespace docent::object
