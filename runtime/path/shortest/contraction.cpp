#include "runtime/path/shortest/contraction.h"

#include <algorithm>
#include <queue>
#include <utility>

#include "runtime/model/none.h"

namespace docent::path {
namespace {

using Arc = Hierarchy::Arc;
/// How many nodes a search for a way round a node settles before it gives up and a shortcut is laid
/// that may not be needed. More makes fewer shortcuts and costs time.
constexpr std::size_t most_settled = 64;

/// Graphs that need more are too dense to have short labels, and their arcs would fill the memory.
constexpr std::size_t most_shortcuts = 6'000'000;

class Contraction {
 public:
  Contraction(std::uint32_t nodes, std::span<const Link> links, std::uint32_t names,
              std::size_t most_added)
      : most_added_(most_added),
        out_(nodes),
        in_(nodes),
        level_(nodes, 0),
        distance_(nodes, infinity),
        limit_(nodes, witnessed) {
    hierarchy_.first_shortcut = names;
    hierarchy_.rank.assign(nodes, 0);
    hierarchy_.up.resize(nodes);
    hierarchy_.down.resize(nodes);
    for (const Link& link : links)
      if (link.from != link.to) connect(link.from, link.to, link.length, link.name);
  }

  std::optional<Hierarchy> run(const std::stop_token& stop) {
    using Turn = std::pair<std::int64_t, std::uint32_t>;  // importance and node
    std::priority_queue<Turn, std::vector<Turn>, std::greater<>> queue;
    for (std::uint32_t node = 0; node < out_.size(); ++node) queue.emplace(importance(node), node);
    std::uint32_t rank = 0;
    while (!queue.empty()) {
      if (stop.stop_requested() || hierarchy_.shortcut.size() / 2 > most_shortcuts) return {};
      const auto [place, node] = queue.top();
      queue.pop();
      // What was contracted since may have made it more important: lazily found out here.
      const std::int64_t now = importance(node);
      if (!queue.empty() && now > queue.top().first) {
        queue.emplace(now, node);
        continue;
      }
      if (found_.size() > most_added_) {
        queue.emplace(now, node);
        break;
      }
      hierarchy_.rank[node] = rank++;
      remove(node);
    }
    for (; !queue.empty(); queue.pop()) hierarchy_.core.push_back(queue.top().second);
    keep_core(rank);
    return std::move(hierarchy_);
  }

 private:
  struct Shortcut {
    std::uint32_t from, to, first, second;
    double length;
  };

  void keep_core(std::uint32_t rank) {
    std::ranges::sort(hierarchy_.core);
    hierarchy_.in_core.assign(out_.size(), none);
    for (std::uint32_t i = 0; i < hierarchy_.core.size(); ++i) {
      hierarchy_.in_core[hierarchy_.core[i]] = i;
      hierarchy_.rank[hierarchy_.core[i]] = rank;
    }
    const auto kept = [&](std::vector<Arc>& arcs) {
      for (Arc& arc : arcs) arc.node = hierarchy_.in_core[arc.node];
      return std::move(arcs);
    };
    for (const std::uint32_t node : hierarchy_.core) {
      hierarchy_.core_graph.out.push_back(kept(out_[node]));
      hierarchy_.core_graph.in.push_back(kept(in_[node]));
    }
  }

  void connect(std::uint32_t from, std::uint32_t to, double length, std::uint32_t link) {
    const auto keep_shorter = [=](std::vector<Arc>& arcs, std::uint32_t node) {
      for (Arc& arc : arcs)
        if (arc.node == node) {
          if (length < arc.length) arc = {node, link, length};
          return;
        }
      arcs.push_back({node, link, length});
    };
    keep_shorter(out_[from], to);
    keep_shorter(in_[to], from);
  }

  /// Few shortcuts for many arcs that go, and evenly over the graph: the weights give the shortest
  /// labels on the reference maps.
  std::int64_t importance(std::uint32_t node) {
    find_shortcuts(node);
    const auto added = static_cast<std::int64_t>(found_.size());
    const auto removed = static_cast<std::int64_t>(out_[node].size() + in_[node].size());
    return added - removed + 2 * level_[node];
  }

