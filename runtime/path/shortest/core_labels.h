#pragma once

#include <cstddef>
#include <cstdint>
#include <expected>
#include <stop_token>
#include <vector>

namespace docent::path {

/// Sums of the same lengths in another order differ by less, as a share.
inline constexpr double same_length = 1e-12;

/// A directed graph: for each node the arcs that leave it and those that come to it.
struct CoreGraph {
  struct Arc {
    std::uint32_t node;
    std::uint32_t link;  ///< The caller's name of the arc.
    double length;
  };
  std::vector<std::vector<Arc>> out, in;
};

/// For each node the hubs that a shortest way from it (to it) passes, with the distance: the hub of
/// any shortest way is in both ends' labels. Made hub by hub, each searched only as far as those
/// before it do not give the distance already (Akiba, Iwata and Yoshida 2013). The next hub is the
/// node that most of the ways in a sample of shortest-way trees still pass (Delling, Goldberg,
/// Pajor and Werneck 2014).
struct CoreLabels {
  struct Entry {
    std::uint32_t hub;   ///< By importance: 0 is the first.
    std::uint32_t next;  ///< The node after this one on the way to the hub (before it, from there).
    std::uint32_t link;  ///< The arc between them.
    double length;
  };
  std::vector<std::uint32_t> node_of_hub, hub_of_node;
  std::vector<std::vector<Entry>> leaving, arriving;  ///< Per node, by hub.

  /// A hub of a node's label; null where it is none.
  static const Entry* find(const std::vector<Entry>& label, std::uint32_t hub) noexcept;
};

/// Where labels would have more than `most_entries` entries: how many there would be at least,
/// found out early. 0 where a stop is requested.
std::expected<CoreLabels, std::size_t> make_core_labels(const CoreGraph& graph,
                                                        std::size_t most_entries,
                                                        const std::stop_token& stop);

}  // namespace docent::path
