#pragma once

#include <cstdint>
#include <vector>

#include "tests/bench/found_path.h"
#include "tests/bench/plain_sight.h"

namespace docent::bench {

/// The plain visibility graph (Lozano-Perez and Wesley 1979) with A*, for a point: which reflex
/// corners see each other is known beforehand, as far as a taut path may run from one to the other;
/// which of them the ends see is tested when their turn comes. Here to be compared with.
///
/// Borrows the plan. One thread may search at a time.
class VisibilityGraph {
 public:
  explicit VisibilityGraph(const FloorPlan& plan);

  /// The shortest path of a point.
  FoundPath find(Vec2 from, Vec2 to);

 private:
  static constexpr std::uint32_t start = 0xffffffff;

  struct Corner {
    std::uint32_t vertex = 0;
    Vec2 at{}, before{}, after{};  ///< With the vertices before and after it.
  };
  struct Link {
    std::uint32_t corner = 0;
    double length = 0;
  };
  /// A corner to be reached; from the start only if that is seen.
  struct Entry {
    double f = 0, g = 0;
    std::uint32_t corner = 0, parent = start;
  };

  [[nodiscard]] static bool is_taut(const Corner& corner, Vec2 other);
  void push(double g, std::uint32_t corner, std::uint32_t parent);
  [[nodiscard]] FoundPath path_through(std::uint32_t corner) const;

  PlainSight sight_;
  std::vector<Corner> corner_;
  std::vector<std::uint32_t> first_;
  std::vector<Link> link_;
  Vec2 from_{}, to_{};
  std::vector<Entry> open_;            ///< A heap, the smallest f on top.
  std::vector<std::uint32_t> closed_;  ///< Per corner: the query that last closed it.
  std::vector<double> g_;              ///< Per corner: the length up to it, where closed.
  std::vector<std::uint32_t> parent_;
  std::uint32_t query_ = 0;
};

}  // namespace docent::bench
