#include "runtime/path/shortest/make_hub_labels.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "runtime/model/none.h"
#include "runtime/path/shortest/contraction.h"

namespace docent::path {
namespace {

/// Nodes that would bring more arcs than this when they are contracted are left to the core: from
/// there on contraction costs more than labelling.
constexpr std::size_t most_added = 160;
/// A node of the core has at least so many entries in its labels: 76 to 220 in cores of 780 to
/// 18,000 nodes, and more of them in larger ones.
constexpr std::size_t least_entries_a_core_node = 60;

/// Cores of one floor's radii of 0, 0.25 and 0.27 m have numbers of entries that differ by 17 %.
constexpr double far_beyond = 1.2;

/// How far along a side's arc an angle is, in metres.
double roll_to(const TangentGraph& graph, std::uint32_t side, double angle) {
  const TangentArc& arc = graph.arc[side / 2];
  const double turned = side % 2 == 0 ? angle - arc.begin : arc.end - angle;
  return graph.radius * std::max(0.0, turned);
}
double roll_to_end(const TangentGraph& graph, std::uint32_t side, double angle) {
  const TangentArc& arc = graph.arc[side / 2];
  const double left = side % 2 == 0 ? arc.end - angle : angle - arc.begin;
  return graph.radius * std::max(0.0, left);
}

/// Ways of points: the nodes are the sides. Two tangents that do not turn a side's way make no
/// shortest way, so nothing need keep them from following each other.
std::vector<Link> links_between_sides(const TangentGraph& graph) {
  std::vector<Link> links;
  for (std::uint32_t side = 0; side + 1 < graph.side_first.size(); ++side)
    for (std::uint32_t k = graph.side_first[side]; k < graph.side_first[side + 1]; ++k)
      links.push_back({side, graph.tangent[k].arrive_side, graph.tangent[k].length, k});
  return links;
}

/// Ways of discs: the nodes are the tangents, "on the arc, about to leave by k or to roll on".
std::vector<Link> links_between_tangents(const TangentGraph& graph) {
  const auto roll = static_cast<std::uint32_t>(graph.tangent.size());
  std::vector<Link> links;
  for (std::uint32_t side = 0; side + 1 < graph.side_first.size(); ++side)
    for (std::uint32_t k = graph.side_first[side]; k < graph.side_first[side + 1]; ++k) {
      const Tangent& tangent = graph.tangent[k];
      if (tangent.onward != TangentGraph::no_tangent) {
        const Tangent& next = graph.tangent[tangent.onward];
        const double turn = roll_to(graph, tangent.arrive_side, next.leave_angle) -
                            roll_to(graph, tangent.arrive_side, tangent.arrive_angle);
        links.push_back({k, tangent.onward, tangent.length + std::max(0.0, turn), k});
      }
      if (k + 1 < graph.side_first[side + 1]) {
        const double turn = roll_to(graph, side, graph.tangent[k + 1].leave_angle) -
                            roll_to(graph, side, tangent.leave_angle);
        links.push_back({k, k + 1, std::max(0.0, turn), roll});
      }
    }
  return links;
}

/// Where a label's search begins, and by which link the way goes on from there.
struct Root {
  std::uint32_t node;
  double length;
  std::uint32_t link;
};

struct LabelEntry {
  std::uint32_t node, link, parent;
  double length;
};

/// The nodes that a station reaches by going up a hierarchy only, as far as the core.
class UpwardSearch {
 public:
  using Arcs = std::vector<std::vector<Hierarchy::Arc>>;

  /// `up` are the arcs to follow, `back` those that lead from above to a node.
  UpwardSearch(const Arcs& up, const Arcs& back)
      : up_(up), back_(back), length_(up.size(), infinity), from_(up.size()) {}