  /// The ways through a node that have no other way round it that is as short; not all where they
  /// are too many. Searched from the side on which fewer arcs end: a tangent has two exits and may
  /// have many arrivals.
  void find_shortcuts(std::uint32_t node) {
    found_.clear();
    const bool backward = out_[node].size() < in_[node].size();
    const auto& starts = backward ? out_[node] : in_[node];
    const auto& ends = backward ? in_[node] : out_[node];
    for (const Arc& start : starts) {
      if (found_.size() > most_added_) return;
      search_round(start, node, ends, backward ? in_ : out_);
      for (const Arc& end : ends) {
        if (limit_[end.node] != needed(start, end)) continue;
        const Arc& before = backward ? end : start;
        const Arc& after = backward ? start : end;
        found_.push_back({before.node, after.node, before.link, after.link, needed(start, end)});
      }
      for (const Arc& end : ends) limit_[end.node] = witnessed;
      for (const std::uint32_t seen : touched_) distance_[seen] = infinity;
    }
  }
  static double needed(const Arc& start, const Arc& end) noexcept {
    return start.length + end.length;
  }

  /// Takes the limit from each end that another way reaches which is as short as that by `avoided`.
  void search_round(const Arc& start, std::uint32_t avoided, const std::vector<Arc>& ends,
                    const std::vector<std::vector<Arc>>& arcs) {
    double longest = 0;
    std::size_t open = 0;
    for (const Arc& end : ends) {
      if (end.node == start.node) continue;
      limit_[end.node] = needed(start, end);
      longest = std::max(longest, limit_[end.node]);
      ++open;
    }
    touched_.assign(1, start.node);
    distance_[start.node] = 0;
    heap_.assign(1, {0, start.node});
    for (std::size_t settled = 0; open > 0 && !heap_.empty() && settled < most_settled; ++settled) {
      std::ranges::pop_heap(heap_, std::greater<>{});
      const auto [length, node] = heap_.back();
      heap_.pop_back();
      if (length > longest) break;
      if (length > distance_[node]) continue;
      for (const Arc& arc : arcs[node]) {
        const double further = length + arc.length;
        if (arc.node == avoided || further > longest || further >= distance_[arc.node]) continue;
        if (distance_[arc.node] == infinity) touched_.push_back(arc.node);
        distance_[arc.node] = further;
        if (further <= limit_[arc.node]) {
          limit_[arc.node] = witnessed;
          if (--open == 0) return;
        }
        heap_.emplace_back(further, arc.node);
        std::ranges::push_heap(heap_, std::greater<>{});
      }
    }
  }

  /// Right after its importance was told, which has found the shortcuts.
  void remove(std::uint32_t node) {
    for (const Shortcut& s : found_) {
      const auto index = static_cast<std::uint32_t>(hierarchy_.shortcut.size() / 2);
      hierarchy_.shortcut.insert(hierarchy_.shortcut.end(), {s.first, s.second});
      connect(s.from, s.to, s.length, hierarchy_.first_shortcut + index);
    }
    const auto forget = [&](std::vector<Arc>& arcs, std::uint32_t other) {
      std::erase_if(arcs, [=](const Arc& arc) { return arc.node == node; });
      level_[other] = std::max(level_[other], level_[node] + 1);
    };
    for (const Arc& arc : out_[node]) forget(in_[arc.node], arc.node);
    for (const Arc& arc : in_[node]) forget(out_[arc.node], arc.node);
    hierarchy_.up[node] = std::exchange(out_[node], {});
    hierarchy_.down[node] = std::exchange(in_[node], {});
  }

  Hierarchy hierarchy_;
  std::size_t most_added_;
  std::vector<std::vector<Arc>> out_, in_;  ///< Of the nodes that are left.
  std::vector<std::int64_t> level_;
  std::vector<double> distance_;
  static constexpr double witnessed = -1;
  std::vector<double> limit_;  ///< How long a way to an end may be to make a shortcut needless.
  std::vector<std::uint32_t> touched_;
  std::vector<std::pair<double, std::uint32_t>> heap_;
  std::vector<Shortcut> found_;
};

}  // namespace

std::optional<Hierarchy> contract(std::uint32_t nodes, std::span<const Link> links,
                                  std::uint32_t names, std::size_t most_added,
                                  const std::stop_token& stop) {
  return Contraction(nodes, links, names, most_added).run(stop);
}

}  // namespace docent::path
