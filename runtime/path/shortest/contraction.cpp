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

class Contraction {
 public:
  Contraction(std::uint32_t nodes, std::span<const Link> links, std::uint32_t names)
      : out_(nodes), in_(nodes), level_(nodes, 0), distance_(nodes, infinity) {
    hierarchy_.first_shortcut = names;
    hierarchy_.rank.assign(nodes, 0);
    hierarchy_.up.resize(nodes);
    hierarchy_.down.resize(nodes);
    for (const Link& link : links)
      if (link.from != link.to) connect(link.from, link.to, link.length, link.name);
  }

  std::optional<Hierarchy> run(std::uint64_t most_work, const std::stop_token& stop) {
    using Turn = std::pair<std::int64_t, std::uint32_t>;  // importance and node
    std::priority_queue<Turn, std::vector<Turn>, std::greater<>> queue;
    for (std::uint32_t node = 0; node < out_.size(); ++node) queue.emplace(importance(node), node);
    std::uint32_t rank = 0;
    while (!queue.empty()) {
      if (will_exceed(most_work, rank, out_.size() - rank) || stop.stop_requested()) return {};
      const auto [place, node] = queue.top();
      queue.pop();
      // What was contracted since may have made it more important: lazily found out here.
      const std::int64_t now = importance(node);
      if (!queue.empty() && now > queue.top().first) {
        queue.emplace(now, node);
        continue;
      }
      hierarchy_.rank[node] = rank++;
      remove(node);
    }
    return std::move(hierarchy_);
  }

 private:
  struct Shortcut {
    std::uint32_t from, to, first, second;
    double length;
  };

  /// Will it cost more, if the nodes that are left cost no less than those contracted last?
  bool will_exceed(std::uint64_t most_work, std::size_t contracted, std::size_t left) {
    constexpr std::uint64_t stretch = 25'000'000;
    if (work_ - stretch_begin_ >= stretch) {
      const std::uint64_t nodes = std::max<std::uint64_t>(contracted - stretch_contracted_, 1);
      expected_ = work_ + (work_ - stretch_begin_) / nodes * left;
      stretch_begin_ = work_;
      stretch_contracted_ = contracted;
    }
    return std::max(work_, expected_) > most_work;
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

  /// The ways through a node that have no other way round it that is as short.
  void find_shortcuts(std::uint32_t node) {
    found_.clear();
    for (const Arc& before : in_[node]) {
      double longest = 0;
      for (const Arc& after : out_[node]) longest = std::max(longest, before.length + after.length);
      search_round(before.node, node, longest);
      for (const Arc& after : out_[node]) {
        const double length = before.length + after.length;
        if (after.node != before.node && distance_[after.node] > length)
          found_.push_back({before.node, after.node, before.link, after.link, length});
      }
      for (const std::uint32_t seen : touched_) distance_[seen] = infinity;
    }
  }

  void search_round(std::uint32_t start, std::uint32_t avoided, double longest) {
    touched_.assign(1, start);
    distance_[start] = 0;
    heap_.assign(1, {0, start});
    for (std::size_t settled = 0; !heap_.empty() && settled < most_settled; ++settled) {
      std::ranges::pop_heap(heap_, std::greater<>{});
      const auto [length, node] = heap_.back();
      heap_.pop_back();
      if (length > longest) break;
      if (length > distance_[node]) continue;
      work_ += out_[node].size();
      for (const Arc& arc : out_[node]) {
        const double further = length + arc.length;
        if (arc.node == avoided || further > longest || further >= distance_[arc.node]) continue;
        if (distance_[arc.node] == infinity) touched_.push_back(arc.node);
        distance_[arc.node] = further;
        heap_.emplace_back(further, arc.node);
        std::ranges::push_heap(heap_, std::greater<>{});
      }
    }
  }

  void remove(std::uint32_t node) {
    find_shortcuts(node);
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
  std::vector<std::vector<Arc>> out_, in_;  ///< Of the nodes that are left.
  std::vector<std::int64_t> level_;
  std::vector<double> distance_;
  std::vector<std::uint32_t> touched_;
  std::vector<std::pair<double, std::uint32_t>> heap_;
  std::vector<Shortcut> found_;
  std::uint64_t work_ = 0, expected_ = 0;
  std::uint64_t stretch_begin_ = 0;  ///< The work done when the present stretch of it began.
  std::size_t stretch_contracted_ = 0;
};

}  // namespace

std::optional<Hierarchy> contract(std::uint32_t nodes, std::span<const Link> links,
                                  std::uint32_t names, std::uint64_t most_work,
                                  const std::stop_token& stop) {
  return Contraction(nodes, links, names).run(most_work, stop);
}

}  // namespace docent::path