  /// Parents come before their children.
  const std::vector<LabelEntry>& run(const std::vector<Root>& roots) {
    entries_.clear();
    for (const Root& root : roots) reach(root.node, root.length, {root.link, none});
    while (!heap_.empty()) {
      std::ranges::pop_heap(heap_, std::greater<>{});
      const auto [length, node] = heap_.back();
      heap_.pop_back();
      if (length > length_[node] || is_stalled(node)) continue;
      const auto index = static_cast<std::uint32_t>(entries_.size());
      entries_.push_back({node, from_[node].first, from_[node].second, length});
      for (const Hierarchy::Arc& arc : up_[node])
        reach(arc.node, length + arc.length, {arc.link, index});
    }
    for (const std::uint32_t node : touched_) length_[node] = infinity;
    touched_.clear();
    return entries_;
  }

 private:
  void reach(std::uint32_t node, double length, std::pair<std::uint32_t, std::uint32_t> from) {
    if (length >= length_[node]) return;
    if (length_[node] == infinity) touched_.push_back(node);
    length_[node] = length;
    from_[node] = from;
    heap_.emplace_back(length, node);
    std::ranges::push_heap(heap_, std::greater<>{});
  }
  /// Is there a shorter way to the node, up and then down? Then its distance is not the true one.
  bool is_stalled(std::uint32_t node) const {
    return std::ranges::any_of(back_[node], [&](const Hierarchy::Arc& arc) {
      return length_[arc.node] + arc.length < length_[node];
    });
  }

  const Arcs& up_;
  const Arcs& back_;
  std::vector<double> length_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> from_;  ///< Link and parent.
  std::vector<std::uint32_t> touched_;
  std::vector<std::pair<double, std::uint32_t>> heap_;
  std::vector<LabelEntry> entries_;
};

/// Goes on from the core nodes of a label by their labels in the core: to the hubs that a shortest
/// way from the station passes, each by the hub before it.
class CoreSteps {
 public:
  using Labels = std::vector<std::vector<CoreLabels::Entry>>;

  /// `labels` lead from a node to hubs, `back` from hubs to a node. `is_forward` where a way leads
  /// in the direction of `labels`. New shortcuts are put into `hierarchy`.
  CoreSteps(Hierarchy& hierarchy, const CoreLabels& core, const Labels& labels, const Labels& back,
            bool is_forward)
      : hierarchy_(hierarchy),
        core_(core),
        labels_(labels),
        back_(back),
        is_forward_(is_forward),
        reached_(core.node_of_hub.size()),
        shortcut_(labels.size()),
        before_(labels.size()) {
    for (std::size_t node = 0; node < labels.size(); ++node) {
      shortcut_[node].assign(labels[node].size(), none);
      before_[node].assign(labels[node].size(), none);
    }
  }

  /// The label of a station whose upward search found `climbed`.
  std::vector<LabelEntry> run(const std::vector<LabelEntry>& climbed) {
    reach_hubs(climbed);
    std::vector<LabelEntry> label;
    place_.assign(climbed.size(), none);
    for (std::uint32_t i = 0; i < climbed.size(); ++i) {
      const std::uint32_t in_core = hierarchy_.in_core[climbed[i].node];
      if (in_core != none && reached_[core_.hub_of_node[in_core]].from != i) continue;
      place_[i] = static_cast<std::uint32_t>(label.size());
      label.push_back(climbed[i]);
      if (climbed[i].parent != none) label.back().parent = place_[climbed[i].parent];
    }
    // The least important first: a hub's way passes less important ones only.
    std::ranges::sort(hubs_, std::greater<>{});
    for (const std::uint32_t hub : hubs_) add_hub(hub, climbed, label);
    for (const std::uint32_t hub : hubs_) reached_[hub] = {};
    return label;
  }

 private:
  struct Reached {
    double length = infinity;
    std::uint32_t from = none;   ///< The entry of the upward search from which it is reached.
    std::uint32_t place = none;  ///< In the label.
    bool is_entered = false;     ///< The upward search came to it.
  };

