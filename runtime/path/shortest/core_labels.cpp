#include "runtime/path/shortest/core_labels.h"

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>

#include "runtime/model/none.h"

namespace docent::path {
namespace {

using CoreEntry = CoreLabels::Entry;
using CoreArcs = std::vector<std::vector<CoreGraph::Arc>>;
using CoreLabelList = std::vector<std::vector<CoreEntry>>;

/// A sample has at least so many trees, and so many nodes for each of the graph's.
constexpr std::size_t least_trees = 32, nodes_a_node = 64, most_trees = 4096;
/// A sample is used until the next hub has so much less than the first one.
constexpr std::int64_t stale = 64;

/// Once a sixteenth of the hubs are made, a core of so many nodes, from each of which so many arcs
/// lead, has less than half of its entries: 24 to 38 % in cores of 590 to 2,700 nodes. Graphs as
/// thin as roads may have more.
constexpr std::size_t telling_share = 16, telling_factor = 2, telling_core = 500, telling_arcs = 24;

bool is_telling(const CoreGraph& graph) {
  std::size_t arcs = 0;
  for (const auto& out : graph.out) arcs += out.size();
  return graph.out.size() >= telling_core && arcs >= telling_arcs * graph.out.size();
}

/// The same numbers for the same seed on every machine (Vigna 2015, splitmix64).
class Random {
 public:
  std::uint32_t below(std::size_t count) noexcept {
    state_ += 0x9e3779b97f4a7c15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return static_cast<std::uint32_t>((z ^ (z >> 31U)) % count);
  }

 private:
  std::uint64_t state_ = 1;
};

/// Searches from one node that stop where labels know the distance already.
class PrunedSearch {
 public:
  explicit PrunedSearch(std::size_t nodes)
      : distance_(nodes, infinity), from_(nodes), to_hub_(nodes, infinity) {}

  /// Calls `visit(node, length, next, link)` for each node that is nearer than labels say, by
  /// length. `known` is the root's label, `labels` those that the nodes' are found in.
  template <typename Visit>
  void run(std::uint32_t root, const CoreArcs& arcs, const std::vector<CoreEntry>& known,
           const CoreLabelList& labels, Visit&& visit) {
    for (const CoreEntry& entry : known) to_hub_[entry.hub] = entry.length;
    reach(root, 0, {root, none});
    while (!heap_.empty()) {
      std::ranges::pop_heap(heap_, std::greater<>{});
      const auto [length, node] = heap_.back();
      heap_.pop_back();
      if (length > distance_[node] || is_known(labels[node], length)) continue;
      visit(node, length, from_[node].first, from_[node].second);
      for (const CoreGraph::Arc& arc : arcs[node])
        reach(arc.node, length + arc.length, {node, arc.link});
    }
    for (const std::uint32_t node : touched_) distance_[node] = infinity;
    touched_.clear();
    for (const CoreEntry& entry : known) to_hub_[entry.hub] = infinity;
  }

 private:
  void reach(std::uint32_t node, double length, std::pair<std::uint32_t, std::uint32_t> from) {
    if (length >= distance_[node]) return;
    if (distance_[node] == infinity) touched_.push_back(node);
    distance_[node] = length;
    from_[node] = from;
    heap_.emplace_back(length, node);
    std::ranges::push_heap(heap_, std::greater<>{});
  }
  bool is_known(const std::vector<CoreEntry>& label, double length) const noexcept {
    const double as_short = length * (1 + same_length);
    return std::ranges::any_of(label, [&](const CoreEntry& entry) {
      return to_hub_[entry.hub] + entry.length <= as_short;
    });
  }

  std::vector<double> distance_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> from_;  ///< Node and link.
  std::vector<double> to_hub_;
  std::vector<std::uint32_t> touched_;
  std::vector<std::pair<double, std::uint32_t>> heap_;
};

/// Trees of shortest ways from some nodes, without what labels know: how many of the ways pass each
/// node.
class Sample {
 public:
  explicit Sample(std::size_t nodes) : passing_(nodes, 0), places_(nodes) {}

  void clear() {
    for (const Place& place : place_) {
      passing_[place.node] = 0;
      places_[place.node].clear();
    }
    place_.clear();
    trees_ = 0;
  }
  void begin_tree() noexcept {
    ++trees_;
    tree_begin_ = place_.size();
  }
  /// Parents come before their children.
  void add(std::uint32_t node, std::uint32_t parent) {
    const auto place = static_cast<std::uint32_t>(place_.size());
    Place added{.node = node};
    if (parent != node) {
      added.parent = places_[parent].back();
      added.next_sibling = std::exchange(place_[added.parent].first_child, place);
    }
    place_.push_back(added);
    places_[node].push_back(place);
  }
  void end_tree() {
    for (std::size_t i = place_.size(); i-- > tree_begin_;) {
      passing_[place_[i].node] += place_[i].below;
      if (place_[i].parent != none) place_[place_[i].parent].below += place_[i].below;
    }
  }

  std::size_t trees() const noexcept { return trees_; }
  std::size_t size() const noexcept { return place_.size(); }
  std::int64_t passing(std::uint32_t node) const noexcept { return passing_[node]; }
  /// Calls `visit(node)` once for each node that is in a tree.
  template <typename Visit>
  void for_each_node(Visit&& visit) const {
    for (std::uint32_t place = 0; place < place_.size(); ++place)
      if (places_[place_[place].node].front() == place) visit(place_[place].node);
  }

  /// Ways by this node count no more.
  void take_out(std::uint32_t node) {
    for (const std::uint32_t place : places_[node]) {
      if (!place_[place].is_alive) continue;
      const std::int64_t below = place_[place].below;
      for (std::uint32_t up = place_[place].parent; up != none; up = place_[up].parent) {
        place_[up].below -= below;
        passing_[place_[up].node] -= below;
      }
      take_out_below(place);
    }
  }

