#include "content/motion/prune.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace docent::motion::offline {
namespace {

using Node = std::size_t;

/// Every frame of every clip is a node. From it one goes on to the next frame, or leaves by a
/// transition that begins there.
struct FrameGraph {
  std::vector<Node> first;  ///< Of each clip, and the number of all nodes.
  std::vector<std::vector<Node>> onward;

  Node node(std::size_t clip, std::size_t frame) const { return first[clip] + frame; }
};

Node leaves_at(const FrameGraph& frames, const Transition& t) {
  return frames.node(t.from.clip, t.from.frame - t.radius);
}

Node arrives_at(const FrameGraph& frames, const Transition& t) {
  return frames.node(t.to.clip, t.to.frame + t.radius);
}

FrameGraph make_frame_graph(const MotionGraph& graph, const std::vector<bool>& counts) {
  FrameGraph frames;
  frames.first.push_back(0);
  for (const MotionClip& clip : graph.clips)
    frames.first.push_back(frames.first.back() + frame_count(clip));
  frames.onward.resize(frames.first.back());
  for (std::size_t c = 0; c < graph.clips.size(); ++c)
    for (Node n = frames.first[c]; n + 1 < frames.first[c + 1]; ++n)
      frames.onward[n].push_back(n + 1);
  for (std::size_t t = 0; t < graph.transitions.size(); ++t)
    if (counts[t])
      frames.onward[leaves_at(frames, graph.transitions[t])].push_back(
          arrives_at(frames, graph.transitions[t]));
  return frames;
}

/// Numbers the strongly connected components (Tarjan 1972, with a stack of its own instead of
/// recursion, because a component can be as deep as all clips are long).
std::vector<std::size_t> number_components(const std::vector<std::vector<Node>>& onward) {
  constexpr std::size_t unseen = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> order(onward.size(), unseen), low(onward.size()), next(onward.size()),
      component(onward.size(), unseen);
  std::vector<Node> path, open;
  std::size_t seen = 0, components = 0;
  const auto enter = [&](Node n) {
    order[n] = low[n] = seen++;
    path.push_back(n);
    open.push_back(n);
  };
  for (Node root = 0; root < onward.size(); ++root) {
    if (order[root] != unseen) continue;
    enter(root);
    while (!path.empty()) {
      const Node n = path.back();
      if (next[n] < onward[n].size()) {
        const Node to = onward[n][next[n]++];
        if (order[to] == unseen)
          enter(to);
        else if (component[to] == unseen)
          low[n] = std::min(low[n], order[to]);
        continue;
      }
      path.pop_back();
      if (!path.empty()) low[path.back()] = std::min(low[path.back()], low[n]);
      if (low[n] != order[n]) continue;
      for (Node member = unseen; member != n; open.pop_back()) {
        member = open.back();
        component[member] = components;
      }
      ++components;
    }
  }
  return component;
}

/// Marks the nodes of the component with the most frames; of equal ones the first found.
std::vector<bool> largest_component(const std::vector<std::size_t>& component) {
  std::vector<std::size_t> size(component.size());
  for (const std::size_t c : component) ++size[c];
  const auto largest = static_cast<std::size_t>(std::ranges::max_element(size) - size.begin());
  std::vector<bool> inside(component.size());
  for (Node n = 0; n < component.size(); ++n) inside[n] = component[n] == largest;
  return inside;
}

void mark_reachable(const std::vector<std::vector<Node>>& onward, std::vector<Node> from,
                    std::vector<bool>& marked) {
  while (!from.empty()) {
    const Node n = from.back();
    from.pop_back();
    if (marked[n]) continue;
    marked[n] = true;
    from.insert(from.end(), onward[n].begin(), onward[n].end());
  }
}

std::vector<std::vector<Node>> reversed(const std::vector<std::vector<Node>>& onward) {
  std::vector<std::vector<Node>> back(onward.size());
  for (Node n = 0; n < onward.size(); ++n)
    for (const Node to : onward[n]) back[to].push_back(n);
  return back;
}

std::vector<Node> members(const std::vector<bool>& marked) {
  std::vector<Node> nodes;
  for (Node n = 0; n < marked.size(); ++n)
    if (marked[n]) nodes.push_back(n);
  return nodes;
}

/// Of the transitions that count, which ones never lead into a dead end.
std::vector<bool> without_dead_ends(const MotionGraph& graph, const std::vector<bool>& counts) {
  const FrameGraph frames = make_frame_graph(graph, counts);
  std::vector<bool> kept(graph.transitions.size());
  if (std::ranges::find(counts, true) == counts.end()) return kept;
  const std::vector<bool> core = largest_component(number_components(frames.onward));
  std::vector<bool> leads_in(core.size());
  mark_reachable(reversed(frames.onward), members(core), leads_in);
  std::vector<bool> from_start(core.size());
  for (std::size_t c = 0; c < graph.clips.size(); ++c)
    if (graph.clips[c].role == ClipRole::Start)
      mark_reachable(frames.onward, {frames.first[c]}, from_start);
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const Transition& t = graph.transitions[i];
    const Node leaves = leaves_at(frames, t), arrives = arrives_at(frames, t);
    const bool to_stop = graph.clips[t.to.clip].role == ClipRole::Stop;
    kept[i] = counts[i] && ((core[leaves] && (core[arrives] || to_stop)) ||
                            (from_start[leaves] && leads_in[arrives]));
  }
  return kept;
}

}  // namespace

Pruning prune(MotionGraph& graph) {
  const std::vector<bool> kept =
      without_dead_ends(graph, std::vector<bool>(graph.transitions.size(), true));
  Pruning pruning;
  std::vector<Transition> transitions;
  for (std::size_t t = 0; t < kept.size(); ++t)
    if (kept[t]) transitions.push_back(graph.transitions[t]);
  pruning.transitions_dropped = kept.size() - transitions.size();
  graph.transitions = std::move(transitions);

  std::vector<bool> used(graph.clips.size());
  for (const Transition& t : graph.transitions) used[t.from.clip] = used[t.to.clip] = true;
  for (std::size_t c = 0; c < used.size(); ++c)
    if (!used[c]) pruning.clips_outside.push_back(c);
  return pruning;
}

std::vector<std::uint32_t> own_graph(const MotionGraph& graph, const std::string& motion_class) {
  const auto is_own = [&](const ClipFrame& frame) {
    return graph.clips[frame.clip].motion_class == motion_class;
  };
  std::vector<bool> counts;
  for (const Transition& t : graph.transitions) counts.push_back(is_own(t.from) && is_own(t.to));
  const std::vector<bool> kept = without_dead_ends(graph, counts);
  std::vector<std::uint32_t> own;
  for (std::uint32_t t = 0; t < kept.size(); ++t)
    if (kept[t]) own.push_back(t);
  return own;
}

}  // namespace docent::motion::offline