  void reach_hubs(const std::vector<LabelEntry>& climbed) {
    hubs_.clear();
    for (std::uint32_t i = 0; i < climbed.size(); ++i) {
      const std::uint32_t node = hierarchy_.in_core[climbed[i].node];
      if (node == none) continue;
      // Whatever it leads to is reached in less by those before it.
      if (reached_[core_.hub_of_node[node]].length < climbed[i].length * (1 - same_length))
        continue;
      for (const CoreLabels::Entry& entry : labels_[node])
        reach(entry.hub, climbed[i].length + entry.length, i);
      reach(core_.hub_of_node[node], climbed[i].length, i);
      reached_[core_.hub_of_node[node]] = {climbed[i].length, i, none, true};
    }
    const auto kept = std::ranges::partition(
        hubs_, [&](std::uint32_t hub) { return reached_[hub].is_entered || is_shortest(hub); });
    for (const std::uint32_t hub : kept) reached_[hub] = {};
    hubs_.erase(kept.begin(), kept.end());
  }
  void reach(std::uint32_t hub, double length, std::uint32_t from) {
    Reached& reached = reached_[hub];
    if (length >= reached.length) return;
    if (reached.length == infinity) hubs_.push_back(hub);
    reached.length = length;
    reached.from = from;
  }
  /// Does no other hub lead there in less?
  bool is_shortest(std::uint32_t hub) const {
    const double least = reached_[hub].length * (1 - same_length);
    return std::ranges::none_of(back_[core_.node_of_hub[hub]], [&](const CoreLabels::Entry& entry) {
      return reached_[entry.hub].length + entry.length < least;
    });
  }

  void add_hub(std::uint32_t hub, const std::vector<LabelEntry>& climbed,
               std::vector<LabelEntry>& label) {
    Reached& reached = reached_[hub];
    const std::uint32_t start = hierarchy_.in_core[climbed[reached.from].node];
    const std::uint32_t goal = core_.node_of_hub[hub];
    if (start == goal) {
      reached.place = place_[reached.from];
      return;
    }
    // By the most important hub on the way. Where ways tie the label may lack it: then straight
    // from where the core is entered.
    std::uint32_t before = most_important_before(start, hub);
    std::uint32_t parent = reached_[core_.hub_of_node[before]].place;
    if (parent == none) {
      before = start;
      parent = place_[reached.from];
    }
    reached.place = static_cast<std::uint32_t>(label.size());
    label.push_back({hierarchy_.core[goal], link_between(before, hub), parent, reached.length});
  }

  /// Of the nodes on the way from a node to a hub of its label, without the hub.
  std::uint32_t most_important_before(std::uint32_t start, std::uint32_t hub) {
    const CoreLabels::Entry* entry = CoreLabels::find(labels_[start], hub);
    std::uint32_t& known = before_[start][static_cast<std::size_t>(entry - labels_[start].data())];
    if (known != none) return known;
    known = start;
    if (entry->next != core_.node_of_hub[hub]) {
      const std::uint32_t later = most_important_before(entry->next, hub);
      if (core_.hub_of_node[later] < core_.hub_of_node[start]) known = later;
    }
    return known;
  }

  /// The way from a node to a hub of its label as one link.
  std::uint32_t link_between(std::uint32_t node, std::uint32_t hub) {
    const CoreLabels::Entry* entry = CoreLabels::find(labels_[node], hub);
    std::uint32_t& known = shortcut_[node][static_cast<std::size_t>(entry - labels_[node].data())];
    if (known != none) return known;
    if (entry->next == core_.node_of_hub[hub]) return known = entry->link;
    const std::uint32_t rest = link_between(entry->next, hub);
    const auto index = static_cast<std::uint32_t>(hierarchy_.shortcut.size() / 2);
    const auto first = is_forward_ ? entry->link : rest, second = is_forward_ ? rest : entry->link;
    hierarchy_.shortcut.insert(hierarchy_.shortcut.end(), {first, second});
    return known = hierarchy_.first_shortcut + index;
  }

