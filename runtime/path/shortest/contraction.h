#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

namespace docent::path {

/// A directed graph with lengths, made ready for searches that only go to more important nodes:
/// a contraction hierarchy (Geisberger, Sanders, Schultes, Delling 2008). Every shortest way of the
/// graph is as long as one that goes up from its start to some node and down from there to its end.
struct Hierarchy {
  /// A way to (or from) a more important node.
  struct Arc {
    std::uint32_t node;
    std::uint32_t
        link;  ///< Below the number of links of the graph: that one. Others are shortcuts.
    double length;
  };
  std::uint32_t first_shortcut = 0;
  std::vector<std::uint32_t> rank;  ///< One per node: its place in the order of importance.
  /// Arcs that leave node n upwards, and those that come down to it from above.
  std::vector<std::vector<Arc>> up, down;
  /// Shortcut first_shortcut + i is link shortcut[2 i] and then link shortcut[2 i + 1].
  std::vector<std::uint32_t> shortcut;
};

/// One arc of a graph to be contracted.
struct Link {
  std::uint32_t from, to;
  double length;
  std::uint32_t name;  ///< What the hierarchy calls it: below `names`.
};

/// Contracts a graph. Lengths are not negative. None where that would take more than `most_work`
/// steps (graphs that many ways lead through everywhere, such as a lattice of columns, have no
/// nodes that are more important than others), nor where a stop is requested.
std::optional<Hierarchy> contract(std::uint32_t nodes, std::span<const Link> links,
                                  std::uint32_t names, std::uint64_t most_work,
                                  const std::stop_token& stop);

}  // namespace docent::path
