#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "runtime/path/shortest/core_labels.h"

namespace docent::path {

/// A directed graph with lengths, made ready for searches that only go to more important nodes:
/// a contraction hierarchy (Geisberger, Sanders, Schultes, Delling 2008) of the nodes that are
/// cheap to contract, and a core of those that are not. Every shortest way of the graph is as long
/// as one that goes up from its start to some node, or up into the core and through it, and down
/// from there to its end.
struct Hierarchy {
  /// A way to (or from) a more important node. `link`, where it is below the number of links of the
  /// graph, is that one; others are shortcuts.
  using Arc = CoreGraph::Arc;
  std::uint32_t first_shortcut = 0;
  std::vector<std::uint32_t> rank;  ///< One per node: its place in the order of importance. Those
                                    ///< of the core share the last.
  /// Arcs that leave node n upwards, and those that come down to it from above.
  std::vector<std::vector<Arc>> up, down;
  /// Shortcut first_shortcut + i is link shortcut[2 i] and then link shortcut[2 i + 1].
  std::vector<std::uint32_t> shortcut;
  std::vector<std::uint32_t> core;     ///< The nodes of the core.
  std::vector<std::uint32_t> in_core;  ///< Per node: where it is in `core`; none where it is not.
  CoreGraph core_graph;                ///< Its nodes are places in `core`.
};

/// One arc of a graph to be contracted.
struct Link {
  std::uint32_t from, to;
  double length;
  std::uint32_t name;  ///< What the hierarchy calls it: below `names`.
};

/// Contracts a graph. Lengths are not negative. What is left when the next node would bring more
/// than `most_added` arcs is the core. None for graphs too dense to contract, nor where a stop is
/// requested.
std::optional<Hierarchy> contract(std::uint32_t nodes, std::span<const Link> links,
                                  std::uint32_t names, std::size_t most_added,
                                  const std::stop_token& stop);

}  // namespace docent::path