  Hierarchy& hierarchy_;
  const CoreLabels& core_;
  const Labels& labels_;
  const Labels& back_;
  bool is_forward_;
  std::vector<Reached> reached_;  ///< Per hub.
  std::vector<std::uint32_t> hubs_;
  std::vector<std::uint32_t> place_;  ///< In the label, of the upward search's entries.
  std::vector<std::vector<std::uint32_t>> shortcut_, before_;  ///< Per entry of the core's labels.
};

class Maker {
 public:
  Maker(const FloorPlan& plan, const TangentGraph& graph, Hierarchy hierarchy,
        const CoreLabels& core)
      : plan_(plan),
        graph_(graph),
        tangents_(static_cast<std::uint32_t>(graph.tangent.size())),
        hierarchy_(std::move(hierarchy)),
        core_(core) {}

  /// None where they would be too many.
  HubLabels make(std::size_t most_entries) {
    const auto stations = static_cast<std::uint32_t>(2 * graph_.arc.size());
    std::vector<std::vector<LabelEntry>> leaving(stations), arriving(stations);
    std::size_t made = 0;
    {
      UpwardSearch search(hierarchy_.up, hierarchy_.down);
      CoreSteps steps(hierarchy_, core_, core_.leaving, core_.arriving, true);
      for (std::uint32_t s = 0; s < stations && made <= most_entries; ++s) {
        leaving[s] = steps.run(search.run(leaving_roots(s)));
        made += leaving[s].size();
      }
    }
    UpwardSearch search(hierarchy_.down, hierarchy_.up);
    CoreSteps steps(hierarchy_, core_, core_.arriving, core_.leaving, false);
    const std::vector<std::vector<Root>> roots = arriving_roots();
    for (std::uint32_t s = 0; s < stations && made <= most_entries; ++s) {
      arriving[s] = steps.run(search.run(roots[s]));
      made += arriving[s].size();
    }
    if (made > most_entries) return {};

    HubLabels labels;
    double longest = diagonal(plan_);
    for (const auto* side : {&leaving, &arriving})
      for (const auto& entries : *side)
        for (const LabelEntry& entry : entries) longest = std::max(longest, entry.length);
    labels.unit = longest > 0 ? longest / HubLabels::most_cost : 1;
    number_hubs(leaving, arriving);
    labels.leaving = packed(leaving, labels.unit);
    labels.arriving = packed(arriving, labels.unit);
    for (const std::uint32_t part : hierarchy_.shortcut) labels.link_part.push_back(link(part));
    return labels;
  }

 private:
  std::vector<Root> leaving_roots(std::uint32_t station) const {
    if (graph_.radius == 0) return {{station, 0, tangents_}};
    const std::uint32_t first = graph_.side_first[station];
    if (first == graph_.side_first[station + 1]) return {};
    return {{first, roll_to(graph_, station, graph_.tangent[first].leave_angle), tangents_}};
  }
  std::vector<std::vector<Root>> arriving_roots() const {
    std::vector<std::vector<Root>> roots(2 * graph_.arc.size());
    if (graph_.radius == 0) {
      for (std::uint32_t s = 0; s < roots.size(); ++s) roots[s] = {{s, 0, tangents_}};
      return roots;
    }
    for (std::uint32_t k = 0; k < tangents_; ++k) {
      const Tangent& tangent = graph_.tangent[k];
      const double rest = roll_to_end(graph_, tangent.arrive_side, tangent.arrive_angle);
      roots[tangent.arrive_side].push_back({k, tangent.length + rest, k});
    }
    return roots;
  }

