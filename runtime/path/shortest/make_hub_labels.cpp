#include "runtime/path/shortest/make_hub_labels.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "runtime/model/none.h"
#include "runtime/path/shortest/contraction.h"

namespace docent::path {
namespace {

/// What contraction may cost, in arcs looked at: museums take 2,000 to 9,000 a tangent, games' maps
/// 50 to 300, a lattice of 100 columns 12,000. A thousand million take about 12 s.
constexpr std::uint64_t base_work = 20'000'000, work_per_tangent = 20'000;
constexpr std::uint64_t most_work_in_all = 1'300'000'000;

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

/// The nodes are the tangents: "on the arc, about to leave by k or to roll on".
std::vector<Link> links_of(const TangentGraph& graph) {
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

struct Entry {
  std::uint32_t node, link, parent;
  double length;
};

/// The nodes that a station reaches by going up a hierarchy only, each with its true distance.
class UpwardSearch {
 public:
  using Arcs = std::vector<std::vector<Hierarchy::Arc>>;

  /// `up` are the arcs to follow, `back` those that lead from above to a node.
  UpwardSearch(const Arcs& up, const Arcs& back)
      : up_(up), back_(back), length_(up.size(), infinity), from_(up.size()) {}

  const std::vector<Entry>& run(const std::vector<Root>& roots) {
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
  std::vector<Entry> entries_;
};

/// Keeps the entries of a label whose length is that of the shortest way: the search upwards also
/// comes to nodes that a way over more important ones reaches sooner. What is kept keeps its
/// parents, because the way to them is a part of a shortest one.
class Pruning {
 public:
  using Arcs = std::vector<std::vector<Hierarchy::Arc>>;

  /// For labels of searches along `up`; `down` are the arcs of the other direction.
  Pruning(const Arcs& up, const Arcs& down)
      : search_(down, up), to_node_(up.size()), length_(up.size(), infinity) {}

  std::vector<Entry> exact(const std::vector<Entry>& label) {
    for (const Entry& entry : label) length_[entry.node] = entry.length;
    place_.assign(label.size(), none);
    std::vector<Entry> kept;
    for (std::uint32_t i = 0; i < label.size(); ++i) {
      Entry entry = label[i];
      if (shortest_to(entry.node) < entry.length * (1 - rounding)) continue;
      place_[i] = static_cast<std::uint32_t>(kept.size());
      if (entry.parent != none) entry.parent = place_[entry.parent];
      kept.push_back(entry);
    }
    for (const Entry& entry : label) length_[entry.node] = infinity;
    kept.shrink_to_fit();
    return kept;
  }

 private:
  static constexpr double rounding = 1e-12;

  /// The length of the shortest way to a node that goes over any hub of the label.
  double shortest_to(std::uint32_t node) {
    Hubs& hubs = to_node_[node];
    if (hubs.node.empty()) {
      const std::vector<Entry>& found = search_.run({{node, 0, none}});
      hubs.node.reserve(found.size());
      hubs.length.reserve(found.size());
      for (const Entry& entry : found) {
        hubs.node.push_back(entry.node);
        hubs.length.push_back(entry.length);
      }
    }
    double shortest = infinity;
    for (std::size_t i = 0; i < hubs.node.size(); ++i)
      shortest = std::min(shortest, length_[hubs.node[i]] + hubs.length[i]);
    return shortest;
  }

  /// By themselves, because there are many million of them.
  struct Hubs {
    std::vector<std::uint32_t> node;
    std::vector<double> length;
  };
  UpwardSearch search_;
  std::vector<Hubs> to_node_;  ///< Made when asked for.
  std::vector<double> length_;
  std::vector<std::uint32_t> place_;
};

class Maker {
 public:
  Maker(const FloorPlan& plan, const TangentGraph& graph, Hierarchy hierarchy)
      : plan_(plan),
        graph_(graph),
        tangents_(static_cast<std::uint32_t>(graph.tangent.size())),
        hierarchy_(std::move(hierarchy)) {}

  HubLabels make() {
    const auto stations = static_cast<std::uint32_t>(2 * graph_.arc.size());
    std::vector<std::vector<Entry>> leaving(stations), arriving(stations);
    UpwardSearch forward(hierarchy_.up, hierarchy_.down);
    {
      Pruning pruning(hierarchy_.up, hierarchy_.down);
      for (std::uint32_t s = 0; s < stations; ++s)
        leaving[s] = pruning.exact(forward.run(leaving_roots(s)));
    }
    UpwardSearch backward(hierarchy_.down, hierarchy_.up);
    const std::vector<std::vector<Root>> roots = arriving_roots();
    Pruning pruning(hierarchy_.down, hierarchy_.up);
    for (std::uint32_t s = 0; s < stations; ++s)
      arriving[s] = pruning.exact(backward.run(roots[s]));

    HubLabels labels;
    double longest = diagonal(plan_);
    for (const auto* side : {&leaving, &arriving})
      for (const auto& entries : *side)
        for (const Entry& entry : entries) longest = std::max(longest, entry.length);
    labels.unit = longest > 0 ? longest / HubLabels::most_cost : 1;
    number_hubs(leaving, arriving);
    labels.leaving = packed(leaving, labels.unit);
    labels.arriving = packed(arriving, labels.unit);
    for (const std::uint32_t part : hierarchy_.shortcut) labels.link_part.push_back(link(part));
    return labels;
  }

 private:
  std::vector<Root> leaving_roots(std::uint32_t station) const {
    const std::uint32_t first = graph_.side_first[station];
    if (first == graph_.side_first[station + 1]) return {};
    return {{first, roll_to(graph_, station, graph_.tangent[first].leave_angle), tangents_}};
  }
  std::vector<std::vector<Root>> arriving_roots() const {
    std::vector<std::vector<Root>> roots(2 * graph_.arc.size());
    for (std::uint32_t k = 0; k < tangents_; ++k) {
      const Tangent& tangent = graph_.tangent[k];
      const double rest = roll_to_end(graph_, tangent.arrive_side, tangent.arrive_angle);
      roots[tangent.arrive_side].push_back({k, tangent.length + rest, k});
    }
    return roots;
  }

  /// Hubs are numbered from the most important one down, so that those in most labels lie together.
  void number_hubs(const std::vector<std::vector<Entry>>& leaving,
                   const std::vector<std::vector<Entry>>& arriving) {
    std::vector<std::uint32_t> hubs;
    std::vector<bool> is_hub(tangents_, false);
    for (const auto* side : {&leaving, &arriving})
      for (const auto& entries : *side)
        for (const Entry& entry : entries)
          if (!is_hub[entry.node]) {
            is_hub[entry.node] = true;
            hubs.push_back(entry.node);
          }
    std::ranges::sort(hubs, std::greater<>{},
                      [&](std::uint32_t node) { return hierarchy_.rank[node]; });
    hub_.assign(tangents_, none);
    for (std::uint32_t i = 0; i < hubs.size(); ++i) hub_[hubs[i]] = i;
  }

  std::uint32_t link(std::uint32_t name) const {
    if (name == tangents_) return HubLabels::roll;
    return name < tangents_ ? name : name - 1;
  }

  LabelTable packed(const std::vector<std::vector<Entry>>& labels, double unit) const {
    LabelTable table;
    std::vector<std::uint32_t> order, place;
    for (const std::vector<Entry>& entries : labels) {
      const auto first = table.first.back();
      order.resize(entries.size());
      place.resize(entries.size());
      for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
      std::ranges::sort(order, {}, [&](std::uint32_t i) { return hub_[entries[i].node]; });
      for (std::uint32_t i = 0; i < order.size(); ++i) place[order[i]] = first + i;
      for (const std::uint32_t i : order) {
        const Entry& entry = entries[i];
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
  std::vector<std::uint32_t> hub_;
};

}  // namespace

HubLabels make_hub_labels(const FloorPlan& plan, const TangentGraph& graph,
                          const std::stop_token& stop) {
  const auto tangents = static_cast<std::uint32_t>(graph.tangent.size());
  const std::uint64_t most_work =
      std::min(base_work + work_per_tangent * graph.tangent.size(), most_work_in_all);
  auto hierarchy = contract(tangents, links_of(graph), tangents + 1, most_work, stop);
  if (!hierarchy) return {};
  return Maker(plan, graph, std::move(*hierarchy)).make();
}

}  // namespace docent::path
