#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "runtime/model/geometry/vec2.h"

namespace docent::path {

/// A rectangle with sides along x and y.
struct Box {
  Vec2 low{}, high{};
};

inline double squared_distance(const Box& box, Vec2 point) noexcept {
  const Vec2 apart = point - glm::clamp(point, box.low, box.high);
  return dot(apart, apart);
}

/// Things, each in a box, in a balanced tree, to meet those nearest to a point first. Immutable.
class BoxTree {
 public:
  BoxTree() = default;
  explicit BoxTree(std::span<const Box> boxes);

  /// Meets things in the order of their distance from `point`, as long as `go_on(thing)` says so.
  /// `squared_distance_of(thing)` is the thing's own distance, squared: at least that of its box.
  /// Expected cost: logarithmic in the number of boxes, linear in the number of things met.
  template <class Distance, class GoOn>
  void meet_nearest_first(Vec2 point, Distance squared_distance_of, GoOn go_on) const;

 private:
  static constexpr std::uint32_t leaf_size = 4;
  struct Node {
    Box box;
    std::uint32_t first = 0;  ///< Leaf: first place in `thing_`. Else: children first, first + 1.
    std::uint32_t count = 0;  ///< Of things; 0 for a node with children.
  };
  void build(std::uint32_t node, std::uint32_t first, std::uint32_t count);

  std::vector<Box> box_;  ///< Per thing.
  std::vector<std::uint32_t> thing_;
  std::vector<Node> node_;
};

template <class Distance, class GoOn>
void BoxTree::meet_nearest_first(Vec2 point, Distance squared_distance_of, GoOn go_on) const {
  enum class Kind : std::uint8_t { Group, Thing, Measured };
  struct Waiting {
    double squared_distance;
    Kind kind;
    std::uint32_t index;
  };
  // Of equally near ones the lowest index comes first: answers do not depend on the heap.
  const auto later = [](const Waiting& a, const Waiting& b) {
    if (a.squared_distance != b.squared_distance) return a.squared_distance > b.squared_distance;
    if (a.kind != b.kind) return a.kind > b.kind;
    return a.index > b.index;
  };
  std::vector<Waiting> heap;
  heap.reserve(64);
  const auto push = [&](double distance, Kind kind, std::uint32_t index) {
    heap.push_back({distance, kind, index});
    std::ranges::push_heap(heap, later);
  };
  if (!node_.empty()) push(squared_distance(node_[0].box, point), Kind::Group, 0);
  while (!heap.empty()) {
    std::ranges::pop_heap(heap, later);
    const Waiting next = heap.back();
    heap.pop_back();
    switch (next.kind) {
      case Kind::Group: {
        const Node& node = node_[next.index];
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
          push(squared_distance(box_[thing_[i]], point), Kind::Thing, thing_[i]);
        if (node.count == 0)
          for (const std::uint32_t child : {node.first, node.first + 1})
            push(squared_distance(node_[child].box, point), Kind::Group, child);
        break;
      }
      case Kind::Thing:
        push(squared_distance_of(next.index), Kind::Measured, next.index);
        break;
      case Kind::Measured:
        if (!go_on(next.index)) return;
        break;
    }
  }
}

}  // namespace docent::path
