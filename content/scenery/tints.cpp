#include "content/scenery/tints.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace docent::scenery {
namespace {

struct Box {
  Vec2 low{1e30, 1e30}, high{-1e30, -1e30};
};

Box box_of(const std::vector<Vec2>& outline) {
  Box box;
  for (const Vec2 p : outline) {
    box.low = glm::min(box.low, p);
    box.high = glm::max(box.high, p);
  }
  return box;
}

/// Rooms that a thick wall parts are neighbours, those across a corner too.
bool are_neighbours(const Box& a, const Box& b) {
  constexpr double wall = 1.5;  // metres
  return a.low.x < b.high.x + wall && b.low.x < a.high.x + wall && a.low.y < b.high.y + wall &&
         b.low.y < a.high.y + wall;
}

}  // namespace

void tint_apart(std::span<PavedArea> areas) {
  std::vector<Box> boxes;
  std::array<std::size_t, floor_tints> used{};
  for (PavedArea& area : areas) {
    const Box box = box_of(area.outline);
    std::array<std::size_t, floor_tints> beside{};
    for (std::size_t i = 0; i < boxes.size(); ++i)
      if (are_neighbours(box, boxes[i])) ++beside[areas[i].tint];
    std::uint8_t best = 0;
    for (std::uint8_t tint = 1; tint < floor_tints; ++tint)
      if (std::tie(beside[tint], used[tint]) < std::tie(beside[best], used[best])) best = tint;
    area.tint = best;
    ++used[best];
    boxes.push_back(box);
  }
}

}  // namespace docent::scenery
