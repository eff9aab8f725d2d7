#include "runtime/path/index/box_tree.h"

#include <numeric>

namespace docent::path {

BoxTree::BoxTree(std::span<const Box> boxes) : box_(boxes.begin(), boxes.end()) {
  if (box_.empty()) return;
  thing_.resize(box_.size());
  std::iota(thing_.begin(), thing_.end(), 0U);
  node_.emplace_back();
  build(0, 0, static_cast<std::uint32_t>(thing_.size()));
}

/// Halves the things of [first, first + count) at the middle of the longer side, and so on.
void BoxTree::build(std::uint32_t node, std::uint32_t first, std::uint32_t count) {
  Box around = box_[thing_[first]];
  for (std::uint32_t i = first + 1; i < first + count; ++i) {
    around.low = glm::min(around.low, box_[thing_[i]].low);
    around.high = glm::max(around.high, box_[thing_[i]].high);
  }
  node_[node] = {around, first, count};
  if (count <= leaf_size) return;
  const Vec2 size = around.high - around.low;
  const int axis = size.x >= size.y ? 0 : 1;
  const auto middle_of = [&](std::uint32_t thing) {
    return std::pair(box_[thing].low[axis] + box_[thing].high[axis], thing);
  };
  const auto begin = thing_.begin() + first;
  std::ranges::nth_element(begin, begin + count / 2, begin + count, {}, middle_of);
  const auto children = static_cast<std::uint32_t>(node_.size());
  node_.resize(node_.size() + 2);
  node_[node].first = children;
  node_[node].count = 0;
  build(children, first, count / 2);
  build(children + 1, first + count / 2, count - count / 2);
}

}  // namespace docent::path
