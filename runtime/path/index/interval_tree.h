#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "runtime/model/none.h"

namespace docent::path {

/// A half-open range of numbers.
struct Interval {
  double low = 0, high = 0;
  bool contains(double x) const noexcept { return low <= x && x < high; }
};

/// Intervals in a tree, to find all that contain a number: in time logarithmic in their number and
/// linear in how many are found (de Berg et al., "Computational Geometry", 10.1). Immutable.
class IntervalTree {
 public:
  IntervalTree() = default;
  explicit IntervalTree(std::span<const Interval> intervals);

  /// Calls visit(i) for each interval that contains x; always in the same order.
  template <class Visitor>
  void visit_containing(double x, Visitor visit) const {
    for (std::uint32_t n = node_.empty() ? none : 0; n != none;) {
      const Node& node = node_[n];
      const bool below = x < node.centre;
      const auto& sorted = below ? by_low_ : by_high_;
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
        if (!interval_[sorted[i]].contains(x)) break;
        visit(sorted[i]);
      }
      n = below ? node.below : node.above;
    }
  }

 private:
  /// Holds the intervals that contain its centre; the rest lie below it or above it.
  struct Node {
    double centre = 0;
    std::uint32_t first = 0, count = 0;  ///< In by_low_ and by_high_.
    std::uint32_t below = none, above = none;
  };
  std::uint32_t build(std::vector<std::uint32_t> rest);

  std::vector<Interval> interval_;
  std::vector<std::uint32_t> by_low_;   ///< Within each node: lowest low first.
  std::vector<std::uint32_t> by_high_;  ///< Within each node: highest high first.
  std::vector<Node> node_;
};

}  // namespace docent::path