  /// Hubs are numbered from the most important one down, so that those in most labels lie together.
  void number_hubs(const std::vector<std::vector<LabelEntry>>& leaving,
                   const std::vector<std::vector<LabelEntry>>& arriving) {
    std::vector<std::uint32_t> hubs;
    std::vector<bool> is_hub(hierarchy_.rank.size(), false);
    for (const auto* side : {&leaving, &arriving})
      for (const auto& entries : *side)
        for (const LabelEntry& entry : entries)
          if (!is_hub[entry.node]) {
            is_hub[entry.node] = true;
            hubs.push_back(entry.node);
          }
    std::ranges::sort(hubs, std::greater<>{}, [&](std::uint32_t node) { return importance(node); });
    hub_.assign(hierarchy_.rank.size(), none);
    for (std::uint32_t i = 0; i < hubs.size(); ++i) hub_[hubs[i]] = i;
  }

  std::uint64_t importance(std::uint32_t node) const {
    const std::uint32_t in_core = hierarchy_.in_core[node];
    if (in_core == none) return hierarchy_.rank[node];
    return hierarchy_.rank.size() + core_.node_of_hub.size() - core_.hub_of_node[in_core];
  }

  std::uint32_t link(std::uint32_t name) const {
    if (name == tangents_) return HubLabels::roll;
    return name < tangents_ ? name : name - 1;
  }

  LabelTable packed(const std::vector<std::vector<LabelEntry>>& labels, double unit) const {
    LabelTable table;
    std::vector<std::uint32_t> order, place;
    for (const std::vector<LabelEntry>& entries : labels) {
      const auto first = table.first.back();
      order.resize(entries.size());
      place.resize(entries.size());
      for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
      std::ranges::sort(order, {}, [&](std::uint32_t i) { return hub_[entries[i].node]; });
      for (std::uint32_t i = 0; i < order.size(); ++i) place[order[i]] = first + i;
      for (const std::uint32_t i : order) {
        const LabelEntry& entry = entries[i];
        table.hub.push_back(
            {hub_[entry.node], static_cast<std::uint32_t>(std::llround(entry.length / unit))});
        table.link.push_back(link(entry.link));
        table.parent.push_back(entry.parent == none ? LabelTable::no_parent : place[entry.parent]);
      }
      table.first.push_back(static_cast<std::uint32_t>(table.hub.size()));
    }
    return table;
  }

  const FloorPlan& plan_;
  const TangentGraph& graph_;
  std::uint32_t tangents_;
  Hierarchy hierarchy_;
  const CoreLabels& core_;
  std::vector<std::uint32_t> hub_;
};

}  // namespace

MadeLabels try_hub_labels(const FloorPlan& plan, const TangentGraph& graph,
                          const std::stop_token& stop, std::size_t most_entries) {
  const auto tangents = static_cast<std::uint32_t>(graph.tangent.size());
  auto hierarchy =
      graph.radius == 0
          ? contract(static_cast<std::uint32_t>(2 * graph.arc.size()), links_between_sides(graph),
                     tangents + 1, most_added, stop)
          : contract(tangents, links_between_tangents(graph), tangents + 1, most_added, stop);
  if (!hierarchy) return {};
  const std::size_t most_in_core = most_entries / 2;
  const auto far_too_many = [&](std::size_t expected) {
    return static_cast<double>(expected) > far_beyond * static_cast<double>(most_in_core);
  };
  const std::size_t least = hierarchy->core.size() * least_entries_a_core_node;
  if (least > most_in_core) return {.labels = {}, .far_too_many = far_too_many(least)};
  const auto core = make_core_labels(hierarchy->core_graph, most_in_core, stop);
  if (!core) return {.labels = {}, .far_too_many = far_too_many(core.error())};
  return {.labels = Maker(plan, graph, std::move(*hierarchy), *core).make(most_entries)};
}

HubLabels make_hub_labels(const FloorPlan& plan, const TangentGraph& graph,
                          const std::stop_token& stop, std::size_t most_entries) {
  return try_hub_labels(plan, graph, stop, most_entries).labels;
}

}  // namespace docent::path