 private:
  struct Place {
    std::uint32_t node = 0, parent = none, first_child = none, next_sibling = none;
    std::int64_t below = 1;  ///< Nodes that the tree reaches through here, with this one.
    bool is_alive = true;
  };
  void take_out_below(std::uint32_t top) {
    open_.assign(1, top);
    while (!open_.empty()) {
      Place& place = place_[open_.back()];
      open_.pop_back();
      if (!place.is_alive) continue;
      place.is_alive = false;
      passing_[place.node] -= place.below;
      for (std::uint32_t child = place.first_child; child != none;
           child = place_[child].next_sibling)
        open_.push_back(child);
    }
  }

  std::vector<Place> place_;
  std::size_t tree_begin_ = 0, trees_ = 0;
  std::vector<std::int64_t> passing_;  ///< Per node.
  std::vector<std::vector<std::uint32_t>> places_;
  std::vector<std::uint32_t> open_;
};

class Labelling {
 public:
  Labelling(const CoreGraph& graph, std::size_t most_entries)
      : graph_(graph),
        is_telling_(is_telling(graph)),
        most_entries_(most_entries),
        search_(graph.out.size()),
        sample_(graph.out.size()),
        left_(graph.out.size()) {
    const std::size_t nodes = graph.out.size();
    labels_.hub_of_node.assign(nodes, none);
    labels_.leaving.resize(nodes);
    labels_.arriving.resize(nodes);
    for (std::uint32_t i = 0; i < nodes; ++i) left_[i] = i;
  }

  std::expected<CoreLabels, std::size_t> run(const std::stop_token& stop) {
    while (labels_.node_of_hub.size() < graph_.out.size()) {
      draw_sample();
      if (sample_.size() > 0)
        use_sample();
      else
        make_hub(left_.front());  // Cycles of no length: labels know all that is left.
      if (stop.stop_requested()) return std::unexpected(0);
      if (expected_ > most_entries_) return std::unexpected(expected_);
    }
    return std::move(labels_);
  }

 private:
  bool is_hub(std::uint32_t node) const noexcept { return labels_.hub_of_node[node] != none; }

  void draw_sample() {
    std::erase_if(left_, [&](std::uint32_t node) { return is_hub(node); });
    sample_.clear();
    const std::size_t enough = nodes_a_node * graph_.out.size();
    const std::size_t most = std::min(most_trees, left_.size());
    while (sample_.trees() < most && (sample_.trees() < least_trees || sample_.size() < enough)) {
      const std::uint32_t root = left_[random_.below(left_.size())];
      sample_.begin_tree();
      search_.run(root, graph_.out, labels_.leaving[root], labels_.arriving,
                  [&](std::uint32_t node, double, std::uint32_t parent, std::uint32_t) {
                    sample_.add(node, parent);
                  });
      sample_.end_tree();
    }
  }

  /// Makes hubs of the nodes that most ways of the sample pass.
  void use_sample() {
    using Turn = std::pair<std::int64_t, std::uint32_t>;
    std::priority_queue<Turn> queue;
    sample_.for_each_node([&](std::uint32_t node) {
      if (!is_hub(node)) queue.emplace(sample_.passing(node), node);
    });
    const std::int64_t first = queue.empty() ? 0 : queue.top().first;
    while (!queue.empty() && expected_ <= most_entries_) {
      const auto [passing, node] = queue.top();
      queue.pop();
      if (is_hub(node)) continue;
      const std::int64_t now = sample_.passing(node);
      if (now < passing) {
        queue.emplace(now, node);
        continue;
      }
      if (stale * now < first) return;
      make_hub(node);
      sample_.take_out(node);
    }
  }

  void make_hub(std::uint32_t node) {
    const auto hub = static_cast<std::uint32_t>(labels_.node_of_hub.size());
    labels_.node_of_hub.push_back(node);
    labels_.hub_of_node[node] = hub;
    const auto into = [&](CoreLabelList& labels) {
      return [this, hub, &labels](std::uint32_t reached, double length, std::uint32_t next,
                                  std::uint32_t link) {
        labels[reached].push_back({hub, next, link, length});
        ++entries_;
      };
    };
    // A copy: the first search puts the hub into its own label.
    const std::vector<CoreEntry> leaving = labels_.leaving[node];
    search_.run(node, graph_.in, labels_.arriving[node], labels_.leaving, into(labels_.leaving));
    search_.run(node, graph_.out, leaving, labels_.arriving, into(labels_.arriving));
    const bool tells = is_telling_ && hub + 1 == graph_.out.size() / telling_share;
    expected_ = std::max(expected_, entries_ * (tells ? telling_factor : 1));
  }

  const CoreGraph& graph_;
  bool is_telling_;
  std::size_t most_entries_, entries_ = 0;
  std::size_t expected_ = 0;  ///< There will be at least so many.
  PrunedSearch search_;
  Sample sample_;
  Random random_;
  std::vector<std::uint32_t> left_;  ///< No hubs yet, and some that are.
  CoreLabels labels_;
};

}  // namespace

const CoreEntry* CoreLabels::find(const std::vector<CoreEntry>& label, std::uint32_t hub) noexcept {
  const auto found = std::ranges::lower_bound(label, hub, {}, &CoreEntry::hub);
  return found == label.end() || found->hub != hub ? nullptr : &*found;
}

std::expected<CoreLabels, std::size_t> make_core_labels(const CoreGraph& graph,
                                                        std::size_t most_entries,
                                                        const std::stop_token& stop) {
  return Labelling(graph, most_entries).run(stop);
}

}  // namespace docent::path
